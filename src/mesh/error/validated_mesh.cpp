#include "mesh/error/validated_mesh.h"

namespace saddle {

namespace {

/// Appends the triangles of a range; returns their new range.
LeafTriangles::Range append(const LeafTriangles& from, LeafTriangles::Range range,
                            Array<Triangle>& to) {
  const auto first = from.all.begin() + range.first;
  range.first = static_cast<std::uint32_t>(to.size());
  to.insert(to.end(), first, first + range.count);
  return range;
}

}  // namespace

void ValidatedMesh::put(std::span<const std::size_t> which, const LeafTriangles& newer,
                        std::uint32_t now) {
  triangles.ranges.resize(leaves.size());
  made.resize(leaves.size());
  proved.resize(leaves.size());
  rough.resize(leaves.size());
  searched.resize(leaves.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    triangles.ranges[which[k]] = append(newer, newer.ranges[k], triangles.all);
    made[which[k]] = now;
  }
}

LeafTriangles ValidatedMesh::all_triangles() const {
  std::size_t count = 0;
  for (const LeafTriangles::Range& range : triangles.ranges) count += range.count;
  LeafTriangles result;
  result.all.reserve(count);
  result.ranges.reserve(leaves.size());
  for (const LeafTriangles::Range& range : triangles.ranges) {
    result.ranges.push_back(append(triangles, range, result.all));
  }
  return result;
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
