// A hierarchy of boxes around the triangles of a mesh, to find those on a line of sight.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/bounds.h"
#include "mesh/model/mesh.h"

namespace saddle {

struct Ray;

/// Eight triangles that follow each other in the mesh share a box, and eight boxes the next larger
/// one: meshes list neighbours one after the other.
class TriangleBoxes {
 public:
  explicit TriangleBoxes(const Mesh& mesh);

  /// Calls `visit` with the number of each triangle whose box the ray may meet before `limit()`, a
  /// distance along it that may shrink meanwhile.
  template <typename Limit, typename Visit>
  void along(const Ray& ray, const Limit& limit, const Visit& visit) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, levels_.back().size(), ray, limit, visit);
  }

 private:
  static constexpr std::size_t kShare = 8;

  /// The distance at which the ray enters the box; infinity: it misses the box.
  static double entry(const Ray& ray, const Bounds& box);

  template <typename Limit, typename Visit>
  void descend(std::size_t level, std::size_t begin, std::size_t end, const Ray& ray,
               const Limit& limit, const Visit& visit) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (!(entry(ray, levels_[level][i]) < limit())) continue;
      const std::size_t below = level == 0 ? triangles_ : levels_[level - 1].size();
      const std::size_t last = std::min(below, (i + 1) * kShare);
      if (level > 0) {
        descend(level - 1, i * kShare, last, ray, limit, visit);
      } else {
        for (std::size_t t = i * kShare; t < last; ++t) visit(t);
      }
    }
  }

  std::size_t triangles_ = 0;
  std::vector<std::vector<Bounds>>
      levels_;  ///< from the smallest boxes to at most eight large ones
};

}  // namespace saddle
