// Halves the cells of a grid where the mesh would be farther from the surface than allowed.
#pragma once

#include <algorithm>
#include <array>
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

/// When a subdivision ends: once all leaves pass, one generation after the first pole was found
/// (CellTree::has_poles()), or after one generation.
enum class Until : std::uint8_t { Done, Poles, OneGeneration };

struct SubdivisionGoal {
  Until until;
  std::size_t max_triangles;  ///< no leaf is halved that would give the mesh more
};

struct Subdivision {
  std::vector<Leaf> leaves;         ///< in no order but always the same
  std::vector<Leaf> empty;          ///< the surface is defined at none of their samples
  bool reached_limit = false;       ///< max_triangles stopped it
  std::optional<dvec2> oscillates;  ///< a place at which an Oscillation stopped it
};

/// Halves leaves, one direction at a time, generation by generation, until each one passes the
/// tests at the middles of its sides and at its centre and is near enough to the counterexamples
/// against it, whose `cell` is the index of an active leaf, or halving does not help. Against a
/// leaf that is defined nowhere, a counterexample is a place where it is. `known`: among leaves
/// that are not active.
Subdivision subdivide(std::span<const Leaf> active, std::span<const Counterexample> counterexamples,
                      Oscillation known, const RefineOptions& limits, const SubdivisionGoal& goal,
                      const Grid& grid, CellTree& tree);

/// Whether a vertex in use around a leaf is defined.
bool has_defined_corner(const Leaf& leaf, const CellTree& tree);

/// The cells of the root grid.
std::vector<Leaf> root_leaves(const Grid& grid);

/// The two halves of a leaf whose samples are known; their new corners go into use. Nothing if it
/// is a unit wide.
std::optional<std::array<Leaf, 2>> halve(const Leaf& leaf, bool across_u, CellTree& tree);

}  // namespace saddle
