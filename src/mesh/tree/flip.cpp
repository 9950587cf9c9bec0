#include "mesh/tree/flip.h"

#include <algorithm>
#include <vector>

#include "mesh/grid/triangulate.h"
#include "mesh/model/pair_table.h"
#include "mesh/tree/polygon.h"

namespace saddle {

namespace {

/// The count of triangle sides between each pair of points.
class SideCounts {
 public:
  explicit SideCounts(const Mesh& mesh) : mesh_(mesh) {}

  std::size_t& of(std::uint32_t corner_a, std::uint32_t corner_b) {
    const Pair sides = pair_of(mesh_.point[corner_a], mesh_.point[corner_b]);
    const auto [at, is_new] = places_.insert(sides, static_cast<std::uint32_t>(counts_.size()));
    if (is_new) counts_.push_back(0);
    return counts_[at];
  }

 private:
  const Mesh& mesh_;
  PairTable places_;  // in counts_
  std::vector<std::size_t> counts_;
};

/// Twice the signed area in parameters.
double doubled_area_in_plane(const Mesh& mesh, const Triangle& t) {
  return doubled_area(mesh.uv[t[0]], mesh.uv[t[1]], mesh.uv[t[2]]);
}

/// The common side of two triangles, which they run along in opposite directions.
struct SharedSide {
  std::uint32_t a, b;  ///< the chord; from a to b in the first
  std::uint32_t c, d;  ///< the tips
};

std::optional<SharedSide> common_side(const Triangle& first, const Triangle& second) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::uint32_t a = first[i];
      const std::uint32_t b = first[(i + 1) % 3];
      if (second[j] == b && second[(j + 1) % 3] == a) {
        return SharedSide{a, b, first[(i + 2) % 3], second[(j + 2) % 3]};
      }
    }
  }
  return std::nullopt;
}

/// Leaves that may have a chord in common with others: they have several triangles and touch a
/// point that is more than one corner.
class SharedPoints {
 public:
  SharedPoints(const Mesh& mesh, const LeafTriangles& triangles)
      : mesh_(mesh), is_near_(mesh.position.size(), 0) {
    std::vector<std::uint8_t> is_shared(mesh.position.size(), 0);  // of corners
    for (std::size_t corner = 0; corner < mesh.position.size(); ++corner) {
      if (mesh.point[corner] != corner) is_shared[corner] = is_shared[mesh.point[corner]] = 1;
    }
    for (std::size_t leaf = 0; leaf < triangles.ranges.size(); ++leaf) {
      const std::span<const Triangle> of_leaf = triangles.of(leaf);
      const bool meets_others =
          of_leaf.size() > 1 && std::ranges::any_of(of_leaf, [&](auto& t) {
            return std::ranges::any_of(t, [&](auto corner) { return is_shared[corner] != 0; });
          });
      if (!meets_others) continue;
      leaves_.push_back(leaf);
      for (const Triangle& t : of_leaf) {
        for (const std::uint32_t corner : t) is_near_[mesh.point[corner]] = 1;
      }
    }
  }

  const std::vector<std::size_t>& leaves() const { return leaves_; }
  /// Whether a corner's point belongs to one of those leaves.
  bool is_near(std::uint32_t corner) const { return is_near_[mesh_.point[corner]] != 0; }

 private:
  const Mesh& mesh_;
  std::vector<std::uint8_t> is_near_;  // of points
  std::vector<std::size_t> leaves_;
};

bool flip(const Grid& grid, SideCounts& sides, Triangle& first, Triangle& second) {
  const std::optional<SharedSide> pair = common_side(first, second);
  if (!pair || sides.of(pair->a, pair->b) <= 2 || sides.of(pair->c, pair->d) > 0) return false;
  const Triangle one = {pair->c, pair->a, pair->d};
  const Triangle other = {pair->d, pair->b, pair->c};
  const double front = doubled_area_in_plane(grid.mesh, first);
  const bool faces_alike = doubled_area_in_plane(grid.mesh, one) * front > 0 &&
                           doubled_area_in_plane(grid.mesh, other) * front > 0;
  if (!faces_alike || is_collapsed(grid, one) || is_collapsed(grid, other)) return false;
  sides.of(pair->a, pair->b) -= 2;
  sides.of(pair->c, pair->d) += 2;
  first = one;
  second = other;
  return true;
}

}  // namespace

void flip_shared_chords(const Grid& grid, LeafTriangles& triangles) {
  const SharedPoints shared(grid.mesh, triangles);
  if (shared.leaves().empty()) return;
  SideCounts sides(grid.mesh);
  for (const Triangle& t : triangles.all) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t next = t[(k + 1) % 3];
      if (shared.is_near(t[k]) && shared.is_near(next)) ++sides.of(t[k], next);
    }
  }
  for (const std::size_t leaf : shared.leaves()) {
    const LeafTriangles::Range& range = triangles.ranges[leaf];
    const std::size_t end = range.first + range.count;
    for (std::size_t i = range.first; i < end; ++i) {
      for (std::size_t j = i + 1; j < end; ++j) {
        flip(grid, sides, triangles.all[i], triangles.all[j]);
      }
    }
  }
}

}  // namespace saddle
