// Parts of a surface that stick out of its mesh at an edge: of the domain, a rim or a jump. At the
// top of a wave the surface turns back along its edge, and rises beyond the end of a steep chord.
// The part beyond is near the chord's line and the plane of its triangle, but the mesh ends before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/strip_distance.h"
#include "mesh/grid/grid.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

class EdgeTurns {
 public:
  /// Places outside of `clip`, which must outlive this, have no distance.
  EdgeTurns(const Surface& surface, const Grid& grid, const std::optional<Bounds>& clip,
            unsigned threads)
      : surface_(surface), grid_(grid), clip_(clip), threads_(threads) {}

  /// Adds the sides of a leaf's triangles that are on the edge of the domain. The triangles must
  /// outlive this. `allowed`: smaller distances do not matter.
  void add_sides(std::size_t leaf, std::span<const Triangle> triangles, double allowed);
  /// Adds the chords of a rim or a jump: the ends of sides of a leaf's triangles, with the corners
  /// opposite. The triangles must outlive this. Skips chords along faces of the clip box, and more
  /// than the two that a line has: turns say nothing of waves.
  void add_chords(std::size_t leaf, std::span<const Triangle> triangles,
                  std::span<const std::array<std::uint32_t, 3>> corners, double allowed);

  /// Larger distances than allowed, of places that are farthest beyond the ends of chords. A gap of
  /// less than `delta` is no jump.
  std::vector<LeafDistance> measure(double delta);

  std::size_t evaluations() const { return evaluations_; }

 private:
  /// A chord, seen from the first of its ends: each is there twice.
  struct Side {
    std::size_t leaf;
    std::span<const Triangle> triangles;
    double allowed;
    std::array<std::uint32_t, 2> ends;
    std::optional<std::uint32_t> opposite;  ///< the triangle's corner; none on the domain's edge
    dvec2 turn = dvec2(0);                  ///< where the surface turns back
  };
  Line line_of(const Side& side) const {
    return {grid_.mesh.uv[side.ends[0]], grid_.mesh.uv[side.ends[1]]};
  }
  dvec3 along(const Side& side) const {
    return grid_.mesh.position[side.ends[1]] - grid_.mesh.position[side.ends[0]];
  }
  bool goes_back(const Side& side, const SurfacePoint& point) const;
  void keep_turning();
  void find_turns();
  void keep_far();
  std::vector<dvec3> positions();
  void move_to_ends_of_sheets(double delta);

  const Surface& surface_;
  const Grid& grid_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  std::vector<Side> sides_;
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
