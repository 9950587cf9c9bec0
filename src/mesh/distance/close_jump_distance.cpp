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
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// A side of a leaf that strips cross, on the way around the leaf.
struct Crossing {
  EdgeFeature feature;
  std::uint32_t from, to;
};

}  // namespace

/// The segments between the two sides that strips cross, sheet by sheet. `middles`: of the
/// crossings, in sides of the leaf; the sheets before them are to the left of the way from one to
/// the other.
std::vector<std::array<dvec3, 2>> CloseJumpDistance::sheets_of(
    const Leaf& leaf, std::array<dvec2, 2>& middles) const {
  std::vector<Crossing> crossings;
  for_sides(leaf, tree_, [&](std::uint32_t a, std::uint32_t b) {
    if (const auto feature = tree_.edges().feature(a, b)) crossings.push_back({*feature, a, b});
  });
  const dvec2 low(leaf.low.u, leaf.low.v);
  const dvec2 size(leaf.size_u(), leaf.size_v());
  for (std::size_t k = 0; k < 2; ++k) {
    const EdgeFeature& feature = crossings[k].feature;
    const dvec2 ends = tree_.vertices().place_between(feature.beside_first) +
                       tree_.vertices().place_between(feature.beside_second);
    middles[k] = (0.5 * ends - low) / size;
  }
  const auto& position = grid_.mesh.position;
  const Crossing& first = crossings[0];
  const Crossing& second = crossings[1];
  const auto on_strip = [&](std::size_t strip, const EdgeFeature& feature, std::uint32_t end) {
    const auto [a, b] = feature.on_strip(strip, end);
    return 0.5 * (position[a] + position[b]);
  };
  std::vector<std::array<dvec3, 2>> sheets;
  sheets.push_back(
      {position[first.feature.beside(first.from)], position[second.feature.beside(second.to)]});
  for (std::size_t k = 0; k < first.feature.strips; ++k) {
    sheets.push_back(
        {on_strip(k, first.feature, first.from), on_strip(k, second.feature, second.to)});
  }
  sheets.push_back(
      {position[first.feature.beside(first.to)], position[second.feature.beside(second.from)]});
  return sheets;
}

void CloseJumpDistance::add(const Leaf& leaf, std::size_t number,
                            std::span<const Triangle> triangles) {
  std::array<dvec2, 2> middles;
  const std::vector<std::array<dvec3, 2>> sheets = sheets_of(leaf, middles);
  const dvec2 left(middles[0].y - middles[1].y, middles[1].x - middles[0].x);
  if (left == dvec2(0)) return;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 high = tree_.vertices().parameters(leaf.high);
  for (const double share : kAlongLine) {
    const dvec2 at = glm::mix(middles[0], middles[1], share);
    across_.push_back({number,
                       triangles,
                       {glm::mix(low, high, border_of_square(at, left)),
                        glm::mix(low, high, border_of_square(at, -left))},
                       share,
                       sheets});
  }
}

std::vector<LeafDistance> CloseJumpDistance::measure(double delta) {
  std::vector<LeafDistance> found;
  if (across_.empty()) return found;
  std::vector<Line> lines;
  for (const Across& across : across_) lines.push_back(across.line);
  const auto jumps = find_discontinuities(surface_, lines, delta, threads_, evaluations_);
  std::vector<std::size_t> crossed;
  std::vector<Line> crossed_lines;
  std::vector<LocatedDiscontinuity> known;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (jumps[k].kind != Discontinuity::Jump) continue;
    crossed.push_back(k);
    crossed_lines.push_back(lines[k]);
    known.push_back(jumps[k]);
  }
  const auto all = find_all_jumps(surface_, crossed_lines, known, delta, threads_, evaluations_);
  // The sheets on the way: the outer ones where they end, the strips in their middles.
  std::vector<std::vector<dvec2>> places(across_.size());
  std::vector<dvec2> uv;
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    if (all[i].empty()) continue;
    std::vector<dvec2>& of = places[crossed[i]];
    of.push_back(all[i].front()[0]);
    for (std::size_t k = 0; k + 1 < all[i].size(); ++k)
      of.push_back(0.5 * (all[i][k][1] + all[i][k + 1][0]));
    of.push_back(all[i].back()[1]);
    uv.insert(uv.end(), of.begin(), of.end());
  }
  const std::vector<dvec3> positions = evaluate_positions(surface_, uv, threads_);
  evaluations_ += uv.size();
  std::size_t next = 0;
  for (std::size_t k = 0; k < across_.size(); ++k) {
    measure(across_[k], places[k], std::span(positions).subspan(next, places[k].size()), found);
    next += places[k].size();
  }
  return found;
}

/// Sheets are measured one by one. If a line crosses others than the mesh has, each sheet of the
/// surface is measured from the triangles, and each of the mesh from the sheets of the surface.
void CloseJumpDistance::measure(const Across& across, std::span<const dvec2> uv,
                                std::span<const dvec3> sheets,
                                std::vector<LeafDistance>& found) const {
  const bool is_alike = sheets.size() == across.sheets.size();
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    if (!is_finite(sheets[k])) continue;
    double least = std::numeric_limits<double>::infinity();
    if (is_alike) {
      least = distance_from_segment(across.sheets[k][0], across.sheets[k][1], sheets[k]);
    } else {
      for (const Triangle& triangle : across.triangles)
        least = std::min(least, distance_from_triangle(grid_, triangle, sheets[k]));
    }
    found.push_back({across.leaf, least, true, uv[k]});
  }
  if (is_alike) return;
  for (const auto& [from, to] : across.sheets) {
    const dvec3 p = glm::mix(from, to, across.share);
    double least = std::numeric_limits<double>::infinity();
    for (const dvec3& sheet : sheets) least = std::min(least, glm::distance(sheet, p));
    if (!sheets.empty()) found.push_back({across.leaf, least, true});
  }
}

}  // namespace saddle
