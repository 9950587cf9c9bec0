#include "app/report/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <glm/vector_relational.hpp>

#include "base/format.h"

namespace saddle::words {

namespace {

/// Parameters this close, as a part of the range, are on one line.
constexpr double kSameLine = 1e-6;
/// And this close, of their size, they are the same but for rounding.
constexpr double kSameParameters = 1e-12;
/// Cuts this close, as a part of the range, are one place; points, of the diagonal, are one.
constexpr double kSamePlace = 1e-9;
/// Components of normals below this are what limits lost.
constexpr double kLostOfNormals = 1e-9;
/// Coordinates below this, in diagonals, are rounding errors.
constexpr double kRounding = 1e-12;
/// Digits of numbers.
constexpr int kDigits = 6;
/// At least so many places on a line of constant u or v, or at one point, are reported as one.
constexpr std::size_t kLine = 12;
/// Places and lines that are told one by one.
constexpr std::size_t kTold = 6;

using Places = std::vector<dvec2>;
using Indices = std::vector<std::size_t>;

Indices all_of(std::size_t count) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

/// Takes those that belong.
template <class Belongs>
Indices take(Indices& from, Belongs belongs) {
  Indices taken;
  std::ranges::copy_if(from, std::back_inserter(taken), belongs);
  std::erase_if(from, belongs);
  return taken;
}

/// Places that are told as one.
struct Group {
  Extremes u, v;
  Indices members;

  Group(const Places& places, Indices indices) : members(std::move(indices)) {
    for (const std::size_t k : members) {
      u.add(places[k].x);
      v.add(places[k].y);
    }
  }
  std::string text() const { return range("u", u.low, u.high) + ", " + range("v", v.low, v.high); }
};

/// The most members whose parameter `axis` is within kSameLine of each other.
Group longest_line(const Places& places, const Indices& left, int axis, double extent) {
  Indices sorted = left;
  std::ranges::sort(sorted, {}, [&](std::size_t k) { return places[k][axis]; });
  std::ptrdiff_t best = 0;
  std::ptrdiff_t best_begin = 0;
  for (std::ptrdiff_t begin = 0, end = 0; begin < std::ssize(sorted); ++begin) {
    const auto at = [&](std::ptrdiff_t k) {
      return places[sorted[static_cast<std::size_t>(k)]][axis];
    };
    while (end < std::ssize(sorted) && at(end) - at(begin) <= kSameLine * extent) ++end;
    if (end - begin > best) {
      best = end - begin;
      best_begin = begin;
    }
  }
  Group group(places, {sorted.begin() + best_begin, sorted.begin() + best_begin + best});
  double sum = 0;
  for (const std::size_t k : group.members) sum += places[k][axis];
  double middle = sum / static_cast<double>(std::max<std::ptrdiff_t>(best, 1));
  if (std::fabs(middle) < kSameLine * extent) middle = 0;
  (axis == 0 ? group.u : group.v) = {middle, middle};
  return group;
}

/// Takes lines of many places, the longest before the others.
std::vector<Group> take_lines(const Places& places, const Domain& d, Indices& left) {
  std::vector<Group> lines;
  while (left.size() >= kLine) {
    const Group along_v = longest_line(places, left, 0, std::fabs(d.u1 - d.u0));
    const Group along_u = longest_line(places, left, 1, std::fabs(d.v1 - d.v0));
    const Group& longer = along_v.members.size() > along_u.members.size() ? along_v : along_u;
    if (longer.members.size() < kLine) break;
    take(left, [&](std::size_t k) {
      return std::ranges::find(longer.members, k) != longer.members.end();
    });
    lines.push_back(longer);
  }
  return lines;
}

/// Each of some places, or all as one if they are many.
std::vector<Group> one_by_one(const Places& places, const Indices& which) {
  if (which.size() > kTold) return {Group(places, which)};
  std::vector<Group> groups;
  for (const std::size_t k : which) groups.emplace_back(places, Indices{k});
  return groups;
}

void append(std::vector<Group>& to, const std::vector<Group>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// How far places are from each other that are one.
dvec2 same_place(const Domain& d) {
  return kSamePlace * glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0));
}

/// A place beside 0, at 0.
dvec2 clean(dvec2 place, const Domain& d) {
  for (int k = 0; k < 2; ++k) {
    if (std::fabs(place[k]) < same_place(d)[k]) place[k] = 0;
  }
  return place;
}

/// Places that bisections from many sides ended at, each once.
Places distinct(std::span<const dvec2> places, const Domain& d) {
  const dvec2 near = same_place(d);
  Places result;
  for (const dvec2& found : places) {
    const dvec2 place = clean(found, d);
    const auto is_same = [&](const dvec2& other) {
      return glm::all(glm::lessThanEqual(glm::abs(place - other), near));
    };
    if (std::ranges::none_of(result, is_same)) result.push_back(place);
  }
  return result;
}

/// How the singular places of a surface belong together.
class SingularWords {
 public:
  SingularWords(const Facts& facts, double diagonal) : facts_(facts), diagonal_(diagonal) {
    // Where v depends on u and its ends meet, many places of the surface have the same u and v.
    for (const SingularPlace& place : facts.singular) {
      const auto is_same = [&](const dvec2& uv) {
        return glm::distance(uv, place.uv) <= kSameParameters * glm::length(place.uv);
      };
      if (std::ranges::any_of(at_, is_same) || is_on_another_side(place)) continue;
      at_.push_back(clean(place.uv, facts.domain));
      places_.push_back(&place);
    }
  }

  std::string text() const {
    if (places_.empty()) return "none";
    Indices left = all_of(places_.size());
    Indices single = take(left, [&](std::size_t k) { return places_[k]->is_alone; });
    std::vector<Group> lines = take_known_lines(left);
    std::vector<Group> curves = take_points(left);
    append(lines, take_lines(at_, facts_.domain, left));
    if (left.size() > kTold) {
      curves.emplace_back(at_, left);
    } else {
      single.insert(single.end(), left.begin(), left.end());
    }
    return joined({sentence(plural(lines.size(), "line"), lines), sentence("curves", curves),
                   sentence(plural(single.size(), "point"), one_by_one(at_, single))});
  }

 private:
  /// Takes the lines of constant u or v that are singular from one end to the other.
  std::vector<Group> take_known_lines(Indices& left) const {
    const Domain& d = facts_.domain;
    const Extremes ends_u = {std::min(d.u0, d.u1), std::max(d.u0, d.u1)};
    const Extremes ends_v = {std::min(d.v0, d.v1), std::max(d.v0, d.v1)};
    std::vector<Group> lines;
    const auto take_line = [&](int axis, double line, const Extremes& u, const Extremes& v) {
      const double near =
          kSameLine * (axis == 0 ? ends_u.high - ends_u.low : ends_v.high - ends_v.low);
      Group group(
          at_, take(left, [&](std::size_t k) { return std::fabs(at_[k][axis] - line) <= near; }));
      if (group.members.empty()) return;
      group.u = u;
      group.v = v;
      lines.push_back(group);
    };
    for (const double u : facts_.singular_u) take_line(0, u, {u, u}, ends_v);
    for (const double v : facts_.singular_v) take_line(1, v, ends_u, {v, v});
    return lines;
  }

  /// Where edges of the domain join, a point on them is one place with two parameters.
  bool is_on_another_side(const SingularPlace& place) const {
    const Domain& d = facts_.domain;
    const dvec2 near = kSameLine * glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0));
    const auto is_end = [&](const dvec2& uv, int axis) {
      return std::fabs(uv[axis] - dvec2(d.u0, d.v0)[axis]) <= near[axis] ||
             std::fabs(uv[axis] - dvec2(d.u1, d.v1)[axis]) <= near[axis];
    };
    return place.is_alone && std::ranges::any_of(places_, [&](const SingularPlace* other) {
             const bool both_on_edges = (is_end(place.uv, 0) && is_end(other->uv, 0)) ||
                                        (is_end(place.uv, 1) && is_end(other->uv, 1));
             return other->is_alone && both_on_edges &&
                    glm::distance(place.position, other->position) <= kSamePlace * diagonal_;
           });
  }

  double distance(std::size_t a, std::size_t b) const {
    return glm::distance(places_[a]->position, places_[b]->position);
  }

  /// Takes what is one point of space in many places.
  std::vector<Group> take_points(Indices& left) const {
    std::vector<Group> groups;
    Indices others = left;
    while (!others.empty()) {
      const std::size_t first = others.front();
      const Indices here = take(others, [&](std::size_t k) {
        // A place without a position has no distance to itself either.
        return k == first || distance(k, first) <= kSamePlace * diagonal_;
      });
      if (here.size() >= kLine) groups.emplace_back(at_, here);
    }
    for (const Group& group : groups) {
      take(left, [&](std::size_t k) {
        return std::ranges::find(group.members, k) != group.members.end();
      });
    }
    return groups;
  }

  /// The group's point, if it is one, and the normals there.
  std::string point_and_normal(const Group& group) const {
    const SingularPlace& first = *places_[group.members.front()];
    bool one_point = true;
    bool one_normal = true;
    bool all_alone = true;
    std::size_t without = 0;
    for (const std::size_t k : group.members) {
      const SingularPlace& place = *places_[k];
      one_point &= glm::distance(place.position, first.position) <= kSamePlace * diagonal_;
      one_normal &= place.normals.size() == 1 && first.normals.size() == 1 &&
                    degrees_between(place.normals[0], first.normals[0]) <= kSameDegrees;
      all_alone &= place.is_alone;
      without += place.normals.empty() ? 1 : 0;
    }
    std::string text;
    if (one_point) text += " is the point " + vector(first.position, kRounding * diagonal_);
    const std::string verb = one_point                               ? " with"
                             : all_alone && group.members.size() > 1 ? " have"
                                                                     : " has";
    if (one_normal) return text + verb + " the normal " + vector(first.normals[0], kLostOfNormals);
    if (without == group.members.size()) return text + verb + " no normal";
    if (without > 0) {
      return text + verb + " limits of the normal but for " + plural(without, "place");
    }
    return text + verb + " a normal on each " + (all_alone ? "way there" : "side");
  }

  std::string sentence(const std::string& what, const std::vector<Group>& groups) const {
    std::string text;
    for (std::size_t k = 0; k < std::min(groups.size(), kTold); ++k) {
      text += (k == 0 ? what + ": " : "; ") + groups[k].text() + point_and_normal(groups[k]);
    }
    return groups.size() > kTold ? text + "; and others" : text;
  }

  static std::string joined(const std::array<std::string, 3>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) {
      if (!sentence.empty()) text += (text.empty() ? "" : ". ") + sentence;
    }
    return text;
  }

  const Facts& facts_;
  double diagonal_;
  Places at_;
  std::vector<const SingularPlace*> places_;
};

/// "2 lines: u = 1, v = 0:1; u = 2, v = 0:1".
std::string listed_groups(const std::string& what, const std::vector<Group>& groups) {
  std::string text = what;
  for (std::size_t k = 0; k < std::min(groups.size(), kTold); ++k) {
    text += (k > 0 ? "; " : what.ends_with("within") ? " " : ": ") + groups[k].text();
  }
  return groups.size() > kTold ? text + "; and others" : text;
}

/// A number to three digits, rounded in a direction.
std::string outward(double value, double direction) {
  if (value == 0) return "0";
  const double unit = std::pow(10, std::floor(std::log10(std::fabs(value))) - 2);
  const double steps = direction > 0 ? std::ceil(value / unit) : std::floor(value / unit);
  return number(steps * unit);
}

}  // namespace

std::string number(double value) {
  return rounded(value, kDigits);
}

std::string number(const Estimate& estimate) {
  const double share = estimate.error / std::fabs(estimate.value);
  const double known = share > 0 ? std::floor(-std::log10(2 * share)) : kDigits;
  if (share >= 1) return "0 within " + outward(std::fabs(estimate.value) + estimate.error, 1);
  if (known >= kDigits || !std::isfinite(known)) return number(estimate.value);
  const std::string digits = rounded(estimate.value, static_cast<int>(std::max(known, 1.0)));
  return "about " + number(std::strtod(digits.c_str(), nullptr));
}

std::string measure(const Estimate& estimate, double size, int dimension) {
  // Areas are roots of products of four lengths, volumes products of three by three.
  const double least = std::pow(size, 2 * dimension);
  if (estimate.value == 0 && !std::isnormal(least)) return "too small for doubles";
  return number(estimate);
}

std::string plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string range(const std::string& name, double low, double high) {
  if (low == high) return name + " = " + number(low);
  return name + " = " + number(low) + ":" + number(high);
}

std::string near(const dvec2& uv, const Domain& domain) {
  const dvec2 place = clean(uv, domain);
  return "near " + range("u", place.x, place.x) + ", " + range("v", place.y, place.y);
}

std::string found(const ValueRange& r, double rounding, const Domain& domain) {
  const auto end = [rounding](double x) { return number(std::fabs(x) <= rounding ? 0 : x); };
  if (!r.falls_toward && !r.grows_toward) return end(r.low) + " to " + end(r.high);
  std::string text;
  if (r.falls_toward && !r.grows_toward) text = "at most " + end(r.high) + ", ";
  if (r.grows_toward && !r.falls_toward) text = "at least " + end(r.low) + ", ";
  if (r.falls_toward) text += "falls without a bound " + near(*r.falls_toward, domain);
  if (r.falls_toward && r.grows_toward) text += ", ";
  if (r.grows_toward) text += "grows without a bound " + near(*r.grows_toward, domain);
  return text;
}

std::string proved(const ValueRange& r, double rounding) {
  const bool has_low = std::isfinite(r.bounds.low);
  const bool has_high = std::isfinite(r.bounds.high);
  if (!has_low && !has_high) return "";
  if (r.low - r.bounds.low <= rounding && r.bounds.high - r.high <= rounding) return "exact";
  const std::string low = has_low ? outward(r.bounds.low, -1) : "";
  const std::string high = has_high ? outward(r.bounds.high, 1) : "";
  if (!has_low) return "at most " + high;
  if (!has_high) return "at least " + low;
  return "within " + low + " to " + high;
}

std::string vector(const dvec3& v, double rounding) {
  const auto part = [&](double x) { return number(std::fabs(x) < rounding ? 0 : x); };
  return "(" + part(v.x) + ", " + part(v.y) + ", " + part(v.z) + ")";
}

std::string cuts(std::span<const dvec2> listed, std::size_t count, const Domain& domain) {
  if (count == 0) return "none";
  const Places told = distinct(listed, domain);
  Indices left = all_of(told.size());
  const std::vector<Group> lines = take_lines(told, domain, left);
  const std::string text = lines.empty() ? "" : listed_groups(plural(lines.size(), "line"), lines);
  if (left.empty()) return text;
  // The sides of cells that a curve crosses say how fine the mesh is, not how many curves there
  // are.
  const bool are_few = left.size() <= kTold && count == listed.size();
  const std::string what = are_few ? plural(left.size(), "place") : "curves within";
  return (text.empty() ? "" : text + "; ") + listed_groups(what, one_by_one(told, left));
}

std::string jumps(const MeshReport& report, const Domain& domain) {
  const std::size_t torn = report.without_limit.size();
  if (torn == 0) return cuts(report.jumps, report.jump_count, domain);
  std::string text = "no limit at ";
  const std::vector<Group> points = one_by_one(report.without_limit, all_of(torn));
  for (std::size_t k = 0; k < points.size(); ++k) text += (k > 0 ? "; " : "") + points[k].text();
  if (report.jump_count == torn) return text;
  const auto others = std::span(report.jumps).subspan(torn);
  return cuts(others, report.jump_count - torn, domain) + "; " + text;
}

std::string singular(const Facts& facts, double diagonal) {
  return SingularWords(facts, diagonal).text();
}

}  // namespace saddle::words
