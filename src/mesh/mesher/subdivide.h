// Halves the cells of a grid where the mesh would be farther from the surface than allowed.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/sizing/probe.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

/// A leaf that is no larger than so many tolerances is smaller than what may be missing: nobody
/// looks for jumps and folds in it.
inline constexpr double kVisible = 2;

/// How normals turn along what is no longer than so many tolerances, a pixel of a picture, does not
/// matter, nor across what is no thicker. At a point where sheets meet they turn however often a
/// leaf is halved, and at the shoulder of a front within a width that no picture shows. Of waves
/// that are five pixels long a picture shows no more with half as much.
inline constexpr double kSeenTurn = 2;

/// An angle between normals but for their signs: across a cusp the normal jumps to its opposite
/// while the tangent plane goes on, and no halving mends that.
inline double turn_of_line(double degrees) {
  return std::min(degrees, 180 - degrees);
}

/// When nothing more is wanted: once all leaves pass, after the generation past the one that finds
/// poles (CellTree::has_poles()), or after one.
enum class Until : std::uint8_t { Done, Poles, OneGeneration };

/// What a mesh is to keep.
struct RefineOptions {
  Tolerance tolerance;
  double normal_tolerance = 180;  ///< degrees between interpolated and exact normals
  std::size_t max_triangles = 4'000'000;
  std::optional<Bounds> clip = {};  ///< what is outside of it does not matter
  std::vector<std::uint8_t> seen_u,
      seen_v;  ///< the grid's lines that are drawn or the domain's ends
  Until until = Until::Done;
  unsigned threads = 0;
  double share = 1e-3;  ///< the tolerance as a share of the surface's diagonal
};

/// Triangles up to which leaves are halved for their normals alone: half as many as a picture of
/// 800 x 600 has pixels, or a share of those that are allowed if that is more.
inline std::size_t allowed_for_normals(std::size_t max_triangles) {
  constexpr std::size_t kEnough = 250'000;
  constexpr std::size_t kShare = 16;
  return std::min(max_triangles, std::max(kEnough, max_triangles / kShare));
}

class Oscillation;

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
                      Oscillation known, const RefineOptions& options, const Grid& grid,
                      CellTree& tree);

/// Whether a vertex in use around a leaf is defined.
bool has_defined_corner(const Leaf& leaf, const CellTree& tree);

/// The cells of the root grid.
std::vector<Leaf> root_leaves(const Grid& grid);

/// The two halves of a leaf whose samples are known; their new corners go into use. Nothing if it
/// is a unit wide.
std::optional<std::array<Leaf, 2>> halve(const Leaf& leaf, bool across_u, CellTree& tree);

}  // namespace saddle
