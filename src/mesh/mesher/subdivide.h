// Subdivides leaves whose error indicators exceed the tolerances, generation by generation, and
// searches their sides for the features that halving alone cannot resolve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/limits.h"
#include "mesh/model/counterexample.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
struct Grid;

class Oscillation;

/// When a subdivision ends: once no leaf is active; one generation after the first pole was found
/// (CellTree::has_poles()); or after one generation.
enum class Until : std::uint8_t { Done, Poles, OneGeneration };

struct SubdivisionGoal {
  Until until;
  TriangleLimit triangles;  ///< no leaf is halved beyond it
};

struct Subdivision {
  std::vector<Leaf> leaves;         ///< in an order that is always the same
  std::vector<Leaf> empty;          ///< the surface is defined at none of their samples
  bool reached_limit = false;       ///< the limit of triangles stopped it
  bool has_forgotten = false;       ///< leaves may have their corners alone as samples
  std::optional<dvec2> oscillates;  ///< a place where an oscillation stopped it
};

/// Leaves to be subdivided, and counterexamples against them: `cell` is the index of a leaf. In a
/// leaf without defined samples a counterexample is a place where the surface is defined.
struct ActiveLeaves {
  std::vector<Leaf> leaves;
  std::vector<Counterexample> counterexamples;
  bool are_roots = false;  ///< all cells of the root grid, which are not listed
};

/// Halves active leaves in one direction at a time, until each one passes its error indicator and
/// its counterexamples, or halving does not help. `known_oscillation`: of leaves that are not
/// active. If more leaves than CellLimits::leaves_at_a_time are active, which are all that the mesh
/// has, those that pass keep their corners alone.
Subdivision subdivide(ActiveLeaves active, Oscillation known_oscillation, const CellLimits& limits,
                      const SubdivisionGoal& goal, const Grid& grid, CellTree& tree);

}  // namespace saddle
