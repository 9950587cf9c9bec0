#include "mesh/jumps.h"

#include <algorithm>

namespace saddle {

namespace {

/// Halvings at most: doubles between two parameters run out before, except next to 0, where what
/// is left of the line is then 1e-30 of it.
constexpr int kMaxHalvings = 100;
/// A pole's gap is so many times as large at the end as at the beginning.
constexpr double kPoleGrowth = 50;

/// A line on its way.
struct Search {
  std::array<dvec2, 2> ends;
  std::array<dvec3, 2> at_ends;
  double first_gap = 0;
  bool done = false;
  Found found;
};

std::vector<dvec3> positions(const Surface& surface, std::span<const dvec2> uv, unsigned threads) {
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  std::vector<dvec3> result(points.size());
  std::ranges::transform(points, result.begin(), &SurfacePoint::position);
  return result;
}

void finish(Search& search, Break kind) {
  search.done = true;
  search.found = {kind, 0.5 * search.ends[0] + 0.5 * search.ends[1]};
}

/// Goes on with the half whose gap is larger.
void advance(Search& search, const dvec2& middle, const dvec3& at_middle, double delta) {
  const double gap = glm::distance(search.at_ends[0], search.at_ends[1]);
  if (middle == search.ends[0] || middle == search.ends[1]) {
    const bool grown = gap > kPoleGrowth * search.first_gap;
    return finish(search, grown ? Break::Pole : Break::Jump);
  }
  if (!is_finite(at_middle)) return finish(search, Break::Pole);
  const double first = glm::distance(search.at_ends[0], at_middle);
  const double second = glm::distance(at_middle, search.at_ends[1]);
  if (std::max(first, second) < delta) return finish(search, Break::None);
  const std::size_t replaced = first >= second ? 1 : 0;
  search.ends[replaced] = middle;
  search.at_ends[replaced] = at_middle;
}

}  // namespace

std::vector<Found> find_breaks(const Surface& surface, std::span<const std::array<dvec2, 2>> lines,
                               double delta, unsigned threads) {
  std::vector<dvec2> ends;
  for (const auto& line : lines) ends.insert(ends.end(), line.begin(), line.end());
  const std::vector<dvec3> at_ends = positions(surface, ends, threads);
  std::vector<Search> searches(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    Search& search = searches[k];
    search.ends = lines[k];
    search.at_ends = {at_ends[2 * k], at_ends[2 * k + 1]};
    search.first_gap = glm::distance(search.at_ends[0], search.at_ends[1]);
    // What is not defined at an end is a rim's matter.
    search.done = !is_finite(search.at_ends[0]) || !is_finite(search.at_ends[1]);
  }
  std::vector<dvec2> middles(lines.size());
  for (int halving = 0; halving < kMaxHalvings; ++halving) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      middles[k] = 0.5 * searches[k].ends[0] + 0.5 * searches[k].ends[1];
    }
    const std::vector<dvec3> at_middles = positions(surface, middles, threads);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (!searches[k].done) advance(searches[k], middles[k], at_middles[k], delta);
    }
  }
  std::vector<Found> result;
  result.reserve(searches.size());
  for (Search& search : searches) {
    if (!search.done) {
      const double gap = glm::distance(search.at_ends[0], search.at_ends[1]);
      finish(search, gap > kPoleGrowth * search.first_gap ? Break::Pole : Break::Jump);
    }
    result.push_back(search.found);
  }
  return result;
}

}  // namespace saddle
