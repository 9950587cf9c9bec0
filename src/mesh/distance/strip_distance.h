// Distances of a mesh from thin strips and gaps of a surface, which enter a leaf through its sides.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/proof/continuity.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// A distance that was found at the leaf of some number, in units of length.
struct LeafDistance {
  std::size_t leaf;
  double distance;
  bool is_at_jump = false;
  std::optional<dvec2> uv = {};  ///< the place, if it is one of the surface
};

class StripDistance {
 public:
  /// Errors outside of `clip` do not count.
  StripDistance(const Surface& surface, const Grid& grid, const CellTree& tree,
                const std::optional<Bounds>& clip, unsigned threads)
      : surface_(surface), grid_(grid), tree_(tree), clip_(clip), threads_(threads) {}

  /// Adds lines across a thin strip or gap in a leaf. False for leaves that have none, or several,
  /// or one that is thin at one end alone: their edges are measured as others are, too.
  bool add(const Leaf& leaf, std::size_t number, std::span<const Triangle> triangles,
           double allowed);
  /// Distances at the leaves that were added; several for some.
  std::vector<LeafDistance> measure();

  std::size_t evaluations() const { return evaluations_; }

 private:
  /// A line across a leaf that may cross a strip on which alone the surface is defined, or a gap.
  struct Across {
    std::size_t leaf;
    std::span<const Triangle> triangles;
    Line line;
    bool is_gap;
    std::vector<std::uint32_t> ends;                  ///< where the strip or gap enters the leaf
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< of the mesh, in the leaf
    double at_least;                                  ///< the distance if nothing is crossed
    std::optional<dvec2> inside = {};                 ///< a place of the strip or gap on the line
  };
  /// A strip or gap that enters a leaf through one side and ends in it.
  struct Tip {
    Across across;
    Line side;
    dvec2 depth;         ///< from that side to the opposite one
    double reached = 0;  ///< in depths
  };
  void find_inside(std::span<Across> across);
  void follow_to_tips();
  std::vector<std::uint32_t> thin_ends(const Leaf& leaf, bool& is_gap) const;
  double from_edges(const Across& across, const dvec3& p) const;
  double distance_across_gap(const Across& across, std::span<const SurfacePoint> points) const;
  void add_distances_on_strip(const Across& across, std::span<const dvec2> uv,
                              std::span<const SurfacePoint> points,
                              std::vector<LeafDistance>& found) const;

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  std::vector<Across> across_;
  std::vector<Tip> tips_;
  std::vector<LeafDistance> found_;  ///< at leaves that several strips enter
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
