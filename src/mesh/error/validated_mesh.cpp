#include "mesh/error/validated_mesh.h"

#include <algorithm>
#include <utility>

namespace saddle {

void ValidatedMesh::reserve() {
  if (leaves.size() <= allowed.capacity()) return;
  const std::size_t count = leaves.size() + leaves.size() / 8;
  sampled_errors.reserve(count);
  allowed.reserve(count);
  triangles.all.reserve(2 * count);
  triangles.ranges.reserve(count);
  made.reserve(count);
  marks.reserve(count);
}

void ValidatedMesh::add(std::size_t leaf, double distance, const std::optional<dvec2>& uv) {
  SampledError& worst = sampled_errors[leaf];
  if (!(distance > worst.distance)) return;
  worst.distance = distance;
  if (!uv) {
    worst.place = kNoIndex;
  } else if (worst.place == kNoIndex) {
    worst.place = static_cast<std::uint32_t>(error_places.size());
    error_places.push_back(*uv);
  } else {
    error_places[worst.place] = *uv;
  }
}

void ValidatedMesh::put(std::span<const std::size_t> which, LeafTriangles newer,
                        std::uint32_t revision) {
  made.resize(leaves.size());
  marks.resize(leaves.size());
  triangles.ranges.resize(leaves.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    const bool are_none = triangles.ranges[which[k]].count + newer.ranges[k].count == 0;
    if (!are_none && made[which[k]] != revision) marks[which[k]] = {};
    made[which[k]] = revision;
  }
  if (triangles.all.empty() && which.size() == leaves.size()) {
    triangles = std::move(newer);
    return;
  }
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
  std::size_t count = 0;
  const auto follows = [&count](const LeafTriangles::Range& range) {
    return range.first == std::exchange(count, count + range.count);
  };
  if (std::ranges::all_of(triangles.ranges, follows) && count == triangles.all.size()) return;
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
    marks[to] = marks[from];
    allowed[to++] = allowed[from];
  }
  leaves.resize(to);
  sampled_errors.resize(to);
  std::vector<dvec2> places;  // without those of removed leaves
  for (SampledError& error : sampled_errors) {
    if (error.place == kNoIndex) continue;
    places.push_back(error_places[error.place]);
    error.place = static_cast<std::uint32_t>(places.size() - 1);
  }
  error_places = std::move(places);
  triangles.ranges.resize(to);
  made.resize(to);
  marks.resize(to);
  allowed.resize(to);
}

}  // namespace saddle
