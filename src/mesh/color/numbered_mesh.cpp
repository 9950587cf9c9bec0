#include "mesh/color/numbered_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "mesh/color/color_limit.h"
#include "mesh/color/drawn_colors.h"
#include "surface/limit_path.h"

namespace saddle {

std::vector<double> NumberedMesh::numbers(std::span<const dvec2> uv) const {
  return evaluate_color(surface_, uv, limits_.threads);
}

void NumberedMesh::number_corners() {
  const std::vector<double> values = numbers(mesh_.uv);
  mesh_.color.assign(values.begin(), values.end());
  take_limits(0);
  renew();
  while (split_long_sides()) {
  }
  renew();
}

double NumberedMesh::length(std::uint32_t a, std::uint32_t b) const {
  return glm::distance(mesh_.position[a], mesh_.position[b]);
}

bool NumberedMesh::may_be_split(std::uint32_t a, std::uint32_t b) const {
  return mesh_.point[a] != mesh_.point[b] && length(a, b) > limits_.least_edge;
}

void NumberedMesh::mark(std::uint32_t a, std::uint32_t b) {
  if (may_be_split(a, b)) marked_.insert(pair_of(mesh_.point[a], mesh_.point[b]));
}

bool NumberedMesh::is_marked(std::uint32_t a, std::uint32_t b) const {
  return marked_.contains(pair_of(mesh_.point[a], mesh_.point[b]));
}

/// Corners from `first` on without a number take its limit from inside of a triangle.
void NumberedMesh::take_limits(std::size_t first) {
  const auto isnan = [](double number) { return std::isnan(number); };
  if (std::none_of(mesh_.color.begin() + static_cast<std::ptrdiff_t>(first), mesh_.color.end(),
                   isnan)) {
    return;
  }
  std::vector<std::uint32_t> corners;
  std::vector<dvec2> paths;
  std::vector<bool> done(mesh_.color.size() - first);
  for (const Triangle& triangle : mesh_.triangles) {
    const dvec2 middle =
        (mesh_.uv[triangle[0]] + mesh_.uv[triangle[1]] + mesh_.uv[triangle[2]]) / 3.0;
    for (const std::uint32_t corner : triangle) {
      if (corner < first || !std::isnan(mesh_.color[corner]) || done[corner - first]) continue;
      done[corner - first] = true;
      corners.push_back(corner);
      const auto path = limit_path(mesh_.uv[corner], middle);
      paths.insert(paths.end(), path.begin(), path.end());
    }
  }
  if (corners.empty()) return;
  const std::vector<double> values = numbers(paths);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto limit = extrapolated_limit(std::span(values).subspan(k * kLimitSteps, kLimitSteps));
    if (limit) mesh_.color[corners[k]] = *limit;
  }
}

bool NumberedMesh::split_long_sides() {
  const Domain& d = surface_.domain;
  const dvec2 longest = kFirstSide * dvec2(std::abs(d.u1 - d.u0), std::abs(d.v1 - d.v0));
  marked_.clear();
  for (const Triangle& triangle : mesh_.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k];
      const std::uint32_t b = next_corner(triangle, k);
      const dvec2 way = glm::abs(mesh_.uv[a] - mesh_.uv[b]);
      if (way.x > longest.x || way.y > longest.y) mark(a, b);
    }
  }
  return split_marked();
}

bool NumberedMesh::split_marked() {
  if (marked_.size() == 0) return false;
  if (mesh_.triangles.size() + 2 * marked_.size() > limits_.max_triangles) {
    reached_limit_ = true;
    return false;
  }
  middles_.clear();
  points_.clear();
  const std::size_t first = mesh_.position.size();
  const std::size_t count = mesh_.triangles.size();
  is_new_.assign(count, false);
  for (std::size_t t = 0; t < count; ++t) split(t);
  number_new_corners(first);
  for (std::vector<std::uint32_t>& line : mesh_.lines) split_line(line);
  return true;
}

void NumberedMesh::number_new_corners(std::size_t first) {
  const std::vector<double> values = numbers(std::span(mesh_.uv).subspan(first));
  mesh_.color.insert(mesh_.color.end(), values.begin(), values.end());
  take_limits(first);
}

/// The middle of a side that is marked.
std::optional<std::uint32_t> NumberedMesh::middle(std::uint32_t a, std::uint32_t b) {
  const Pair points = pair_of(mesh_.point[a], mesh_.point[b]);
  if (!marked_.contains(points)) return std::nullopt;
  const auto fresh = static_cast<std::uint32_t>(mesh_.position.size());
  const auto [known, is_first] = middles_.insert(pair_of(a, b), fresh);
  if (!is_first) return known;
  const dvec3 normal = mesh_.normal[a] + mesh_.normal[b];
  mesh_.position.push_back(0.5 * (mesh_.position[a] + mesh_.position[b]));
  mesh_.normal.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : mesh_.normal[a]);
  mesh_.uv.push_back(0.5 * (mesh_.uv[a] + mesh_.uv[b]));
  const auto point = points_.insert(points, mesh_.point_count);
  if (point.second) ++mesh_.point_count;
  mesh_.point.push_back(point.first);
  return fresh;
}

/// Cuts a triangle along the middles of its sides into two, three or four.
void NumberedMesh::split(std::size_t t) {
  Triangle triangle = mesh_.triangles[t];
  std::array<std::optional<std::uint32_t>, 3> middles;
  std::size_t halved = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    middles[k] = middle(triangle[k], next_corner(triangle, k));
    if (middles[k]) ++halved;
  }
  if (halved == 0) return;
  // Turn it so that the side from the first corner is halved and, of two, the next one not.
  while (!middles[0] || (halved == 2 && middles[1])) {
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    std::rotate(middles.begin(), middles.begin() + 1, middles.end());
  }
  const auto [a, b, c] = triangle;
  const std::uint32_t m = *middles[0];
  if (halved == 1) {
    replace(t, {{{a, m, c}, {m, b, c}}});
  } else if (halved == 2) {
    const std::uint32_t n = *middles[2];  // of c and a
    if (length(m, c) < length(n, b)) {
      replace(t, {{{a, m, n}, {m, c, n}, {m, b, c}}});
    } else {
      replace(t, {{{a, m, n}, {m, b, n}, {n, b, c}}});
    }
  } else {
    const std::uint32_t n = *middles[1];
    const std::uint32_t o = *middles[2];
    replace(t, {{{a, m, o}, {m, b, n}, {n, c, o}, {m, n, o}}});
  }
}

void NumberedMesh::replace(std::size_t t, const std::vector<Triangle>& parts) {
  mesh_.triangles[t] = parts[0];
  is_new_[t] = true;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    mesh_.triangles.push_back(parts[k]);
    is_new_.push_back(true);
  }
}

void NumberedMesh::split_line(std::vector<std::uint32_t>& line) const {
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) {
      const auto found = middles_.find(pair_of(line[i - 1], line[i]));
      if (found) result.push_back(*found);
    }
    result.push_back(line[i]);
  }
  line = std::move(result);
}

double NumberedMesh::separate_undefined() {
  std::unordered_map<std::uint32_t, std::uint32_t> twins;
  double area = 0;
  double undefined = 0;
  for (Triangle& triangle : mesh_.triangles) {
    const auto& [a, b, c] = triangle;
    const dvec3& p = mesh_.position[a];
    const double twice = glm::length(glm::cross(mesh_.position[b] - p, mesh_.position[c] - p));
    area += twice;
    const auto has_none = [this](std::uint32_t i) { return std::isnan(mesh_.color[i]); };
    if (std::ranges::none_of(triangle, has_none)) continue;
    undefined += twice;
    for (std::uint32_t& corner : triangle) corner = twin(corner, twins);
  }
  return area > 0 ? undefined / area : 0;
}

/// A copy of a corner without a number.
std::uint32_t NumberedMesh::twin(std::uint32_t corner,
                                 std::unordered_map<std::uint32_t, std::uint32_t>& twins) {
  if (std::isnan(mesh_.color[corner])) return corner;
  const auto fresh = static_cast<std::uint32_t>(mesh_.position.size());
  const auto [known, is_first] = twins.try_emplace(corner, fresh);
  if (!is_first) return known->second;
  mesh_.position.push_back(dvec3(mesh_.position[corner]));
  mesh_.normal.push_back(dvec3(mesh_.normal[corner]));
  mesh_.uv.push_back(dvec2(mesh_.uv[corner]));
  mesh_.point.push_back(std::uint32_t{mesh_.point[corner]});
  mesh_.color.push_back(kNan);
  return fresh;
}

}  // namespace saddle
