#include "mesh/features/cliffs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/features/bisect_together.h"
#include "mesh/features/search_chunks.h"
#include "mesh/model/segment.h"
#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// The longest part of a line that is a cliff: halvings of the leaf show a longer one as well.
constexpr double kLongestCliff = 0.75;
/// A sheet ends where it leaves its tangent by this part of delta.
constexpr double kOnTangent = 1.0 / 16;
/// Places on a straight cliff, its ends included, at which that is measured: fewer miss the rounded
/// ends of tanh. A cliff of several segments has more, and at least three on each.
constexpr std::size_t kPlacesOnCliff = 13;
constexpr std::size_t kPlacesOnSegments = 129;
constexpr std::size_t kMostSegments = 32;
/// How many times as steep as on the average a straight cliff may be at an end: a vertex may lie in
/// the middle of tanh's cliff, but toward a pole the surface is ever steeper.
constexpr double kSteepestEnd = 3;

/// A place on a line, as a share of it.
struct Place {
  double share;
  dvec3 position;
  dvec3 slope;  ///< derivative of the position by the share
};

struct CliffSearch {
  Line line;
  std::array<Place, 2> ends;  ///< on the sheets beside the cliff
  std::optional<Place> on_cliff = {};
  std::optional<Place> doubted = {};  ///< may replace an end, or be on the cliff
  std::size_t replaced = 0;           ///< that end

  dvec2 at(double share) const { return line[0] + share * (line[1] - line[0]); }
  Place place(double share, const SurfacePoint& point) const {
    const dvec2 way = line[1] - line[0];
    return {share, point.position, way.x * point.r_u + way.y * point.r_v};
  }
  double middle() const { return 0.5 * (ends[0].share + ends[1].share); }
  double next() const { return doubted ? 0.5 * (doubted->share + ends[replaced].share) : middle(); }
};

/// The part of the way between two places that their slopes do not explain.
double unexplained(const Place& a, const Place& b) {
  const dvec3 by_slopes = 0.5 * (b.share - a.share) * (a.slope + b.slope);
  const double gap = glm::length(b.position - a.position - by_slopes);
  if (!std::isfinite(gap)) return kInfinity;
  return gap;
}

/// Whether slopes at two places differ by so much that they may explain the way between them by
/// chance: half of a cliff may rise as the mean of its slopes says.
bool may_be_chance(const Place& a, const Place& b, double least) {
  // An arc with these slopes at its ends is this high above its chord.
  return 0.125 * std::fabs(b.share - a.share) * glm::length(b.slope - a.slope) > least;
}

/// Takes a place in the middle of the rest. Returns whether the search is done.
bool take_middle(CliffSearch& search, const Place& place, double least) {
  const std::array gaps = {unexplained(search.ends[0], place), unexplained(place, search.ends[1])};
  if (std::max(gaps[0], gaps[1]) <= least) return true;  // there is none
  if (std::min(gaps[0], gaps[1]) > least) {
    search.on_cliff = place;
    return true;
  }
  search.replaced = gaps[0] > gaps[1] ? 1 : 0;
  if (may_be_chance(place, search.ends[search.replaced], least)) {
    search.doubted = place;
  } else {
    search.ends[search.replaced] = place;
  }
  return false;
}

/// Takes a place in the middle of the doubted part. Returns whether the search is done.
bool take_doubted(CliffSearch& search, const Place& place, double least) {
  const Place doubted = *search.doubted;
  search.doubted.reset();
  Place& end = search.ends[search.replaced];
  const bool is_smooth = std::max(unexplained(doubted, place), unexplained(place, end)) <= least;
  (is_smooth ? end : search.on_cliff.emplace()) = doubted;
  return !is_smooth;
}

/// Halves the lines until their middles are on cliffs. `open`: the lines that may have a cliff.
void halve_to_cliffs(const Surface& surface, double delta, std::vector<CliffSearch>& searches,
                     std::vector<std::size_t>& open, std::size_t& work) {
  std::vector<std::size_t> found = open;
  const auto next = [](const CliffSearch& search) { return search.at(search.next()); };
  const auto is_done = [&](CliffSearch& search, const dvec2&, const SurfacePoint& point) {
    ++work;
    const Place place = search.place(search.next(), point);
    const double least = kUnnoticed * delta;
    return search.doubted ? take_doubted(search, place, least) : take_middle(search, place, least);
  };
  bisect_together(surface, searches, open, {kHalvingsToEdge}, next, is_done);
  std::erase_if(found, [&](std::size_t k) { return !searches[k].on_cliff; });
  open = std::move(found);
}

/// How far the surface goes on a sheet beside the cliff while the share of the line grows by 1.
double speed_beside(const CliffSearch& search) {
  return std::min(glm::length(search.ends[0].slope), glm::length(search.ends[1].slope));
}

/// The way from a sheet to the cliff, of which the end of the sheet is wanted.
struct SheetSearch {
  const CliffSearch* cliff;
  Place sheet;
  double last, beyond;  ///< shares: on the sheet's tangent, and not
};

/// Moves ends of searches to where the sheets leave their tangents.
void find_ends(const Surface& surface, double delta, std::vector<CliffSearch>& searches,
               std::span<const std::size_t> numbers, std::size_t& work) {
  std::vector<SheetSearch> sheets;
  for (const std::size_t k : numbers) {
    for (const Place& end : searches[k].ends)
      sheets.push_back({&searches[k], end, end.share, searches[k].on_cliff->share});
  }
  std::vector<std::size_t> open = all_open(sheets.size());
  const auto next = [](const SheetSearch& search) {
    return search.cliff->at(0.5 * (search.last + search.beyond));
  };
  const auto is_done = [&](SheetSearch& search, const dvec2&, const dvec3& position) {
    ++work;
    const double share = 0.5 * (search.last + search.beyond);
    const dvec3 on_tangent =
        search.sheet.position + (share - search.sheet.share) * search.sheet.slope;
    (glm::distance(position, on_tangent) <= kOnTangent * delta ? search.last : search.beyond) =
        share;
    const double way = std::fabs(search.cliff->on_cliff->share - search.last);
    return std::fabs(search.beyond - search.last) <= kNearEnd * way;
  };
  bisect_together(surface, sheets, open, {kHalvingsToEdge}, next, is_done);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    CliffSearch& search = searches[numbers[i]];
    const std::array found = {sheets[2 * i].last, sheets[2 * i + 1].last};
    // An end of the line that is as steep as the cliff is on the cliff, and not on a sheet.
    const double rise = glm::distance(search.ends[0].position, search.ends[1].position);
    const auto is_on_cliff = [&](const Place& end) {
      const bool is_end_of_line = end.share == 0 || end.share == 1;
      return is_end_of_line && glm::length(end.slope) * (found[1] - found[0]) > rise;
    };
    for (std::size_t end = 0; end < 2; ++end) {
      if (!is_on_cliff(search.ends[end])) search.ends[end].share = found[end];
    }
  }
}

/// Makes a cliff long enough to have two ends on its line: a narrower one takes in a little of the
/// sheets beside it.
void widen(CliffSearch& search) {
  const double least = 0.5 * kNearly;
  const double middle = search.middle();
  search.ends[0].share = std::max(0.0, std::min(search.ends[0].share, middle - least));
  search.ends[1].share = std::min(1.0, std::max(search.ends[1].share, middle + least));
  if (search.ends[0].share < least) search.ends[0].share = 0;
  if (search.ends[1].share > 1 - least) search.ends[1].share = 1;
}

/// Whether a cliff goes from sheet to sheet, and not toward a pole. `way`: from its first to its
/// last place.
bool is_between_sheets(const CliffSearch& search, const dvec3& way) {
  const double width = search.ends[1].share - search.ends[0].share;
  return std::ranges::all_of(search.ends, [&](const Place& end) {
    return glm::length(end.slope) * width <= kSteepestEnd * glm::length(way);
  });
}

/// Whether places are on the segment between the first and the last one.
bool is_straight(std::span<const dvec3> positions, double delta) {
  return std::ranges::all_of(positions, [&](const dvec3& p) {
    return distance_from_segment(positions.front(), positions.back(), p) <= kUnnoticed * delta;
  });
}

/// The numbers of places between which others are on segments, as few as there may be from the
/// first on; none if that takes too many segments, or where three places in a row are on none, as
/// on the way to a pole.
std::vector<std::size_t> ends_of_segments(std::span<const dvec3> positions, double delta) {
  constexpr std::size_t kLeast = 3;
  std::vector<std::size_t> ends = {0};
  while (ends.back() + 1 < positions.size()) {
    const std::size_t first = std::min(ends.back(), positions.size() - kLeast);
    std::size_t count = kLeast;
    while (first + count < positions.size() &&
           is_straight(positions.subspan(first, count + 1), delta))
      ++count;
    const bool is_confirmed = count > kLeast || is_straight(positions.subspan(first, count), delta);
    if (ends.size() > kMostSegments || !is_confirmed) return {};
    ends.push_back(first + count - 1);
  }
  return ends;
}

/// Even shares of the way from the first to the last place of a cliff.
double share_on(const CliffSearch& search, std::size_t k, std::size_t count) {
  if (k == 0 || k + 1 == count) return search.ends[k == 0 ? 0 : 1].share;
  const double share = static_cast<double>(k) / static_cast<double>(count - 1);
  return glm::mix(search.ends[0].share, search.ends[1].share, share);
}

/// Whether a cliff that reaches an end of its line goes on there as a sheet, or rises on in the
/// same direction: a vertex may be on the cliff. The flank of a needle turns back. At an edge of
/// the domain there is nothing beyond.
bool goes_on_beyond(const Surface& surface, const CliffSearch& search, double delta,
                    std::size_t& work) {
  const ParameterBox domain = box_of(surface.domain);
  const double width = search.ends[1].share - search.ends[0].share;
  for (const double end : {0.0, 1.0}) {
    if (search.ends[end == 0 ? 0 : 1].share != end) continue;
    const double share = end == 0 ? -width : 1 + width;
    const dvec2 beyond = search.at(share);
    if (nearest_in(domain, beyond) != beyond) continue;
    const std::vector<SurfacePoint> points =
        evaluate(surface, std::array{beyond, search.at(end)}, 1);
    work += points.size();
    const Place sheet = search.place(share, points[0]);
    const dvec3 way = (end - share) * sheet.slope;
    const dvec3 rest = sheet.position + way - points[1].position;
    const dvec3 to_end = points[1].position - search.ends[end == 0 ? 1 : 0].position;
    if (!(glm::length(rest) <= kUnnoticed * delta || glm::dot(rest, to_end) > 0)) return false;
  }
  return true;
}

/// Positions at even shares of cliffs, one cliff after the other.
std::vector<dvec3> positions_on(const Surface& surface, std::span<const CliffSearch> searches,
                                std::span<const std::size_t> numbers, std::size_t count,
                                std::size_t& work) {
  std::vector<dvec2> uv;
  for (const std::size_t k : numbers) {
    for (std::size_t i = 0; i < count; ++i)
      uv.push_back(searches[k].at(share_on(searches[k], i, count)));
  }
  work += uv.size();
  return evaluate_positions(surface, uv, 1);
}

/// The cliff of a search, with places at even shares, of which the numbers are given.
Cliff cliff_at(const CliffSearch& search, std::span<const std::size_t> numbers, std::size_t count) {
  Cliff cliff;
  for (const std::size_t k : numbers) {
    const double share = share_on(search, k, count);
    cliff.push_back(share == 0 ? search.line[0] : share == 1 ? search.line[1] : search.at(share));
  }
  return cliff;
}

std::vector<Cliff> cliffs_of_some(const Surface& surface, std::span<const Line> lines, double delta,
                                  std::size_t& work) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) uv.insert(uv.end(), line.begin(), line.end());
  const std::vector<SurfacePoint> at_ends = evaluate(surface, uv, 1);
  work += uv.size();
  std::vector<CliffSearch> searches;
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    CliffSearch search{lines[k], {}};
    search.ends = {search.place(0, at_ends[2 * k]), search.place(1, at_ends[2 * k + 1])};
    const double gap = unexplained(search.ends[0], search.ends[1]);
    if (gap > delta && gap < kInfinity) open.push_back(k);
    searches.push_back(search);
  }
  std::vector<Cliff> cliffs(lines.size());
  halve_to_cliffs(surface, delta, searches, open, work);
  if (open.empty()) return cliffs;
  find_ends(surface, delta, searches, open, work);
  for (const std::size_t k : open) widen(searches[k]);
  // While a cliff rises, the sheets beside it go on by delta at most: leaves show wider ones.
  std::erase_if(open, [&](std::size_t k) {
    const double width = searches[k].ends[1].share - searches[k].ends[0].share;
    return width > kLongestCliff || !(speed_beside(searches[k]) * width <= delta);
  });
  std::vector<std::size_t> curved;
  const auto add_from = [&](std::span<const std::size_t> numbers, std::size_t count,
                            const auto& ends_of) {
    const auto positions = positions_on(surface, searches, numbers, count, work);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto on_cliff = std::span(positions).subspan(i * count, count);
      const CliffSearch& search = searches[numbers[i]];
      const dvec3 way = on_cliff.back() - on_cliff.front();
      if (!(glm::length(way) > delta)) continue;
      cliffs[numbers[i]] = cliff_at(search, ends_of(numbers[i], on_cliff), count);
    }
  };
  add_from(open, kPlacesOnCliff, [&](std::size_t k, std::span<const dvec3> on_cliff) {
    const bool has_sheets = is_between_sheets(searches[k], on_cliff.back() - on_cliff.front());
    if (has_sheets && is_straight(on_cliff, delta))
      return std::vector<std::size_t>{0, kPlacesOnCliff - 1};
    curved.push_back(k);
    return std::vector<std::size_t>{};
  });
  std::erase_if(curved,
                [&](std::size_t k) { return !goes_on_beyond(surface, searches[k], delta, work); });
  add_from(curved, kPlacesOnSegments, [&](std::size_t, std::span<const dvec3> on_cliff) {
    return ends_of_segments(on_cliff, delta);
  });
  return cliffs;
}

}  // namespace

std::vector<Cliff> find_cliffs(const Surface& surface, std::span<const Line> lines, double delta,
                               unsigned threads, std::size_t& work) {
  return search_chunks(lines, kInBatch / 2, threads, work,
                       [&](std::span<const Line> some, std::size_t& own) {
                         return cliffs_of_some(surface, some, delta, own);
                       });
}

}  // namespace saddle
