#include "mesh/distance/strip_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/distance/sampled_error.h"
#include "mesh/distance/sheet_view.h"
#include "mesh/features/approach.h"
#include "mesh/features/thin_parts.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/sides.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// Lines across a strip between two ends, in parts of its length.
constexpr std::array kAcrossStrip = {0.05, 0.25, 0.5, 0.75, 0.95};

}  // namespace

/// A vertex of each run of vertices around a leaf on the strip that enters it, or in the gap: the
/// thin one, or else the last. Empty without a thin vertex.
std::vector<std::uint32_t> StripDistance::thin_ends(const Leaf& leaf, bool& is_gap) const {
  if (!has_thin_vertex(leaf, tree_)) return {};
  is_gap = !has_thin_strip(leaf, tree_);
  std::vector<std::uint32_t> vertices;
  for_sides(leaf, tree_, [&](std::uint32_t a, std::uint32_t) { vertices.push_back(a); });
  const auto is_inside = [&](std::uint32_t vertex) {
    return tree_.geometry().is_defined(vertex) != is_gap;
  };
  const auto outside = std::ranges::find_if_not(vertices, is_inside);
  if (outside == vertices.end()) return {};
  std::rotate(vertices.begin(), outside, vertices.end());
  std::vector<std::uint32_t> ends;
  bool was_inside = false;
  for (const std::uint32_t vertex : vertices) {
    if (is_inside(vertex)) {
      if (!was_inside) ends.push_back(vertex);
      if (!tree_.thin().contains(ends.back())) ends.back() = vertex;
    }
    was_inside = is_inside(vertex);
  }
  return ends;
}

bool StripDistance::add(const Leaf& leaf, std::size_t number, std::span<const Triangle> triangles,
                        double allowed) {
  bool is_gap = false;
  const std::vector<std::uint32_t> ends = thin_ends(leaf, is_gap);
  if (ends.size() > 2 && !is_gap && !tree_.is_centre_defined(leaf)) {
    Bounds around;
    for (const std::uint32_t end : ends) around.add(grid_.mesh.position[end]);
    if (around.diagonal() > allowed) found_.push_back({number, kMostSafety * allowed});
  }
  if (ends.empty() || ends.size() > 2) return false;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  const auto place = [&](std::uint32_t vertex) { return (grid_.mesh.uv[vertex] - low) / size; };
  Across across{number, triangles, {}, is_gap, ends, {}, 0, {}};
  for_triangle_sides(triangles, [&](const Triangle& t, std::size_t k, bool is_diagonal) {
    const std::array<std::uint32_t, 2> edge = {t[k], t[(k + 1) % 3]};
    if (!is_diagonal && is_chord(0.5 * (place(edge[0]) + place(edge[1])), edge, tree_))
      across.edges.push_back(edge);
  });
  const dvec2 from = place(ends[0]);
  if (ends.size() == 1) {
    const int axis = std::min(from.x, 1 - from.x) < std::min(from.y, 1 - from.y) ? 0 : 1;
    Line side = {low, low + size};
    for (dvec2& at : side) at[axis] = low[axis] + (from[axis] < 0.5 ? 0 : size[axis]);
    dvec2 depth(0);
    depth[axis] = from[axis] < 0.5 ? size[axis] : -size[axis];
    tips_.push_back({std::move(across), side, depth});
    return triangles.empty();
  }
  const auto add = [&](const dvec2& at, const dvec2& way) {
    across.line = {low + size * border_of_square(at, way), low + size * border_of_square(at, -way)};
    across_.push_back(across);
  };
  const dvec2 to = place(ends[1]);
  if (from == to) return false;
  if (!is_gap) across.at_least = kMostSafety * allowed;
  for (const double share : kAcrossStrip)
    add(glm::mix(from, to, share), dvec2(from.y - to.y, to.x - from.x));
  // At a wide end the edges are those of a region.
  return triangles.empty() || std::ranges::all_of(ends, [this](std::uint32_t end) {
           return tree_.thin().contains(end);
         });
}

/// Looks on each line across for the strip or gap.
void StripDistance::find_inside(std::span<Across> across) {
  std::vector<AlikeEnds> lines;
  for (const Across& line : across) lines.push_back({line.line, line.is_gap});
  const auto inside = find_thin_parts(surface_, lines, threads_, evaluations_);
  for (std::size_t k = 0; k < across.size(); ++k) across[k].inside = inside[k];
}

/// Adds the lines that cross a strip or gap which ends in its leaf: one beside the side through
/// which it enters, and those of a bisection of its depth, of which the last is beside the tip.
void StripDistance::follow_to_tips() {
  const auto look = [this](const auto& depth) {
    std::vector<Across> lines;
    for (const Tip& tip : tips_) {
      lines.push_back(tip.across);
      for (std::size_t end = 0; end < 2; ++end)
        lines.back().line[end] = tip.side[end] + depth(tip) * tip.depth;
    }
    find_inside(lines);
    for (std::size_t k = 0; k < tips_.size(); ++k) {
      if (!lines[k].inside) continue;
      tips_[k].reached = depth(tips_[k]);
      across_.push_back(std::move(lines[k]));
    }
  };
  const double least = std::ldexp(1.0, -kHalvingsToSight);
  look([least](const Tip&) { return least; });
  for (double step = 0.5; step >= least; step /= 2)
    look([step](const Tip& tip) { return std::min(tip.reached + step, 1.0); });
}

/// Measures each strip or gap on the lines across it.
std::vector<LeafDistance> StripDistance::measure() {
  std::vector<LeafDistance> found = std::move(found_);
  find_inside(across_);
  follow_to_tips();
  std::vector<Line> ways;
  for (const Across& across : across_) {
    if (!across.inside) {
      found.push_back({across.leaf, across.at_least});
      continue;
    }
    for (const dvec2& end : across.line) {
      ways.push_back({end, *across.inside});
      if (!across.is_gap) std::swap(ways.back()[0], ways.back()[1]);
    }
  }
  if (ways.empty()) return found;
  const std::vector<dvec2> edges = last_defined(surface_, ways, kHalvingsToEdge, threads_, clip_);
  std::vector<dvec2> uv;
  for (std::size_t k = 0; k < edges.size(); k += 2) {
    for (const double share : kAllAlongLine) uv.push_back(glm::mix(edges[k], edges[k + 1], share));
  }
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += edges.size() * kHalvingsToEdge + points.size();
  std::size_t next = 0;
  for (std::size_t k = 0; k < across_.size(); ++k) {
    if (!across_[k].inside) continue;
    const std::size_t count = kAllAlongLine.size();
    const auto on_line = std::span(points).subspan(next, count);
    if (across_[k].is_gap) {
      found.push_back({across_[k].leaf, distance_across_gap(across_[k], on_line)});
    } else {
      add_distances_on_strip(across_[k], std::span(uv).subspan(next, count), on_line, found);
    }
    next += count;
  }
  return found;
}

double StripDistance::from_edges(const Across& across, const dvec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& edge : across.edges)
    least = std::min(least, distance_from_chord(grid_, edge, p));
  return least;
}

/// The distance of a gap's edges from the mesh's, or half of its width if that is less.
double StripDistance::distance_across_gap(const Across& across,
                                          std::span<const SurfacePoint> points) const {
  double most = 0;
  for (const SurfacePoint& point : points) {
    if (is_seen(clip_, point.position)) most = std::max(most, from_edges(across, point.position));
  }
  const double width = glm::distance(points.front().position, points.back().position);
  return width > 0 ? std::min(most, 0.5 * width) : 0;  // 0 for NaN
}

/// Adds the distances of places on a strip from the triangles, or without any from its ends, and of
/// its edges from the mesh's. A strip that goes on at the end of the line has no edge there.
void StripDistance::add_distances_on_strip(const Across& across, std::span<const dvec2> uv,
                                           std::span<const SurfacePoint> points,
                                           std::vector<LeafDistance>& found) const {
  const dvec2 first = across.line[0];
  const dvec2 last = across.line[1];
  const auto is_at_line_end = [&](const dvec2& at) {
    return is_at_end(at, {last, first}) || is_at_end(at, {first, last});
  };
  const auto from_ends = [&](const dvec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t end : across.ends)
      least = std::min(least, glm::distance(grid_.mesh.position[end], p));
    return least;
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    const dvec3& p = points[k].position;
    if (!is_seen(clip_, p)) continue;
    double distance =
        across.triangles.empty() ? from_ends(p) : distance_from(grid_, across.triangles, uv[k], p);
    const bool is_edge = (k == 0 || k + 1 == points.size()) && !is_at_line_end(uv[k]);
    if (is_edge && !across.edges.empty()) distance = std::max(distance, from_edges(across, p));
    found.push_back({across.leaf, distance, false, uv[k]});
  }
}

}  // namespace saddle
