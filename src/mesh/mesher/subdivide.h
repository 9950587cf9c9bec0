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
  std::optional<dvec2> oscillates;  ///< a place where an oscillation stopped it
};

/// Halves active leaves in one direction at a time, until each one passes its error indicator and
/// its counterexamples, or halving does not help. A counterexample's `cell` is the index of an
/// active leaf; in a leaf without defined samples it is a place where the surface is defined.
/// `known_oscillation`: of leaves that are not active.
Subdivision subdivide(std::span<const Leaf> active, std::span<const Counterexample> counterexamples,
                      Oscillation known_oscillation, const CellLimits& limits,
                      const SubdivisionGoal& goal, const Grid& grid, CellTree& tree);

}  // namespace saddle
