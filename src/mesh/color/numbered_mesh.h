// A mesh with a number at each corner, whose triangles are halved along marked sides. Sides are
// halved for all triangles beside them, along straight edges: the mesh stays conforming and keeps
// its shape. Sides between the same points are halved alike, whichever corners they have, so that
// no gap opens along a seam.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/model/pair_table.h"
#include "surface/surface.h"

namespace saddle {

struct HalvingLimits {
  double least_edge = 0;  ///< edges no longer than this are not halved
  std::size_t max_triangles = 4'000'000;
  unsigned threads = 0;
};

class NumberedMesh {
 public:
  /// Numbers are those of the surface's colour tape. All three stay where they are.
  NumberedMesh(const Surface& surface, const HalvingLimits& limits, Mesh& mesh)
      : surface_(surface), limits_(limits), mesh_(mesh) {}
  NumberedMesh(const NumberedMesh&) = delete;
  NumberedMesh& operator=(const NumberedMesh&) = delete;

  /// Numbers all corners and halves triangles until no side is longer than kFirstSide of the
  /// ranges. A corner without a number takes its limit from inside of a triangle, if there is one.
  void number_corners();

  /// The numbers at these parameters.
  std::vector<double> numbers(std::span<const dvec2> uv) const;

  /// Triangles that the last halving made; all after number_corners() and renew().
  bool is_new(std::size_t triangle) const { return is_new_[triangle]; }
  void renew() { is_new_.assign(mesh_.triangles.size(), true); }

  bool may_be_split(std::uint32_t a, std::uint32_t b) const;
  void unmark() { marked_.clear(); }
  void mark(std::uint32_t a, std::uint32_t b);
  bool is_marked(std::uint32_t a, std::uint32_t b) const;
  /// Halves the marked sides; false if there are none, or too many.
  bool split_marked();
  bool reached_limit() const { return reached_limit_; }

  /// Gives triangles with a corner without a number three such corners of their own. Returns their
  /// share of the area.
  double separate_undefined();

 private:
  double length(std::uint32_t a, std::uint32_t b) const;
  bool split_long_sides();
  void take_limits(std::size_t first);
  void number_new_corners(std::size_t first);
  std::optional<std::uint32_t> middle(std::uint32_t a, std::uint32_t b);
  void split(std::size_t t);
  void replace(std::size_t t, const std::vector<Triangle>& parts);
  void split_line(std::vector<std::uint32_t>& line) const;
  std::uint32_t twin(std::uint32_t corner, std::unordered_map<std::uint32_t, std::uint32_t>& twins);

  const Surface& surface_;
  HalvingLimits limits_;
  Mesh& mesh_;
  bool reached_limit_ = false;
  std::vector<bool> is_new_;
  PairTable marked_;   // points whose sides are to be halved
  PairTable middles_;  // new corners between corners
  PairTable points_;   // new points between points
};

/// The corner after corner k of a triangle.
inline std::uint32_t next_corner(const Triangle& triangle, std::size_t k) {
  return triangle[k == 2 ? 0 : k + 1];
}

}  // namespace saddle
