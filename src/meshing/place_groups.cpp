#include "meshing/place_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/format.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// A line is told in parts where nothing is found on more than this share of its range. A line of
/// so many places is on a mesh of at least as many cells.
constexpr double kGapOfLine = 2.5 / kManyOfLine;

using Indices = std::vector<std::size_t>;

/// Lengths of the ranges of u and v.
dvec2 extents(const Domain& d) {
  return glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0));
}

/// The most members whose parameter `axis` is within kNearly of each other, as a part of its range.
PlaceGroup longest_line(std::span<const dvec2> places, const Indices& left, int axis,
                        double extent) {
  Indices sorted = left;
  std::ranges::sort(sorted, {}, [&](std::size_t k) { return places[k][axis]; });
  std::ptrdiff_t best = 0;
  std::ptrdiff_t best_begin = 0;
  for (std::ptrdiff_t begin = 0, end = 0; begin < std::ssize(sorted); ++begin) {
    const auto at = [&](std::ptrdiff_t k) {
      return places[sorted[static_cast<std::size_t>(k)]][axis];
    };
    while (end < std::ssize(sorted) && at(end) - at(begin) <= kNearly * extent) ++end;
    if (end - begin > best) {
      best = end - begin;
      best_begin = begin;
    }
  }
  Indices members(sorted.begin() + best_begin, sorted.begin() + best_begin + best);
  std::ranges::sort(members);
  PlaceGroup group(places, std::move(members));
  // Places where another line crosses belong to both.
  for (const dvec2& place : places) {
    if (std::fabs(place[axis] - group.low[axis]) > kNearly * extent) continue;
    group.low = glm::min(group.low, place);
    group.high = glm::max(group.high, place);
  }
  double sum = 0;
  for (const std::size_t k : group.members) sum += places[k][axis];
  double middle = sum / static_cast<double>(std::max<std::ptrdiff_t>(best, 1));
  if (std::fabs(middle) < kNearly * extent) middle = 0;
  group.low[axis] = group.high[axis] = middle;
  return group;
}

/// Whether places follow one another along a line. Many curves that cross a line of the grid have
/// places on it, too, but each has a nearer one on the same curve.
bool is_line(std::span<const dvec2> places, const PlaceGroup& group, const dvec2& extent) {
  const int along = group.low.x == group.high.x ? 1 : 0;
  std::vector<std::uint8_t> is_member(places.size(), 0);
  for (const std::size_t k : group.members) is_member[k] = 1;
  Indices sorted = indices_of(places.size());
  std::ranges::sort(sorted, {}, [&](std::size_t k) { return places[k][along]; });
  std::size_t in_line = 0;
  for (std::size_t at = 0; at < sorted.size(); ++at) {
    const std::size_t k = sorted[at];
    if (is_member[k] == 0) continue;
    std::array<double, 2> nearest;  // squares: of another curve, of the line
    nearest.fill(std::numeric_limits<double>::infinity());
    // False if all further ones are farther apart along the line alone.
    const auto look_at = [&](std::size_t other) {
      const dvec2 way = (places[other] - places[k]) / extent;
      double& least = nearest[is_member[other]];
      least = std::min(least, glm::dot(way, way));
      return way[along] * way[along] <= std::max(nearest[0], nearest[1]);
    };
    for (std::size_t next = at + 1; next < sorted.size() && look_at(sorted[next]); ++next) {
    }
    for (std::size_t next = at; next-- > 0 && look_at(sorted[next]);) {
    }
    in_line += nearest[1] < nearest[0] ? 1 : 0;
  }
  return 2 * in_line > group.members.size();
}

/// The parts of a line between its gaps: a branch cut may end, and go on further away.
std::vector<PlaceGroup> parts_of_line(std::span<const dvec2> places, const PlaceGroup& line,
                                      const dvec2& extent) {
  const int along = line.low.x == line.high.x ? 1 : 0;
  Indices sorted = line.members;
  std::ranges::sort(sorted, {}, [&](std::size_t k) { return places[k][along]; });
  std::vector<PlaceGroup> parts;
  PlaceGroup part = line;
  part.members.clear();
  for (const std::size_t k : sorted) {
    if (!part.members.empty()) {
      const double last = places[part.members.back()][along];
      if (places[k][along] - last > kGapOfLine * extent[along]) {
        part.high[along] = last;
        parts.push_back(part);
        part = line;
        part.members.clear();
        part.low[along] = places[k][along];
      }
    }
    part.members.push_back(k);
  }
  parts.push_back(part);
  return parts;
}

/// The lines, if there are so many that they are counted.
std::span<const double> counted(std::span<const double> lines) {
  return lines.size() > kToldGroups ? lines : std::span<const double>();
}

std::string text_of_lines(std::span<const double> lines, int axis, const Domain& domain,
                          int digits) {
  const std::string& name = domain.names[static_cast<std::size_t>(axis)];
  std::string text =
      std::to_string(lines.size()) + " lines of constant " + name + ", " + name + " =";
  for (const double line : lines.first(kToldGroups)) {
    const double near_0 = kSame * extents(domain)[axis];
    text += " " + rounded(std::fabs(line) < near_0 ? 0 : line, digits) + ",";
  }
  text.back() = ' ';
  return text + "and others";
}

bool is_on(std::span<const double> lines, double place, double extent) {
  const auto next = std::ranges::lower_bound(lines, place - kNearly * extent);
  return next != lines.end() && *next <= place + kNearly * extent;
}

}  // namespace

PlaceGroup::PlaceGroup(std::span<const dvec2> places, Indices indices)
    : low(places[indices.front()]), high(low), members(std::move(indices)) {
  for (const std::size_t k : members) {
    low = glm::min(low, places[k]);
    high = glm::max(high, places[k]);
  }
}

std::string range_text(const std::string& name, double low, double high, int digits) {
  const std::string from = rounded(low, digits);
  const std::string to = rounded(high, digits);
  return name + " = " + from + (from == to ? "" : ":" + to);
}

std::string full_range_text(const std::string& name, double low, double high) {
  int digits = kToldDigits;
  while (digits < std::numeric_limits<double>::max_digits10 &&
         rounded(low, digits) == rounded(high, digits))
    ++digits;
  return range_text(name, low, high, digits);
}

std::string PlaceGroup::text(const Domain& domain, int digits) const {
  const bool is_box = low.x < high.x && low.y < high.y;
  return (is_box ? "within " : "") + range_text(domain.names[0], low.x, high.x, digits) + ", " +
         range_text(domain.names[1], low.y, high.y, digits);
}

Indices indices_of(std::size_t count) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

dvec2 without_rounding(dvec2 place, const Domain& domain, double rounding) {
  const dvec2 near = rounding * extents(domain);
  for (int k = 0; k < 2; ++k) {
    if (std::fabs(place[k]) < near[k]) place[k] = 0;
  }
  return place;
}

std::vector<dvec2> distinct_places(std::span<const dvec2> places, const Domain& domain) {
  const dvec2 near = kSame * extents(domain);
  std::vector<dvec2> result;
  std::vector<dvec2> sorted;  // the same by u
  for (const dvec2& found : places) {
    const dvec2 place = without_rounding(found, domain, kSame);
    const auto u_of = [](const dvec2& other) { return other.x; };
    const auto first = std::ranges::lower_bound(sorted, place.x - near.x, {}, u_of);
    const auto last = std::ranges::upper_bound(first, sorted.end(), place.x + near.x, {}, u_of);
    const auto is_same = [&](const dvec2& other) { return std::fabs(place.y - other.y) <= near.y; };
    if (std::any_of(first, last, is_same)) continue;
    result.push_back(place);
    sorted.insert(std::ranges::upper_bound(first, last, place.x, {}, u_of), place);
  }
  return result;
}

std::vector<PlaceGroup> take_lines(std::span<const dvec2> places, const Domain& domain,
                                   Indices& left) {
  const dvec2 extent = extents(domain);
  std::vector<PlaceGroup> lines;
  Indices candidates = left;
  while (candidates.size() >= kManyOfLine) {
    const PlaceGroup along_v = longest_line(places, candidates, 0, extent.x);
    const PlaceGroup along_u = longest_line(places, candidates, 1, extent.y);
    const PlaceGroup& longer = along_v.members.size() > along_u.members.size() ? along_v : along_u;
    if (longer.members.size() < kManyOfLine) break;
    const auto is_member = [&](std::size_t k) {
      return std::ranges::binary_search(longer.members, k);
    };
    std::erase_if(candidates, is_member);
    if (!is_line(places, longer, extent)) continue;
    std::erase_if(left, is_member);
    std::ranges::move(parts_of_line(places, longer, extent), std::back_inserter(lines));
  }
  return lines;
}

std::vector<PlaceGroup> one_by_one(std::span<const dvec2> places, const Indices& which) {
  if (which.size() > kToldGroups) return {PlaceGroup(places, which)};
  std::vector<PlaceGroup> groups;
  for (const std::size_t k : which) groups.emplace_back(places, Indices{k});
  return groups;
}

std::vector<PlaceGroup> grouped_places(std::span<const dvec2> places, const Domain& domain) {
  const std::vector<dvec2> distinct = distinct_places(places, domain);
  Indices left = indices_of(distinct.size());
  std::vector<PlaceGroup> groups = take_lines(distinct, domain, left);
  const std::vector<PlaceGroup> others = one_by_one(distinct, left);
  groups.insert(groups.end(), others.begin(), others.end());
  return groups;
}

std::string text_of(std::span<const PlaceGroup> groups, bool has_others, const Domain& domain,
                    int digits) {
  std::string text;
  for (const PlaceGroup& group : groups.first(std::min(groups.size(), kToldGroups))) {
    text += (text.empty() ? "" : "; ") + group.text(domain, digits);
  }
  return text + (has_others || groups.size() > kToldGroups ? "; and others" : "");
}

ToldCuts::ToldCuts(std::span<const dvec2> places, const ParameterLines& lines, const Domain& domain)
    : domain_(domain), lines_({counted(lines.u), counted(lines.v)}) {
  const dvec2 extent = extents(domain);
  std::vector<dvec2> beside(places.begin(), places.end());
  std::erase_if(beside, [&](const dvec2& place) {
    return is_on(lines_[0], place.x, extent.x) || is_on(lines_[1], place.y, extent.y);
  });
  groups_ = grouped_places(beside, domain);
}

std::optional<std::size_t> ToldCuts::points() const {
  if (!lines_[0].empty() || !lines_[1].empty()) return std::nullopt;
  return std::ranges::all_of(groups_, &PlaceGroup::is_point) ? std::optional(groups_.size())
                                                             : std::nullopt;
}

std::array<dvec2, 2> ToldCuts::box() const {
  const std::array<dvec2, 2> ends = {domain_.at(dvec2(0)), domain_.at(dvec2(1))};
  dvec2 low(std::numeric_limits<double>::infinity());
  dvec2 high = -low;
  const auto add = [&](const dvec2& place) {
    low = glm::min(low, place);
    high = glm::max(high, place);
  };
  for (const PlaceGroup& group : groups_) {
    add(group.low);
    add(group.high);
  }
  for (const int axis : {0, 1}) {
    const std::span<const double> lines = lines_[static_cast<std::size_t>(axis)];
    if (lines.empty()) continue;
    for (dvec2 end : ends) {
      for (const double line : {lines.front(), lines.back()}) {
        end[axis] = line;
        add(end);
      }
    }
  }
  return {low, high};
}

std::string ToldCuts::text(bool has_others, int digits) const {
  std::string text;
  const auto tell = [&text](const std::string& more) {
    text += (text.empty() || more.empty() ? "" : "; ") + more;
  };
  for (const int axis : {0, 1}) {
    const std::span<const double> lines = lines_[static_cast<std::size_t>(axis)];
    if (!lines.empty()) tell(text_of_lines(lines, axis, domain_, digits));
  }
  // Places that are not listed are on the lines, too.
  if (!groups_.empty()) tell(text_of(groups_, has_others, domain_, digits));
  return text;
}

}  // namespace saddle
