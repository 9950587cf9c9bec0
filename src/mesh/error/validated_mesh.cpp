#include "mesh/error/validated_mesh.h"

#include <utility>

namespace saddle {

void ValidatedMesh::put(std::span<const std::size_t> which, LeafTriangles newer,
                        std::uint32_t now) {
  made.resize(leaves.size());
  proved.resize(leaves.size());
  rough.resize(leaves.size());
  searched.resize(leaves.size());
  for (const std::size_t k : which) made[k] = now;
  if (triangles.all.empty() && which.size() == leaves.size()) {
    triangles = std::move(newer);
    return;
  }
  triangles.ranges.resize(leaves.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    LeafTriangles::Range& range = triangles.ranges[which[k]] = newer.ranges[k];
    range.first = static_cast<std::uint32_t>(triangles.all.size());
    const std::span<const Triangle> own = newer.of(k);
    triangles.all.insert(triangles.all.end(), own.begin(), own.end());
  }
}

Array<Triangle> ValidatedMesh::all_triangles() const {
  std::size_t count = 0;
  for (const LeafTriangles::Range& range : triangles.ranges) count += range.count;
  Array<Triangle> result;
  result.reserve(count);
  for (std::size_t k = 0; k < triangles.ranges.size(); ++k) {
    const std::span<const Triangle> own = triangles.of(k);
    result.insert(result.end(), own.begin(), own.end());
  }
  return result;
}

void ValidatedMesh::tidy_triangles() {
  triangles.all = all_triangles();
  std::uint32_t first = 0;
  for (LeafTriangles::Range& range : triangles.ranges) {
    range.first = first;
    first += range.count;
  }
}

void ValidatedMesh::remove(std::span<const std::size_t> which) {
  if (which.empty()) return;
  std::size_t to = which.front();
  for (std::size_t from = to; from < leaves.size(); ++from) {
    if (!which.empty() && which.front() == from) {
      which = which.subspan(1);
      continue;
    }
    leaves[to] = leaves[from];
    sampled_errors[to] = sampled_errors[from];
    triangles.ranges[to] = triangles.ranges[from];
    made[to] = made[from];
    proved[to] = proved[from];
    rough[to] = rough[from];
    searched[to] = searched[from];
    allowed[to++] = allowed[from];
  }
  leaves.resize(to);
  sampled_errors.resize(to);
  triangles.ranges.resize(to);
  made.resize(to);
  proved.resize(to);
  rough.resize(to);
  searched.resize(to);
  allowed.resize(to);
}

}  // namespace saddle
