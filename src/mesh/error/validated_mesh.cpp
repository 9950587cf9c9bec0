#include "mesh/error/validated_mesh.h"

#include <algorithm>
#include <utility>

namespace saddle {
namespace {

/// Moves the triangles of a leaf, mostly two. Both places may overlap.
void move_triangles(LeafTriangles::Range& range, std::size_t to, Array<Triangle>& all) {
  const std::size_t from = std::exchange(range.first, static_cast<std::uint32_t>(to));
  if (to < from) {
    for (std::size_t k = 0; k < range.count; ++k) all[to + k] = all[from + k];
  } else if (to > from) {
    for (std::size_t k = range.count; k-- > 0;) all[to + k] = all[from + k];
  }
}

}  // namespace

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

void ErrorPlaces::set(const std::optional<dvec2>& uv, SampledError& error) {
  if (!uv) {
    error.place = kNoIndex;
    return;
  }
  const std::lock_guard lock(mutex_);
  if (error.place == kNoIndex) {
    error.place = static_cast<std::uint32_t>(places_.size());
    places_.push_back(*uv);
  } else {
    places_[error.place] = *uv;
  }
}

void ErrorPlaces::keep(std::span<SampledError> errors) {
  std::vector<dvec2> places;
  for (SampledError& error : errors) {
    if (error.place == kNoIndex) continue;
    places.push_back(places_[error.place]);
    error.place = static_cast<std::uint32_t>(places.size() - 1);
  }
  places_ = std::move(places);
}

void ValidatedMesh::add(std::size_t leaf, double distance, const std::optional<dvec2>& uv) {
  SampledError& worst = sampled_errors[leaf];
  if (!(distance > worst.distance)) return;
  worst.distance = distance;
  error_places.set(uv, worst);
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

void ValidatedMesh::tidy_triangles() {
  std::vector<LeafTriangles::Range>& ranges = triangles.ranges;
  Array<Triangle>& all = triangles.all;
  std::vector<std::size_t> astray;  // leaves whose triangles are out of order, the last leaf first
  std::size_t count = 0;
  std::size_t next = all.size();  // the first triangle of later leaves in order
  for (std::size_t k = ranges.size(); k-- > 0;) {
    count += ranges[k].count;
    if (std::size_t{ranges[k].first} + ranges[k].count <= next) {
      next = ranges[k].first;
    } else {
      astray.push_back(k);
    }
  }
  if (count == all.size() && astray.empty()) return;
  Array<Triangle> theirs;
  for (const std::size_t k : astray) {
    const std::span<const Triangle> own = triangles.of(k);
    theirs.insert(theirs.end(), own.begin(), own.end());
  }
  // The others move to the front, and from there, the last leaf first, to their places.
  std::size_t end = 0;
  for (std::size_t k = 0, left = astray.size(); k < ranges.size(); ++k) {
    if (left > 0 && astray[left - 1] == k) {
      --left;
    } else {
      move_triangles(ranges[k], std::exchange(end, end + ranges[k].count), all);
    }
  }
  all.resize(count);
  end = count;
  auto next_of_theirs = theirs.begin();
  for (std::size_t k = ranges.size(), moved = 0; moved < astray.size();) {
    end -= ranges[--k].count;
    if (astray[moved] != k) {
      move_triangles(ranges[k], end, all);
      continue;
    }
    std::copy_n(next_of_theirs, ranges[k].count, all.begin() + static_cast<std::ptrdiff_t>(end));
    ranges[k].first = static_cast<std::uint32_t>(end);
    next_of_theirs += ranges[k].count;
    ++moved;
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
  error_places.keep(sampled_errors);
  triangles.ranges.resize(to);
  made.resize(to);
  marks.resize(to);
  allowed.resize(to);
}

}  // namespace saddle
