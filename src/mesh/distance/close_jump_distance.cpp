#include "mesh/distance/close_jump_distance.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/distance/sampled_error.h"
#include "mesh/features/discontinuities.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/segment.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/jump_lines.h"

namespace saddle {

/// The segments between the two sides that lines cross. The sheets before the middles of the
/// crossings are to the left of the way from one to the other.
CloseJumpDistance::Sheets CloseJumpDistance::sheets_of(const Leaf& leaf,
                                                       const JumpLines& lines) const {
  const dvec2 low(leaf.low.u, leaf.low.v);
  const dvec2 size(leaf.size_u(), leaf.size_v());
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const dvec2 ends = tree_.vertices().place_between(a) + tree_.vertices().place_between(b);
    return (0.5 * ends - low) / size;
  };
  const auto here = [&](std::size_t k) { return lines.crossings()[k]; };
  const auto there = [&](std::size_t k) { return lines.crossings()[lines.partner(k)]; };
  const std::size_t last = lines.count() - 1;
  Sheets sheets;
  sheets.middles = {middle(here(0).before, here(last).after),
                    middle(there(last).before, there(0).after)};
  const auto& position = grid_.mesh.position;
  sheets.segments.push_back({position[here(0).before], position[there(0).after]});
  for (std::size_t k = 0; k < last; ++k) {
    const Side a = {here(k).after, here(k + 1).before};
    const Side b = {there(k).before, there(k + 1).after};
    for (const std::size_t edge : {0, 1})
      sheets.segments.push_back({position[a[edge]], position[b[edge]]});
    sheets.in_strips.push_back({middle(a[0], a[1]), middle(b[0], b[1])});
  }
  sheets.segments.push_back({position[here(last).after], position[there(last).before]});
  return sheets;
}

bool CloseJumpDistance::add(const Leaf& leaf, std::size_t number,
                            std::span<const Triangle> triangles, double allowed) {
  const JumpLines lines(leaf, tree_);
  if (lines.count() == 0 || !lines.have_strips() || !lines.cross_two_sides()) return false;
  const Sheets sheets = sheets_of(leaf, lines);
  const auto& middles = sheets.middles;
  const dvec2 left(middles[0].y - middles[1].y, middles[1].x - middles[0].x);
  if (left == dvec2(0)) return true;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 high = tree_.vertices().parameters(leaf.high());
  for (const double share : kAlongLine) {
    const dvec2 at = glm::mix(middles[0], middles[1], share);
    const Line line = {border_of_square(at, left), border_of_square(at, -left)};
    const dvec2 way = line[1] - line[0];
    std::vector<dvec2> in_strips;
    for (const auto& [from, to] : sheets.in_strips) {
      const double before = glm::dot(glm::mix(from, to, share) - line[0], way);
      in_strips.push_back(glm::mix(low, high, line[0] + before / glm::dot(way, way) * way));
    }
    across_.push_back({number,
                       triangles,
                       {glm::mix(low, high, line[0]), glm::mix(low, high, line[1])},
                       share,
                       sheets.segments,
                       std::move(in_strips),
                       allowed});
  }
  return true;
}

/// The jumps of lines that have one between each two strips where the mesh has them; none for other
/// lines.
std::vector<std::vector<Line>> CloseJumpDistance::jumps_between_strips(double delta) {
  std::vector<dvec2> uv;
  for (const Across& across : across_) {
    uv.push_back(across.line[0]);
    uv.insert(uv.end(), across.in_strips.begin(), across.in_strips.end());
    uv.push_back(across.line[1]);
  }
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += uv.size();
  std::vector<Bracket> gaps;
  std::size_t next = 0;
  for (const Across& across : across_) {
    for (std::size_t k = 0; k <= across.in_strips.size(); ++k, ++next)
      gaps.push_back(
          bracket_of({uv[next], uv[next + 1]}, across.line, points[next], points[next + 1]));
    ++next;
  }
  const auto found = bisect_positions(surface_, gaps, {delta}, threads_, looks_);
  std::vector<std::vector<Line>> jumps(across_.size());
  next = 0;
  for (std::size_t i = 0; i < across_.size(); ++i) {
    const auto of = std::span(found).subspan(next, across_[i].in_strips.size() + 1);
    next += of.size();
    const auto jumps_there = [](const LocatedDiscontinuity& at) {
      return at.kind == Discontinuity::Jump;
    };
    if (!std::ranges::all_of(of, jumps_there)) continue;
    for (const LocatedDiscontinuity& at : of) jumps[i].push_back(at.ends);
  }
  return jumps;
}

/// Searches the lines without known jumps.
void CloseJumpDistance::search(double delta, std::span<std::vector<Line>> jumps) {
  std::vector<std::size_t> numbers;
  std::vector<Line> lines;
  for (std::size_t k = 0; k < across_.size(); ++k) {
    if (!jumps[k].empty()) continue;
    numbers.push_back(k);
    lines.push_back(across_[k].line);
  }
  const auto first = find_discontinuities(surface_, lines, delta, threads_, looks_);
  std::vector<std::size_t> crossed;
  std::vector<Line> crossed_lines;
  std::vector<LocatedDiscontinuity> known;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (first[k].kind != Discontinuity::Jump) continue;
    crossed.push_back(numbers[k]);
    crossed_lines.push_back(lines[k]);
    known.push_back(first[k]);
  }
  auto all = find_all_jumps(surface_, crossed_lines, known, delta, threads_, looks_);
  for (std::size_t k = 0; k < crossed.size(); ++k) jumps[crossed[k]] = std::move(all[k]);
}

std::vector<LeafDistance> CloseJumpDistance::measure(double delta) {
  std::vector<LeafDistance> found;
  if (across_.empty()) return found;
  std::vector<std::vector<Line>> jumps = jumps_between_strips(delta);
  search(delta, jumps);
  // The edges of sheets on the way.
  std::vector<std::vector<dvec2>> places(across_.size());
  std::vector<dvec2> uv;
  for (std::size_t i = 0; i < across_.size(); ++i) {
    if (jumps[i].empty()) continue;
    std::vector<dvec2>& of = places[i];
    for (const Line& jump : jumps[i]) of.insert(of.end(), jump.begin(), jump.end());
    uv.insert(uv.end(), of.begin(), of.end());
  }
  const std::vector<dvec3> positions = evaluate_positions(surface_, uv, threads_);
  evaluations_ += uv.size();
  std::size_t next = 0;
  std::array<std::vector<double>, kAlongLine.size()> along;  // of the edges, on a leaf's lines
  for (std::size_t k = 0; k < across_.size(); ++k) {
    along[k % along.size()] =
        measure(across_[k], places[k], std::span(positions).subspan(next, places[k].size()), found);
    next += places[k].size();
    if ((k + 1) % along.size() == 0) measure_ends(across_[k], along, found);
  }
  return found;
}

/// Where an edge turns near an end of its chord, as at the end of a slot, distances grow up to
/// there: the straight line through two of them is taken to the chord's end.
void CloseJumpDistance::measure_ends(const Across& across,
                                     std::span<const std::vector<double>> along,
                                     std::vector<LeafDistance>& found) {
  const std::size_t edges = along[0].size();
  if (along[1].size() != edges || along[2].size() != edges) return;
  for (std::size_t k = 0; k < edges; ++k) {
    const double larger = std::max(along[0][k], along[2][k]);
    const double at_end = 2 * larger - along[1][k];
    found.push_back({across.leaf, supported_distance(at_end, larger, across.allowed), true});
  }
}

/// Edges of sheets are measured one by one. If a line crosses others than the mesh has, each edge
/// of the surface is measured from the triangles, and each of the mesh from those of the surface.
/// Returns the distances in the first case.
std::vector<double> CloseJumpDistance::measure(const Across& across, std::span<const dvec2> uv,
                                               std::span<const dvec3> edges,
                                               std::vector<LeafDistance>& found) const {
  std::vector<double> distances;
  bool are_finite = true;
  const bool is_alike = edges.size() == across.edges.size();
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!is_finite(edges[k])) {
      are_finite = false;
      continue;
    }
    double least = std::numeric_limits<double>::infinity();
    if (is_alike) {
      least = distance_from_segment(across.edges[k][0], across.edges[k][1], edges[k]);
    } else {
      for (const Triangle& triangle : across.triangles)
        least = std::min(least, distance_from_triangle(grid_, triangle, edges[k]));
    }
    found.push_back({across.leaf, least, true, uv[k]});
    if (is_alike) distances.push_back(least);
  }
  if (is_alike) return are_finite ? distances : std::vector<double>();
  for (const auto& [from, to] : across.edges) {
    const dvec3 p = glm::mix(from, to, across.share);
    double least = std::numeric_limits<double>::infinity();
    // The ends of the edge are on the surface.
    for (const dvec3& end : {from, to}) {
      if (is_finite(end)) least = std::min(least, glm::distance(p, end));
    }
    for (const dvec3& edge : edges) least = std::min(least, glm::distance(edge, p));
    if (!edges.empty()) found.push_back({across.leaf, least, true});
  }
  return {};
}

}  // namespace saddle
