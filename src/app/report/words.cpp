#include "app/report/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "base/format.h"
#include "mesh/model/tolerances.h"
#include "meshing/place_groups.h"

namespace saddle::words {

namespace {

/// Parameters this close, of their size, are the same but for rounding.
constexpr double kSameParameters = 1e-12;
/// Points this close, as a part of the diagonal, are one.
constexpr double kSamePoint = kSame;
/// Components of normals below this are what limits lost.
constexpr double kLostOfNormals = 1e-9;
/// Coordinates below this, in diagonals, are rounding errors.
constexpr double kRounding = 1e-12;
/// Digits of numbers.
constexpr int kDigits = 6;
/// At least so many places at one point are told as curves that lead to it.
constexpr std::size_t kManyAtPoint = 12;

using Places = std::vector<dvec2>;
using Indices = std::vector<std::size_t>;

/// Takes those that belong.
template <class Belongs>
Indices take(Indices& from, Belongs belongs) {
  Indices taken;
  std::ranges::copy_if(from, std::back_inserter(taken), belongs);
  std::erase_if(from, belongs);
  return taken;
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
      if (std::ranges::any_of(at_, is_same)) continue;
      at_.push_back(without_rounding(place.uv, facts.domain, kSame));
      places_.push_back(&place);
    }
  }

  std::string text() const {
    if (places_.empty()) return "none";
    Indices left = indices_of(places_.size());
    Indices single = take(left, [&](std::size_t k) { return places_[k]->is_alone; });
    std::vector<PlaceGroup> lines = take_known_lines(left);
    std::vector<PlaceGroup> curves = take_points(left);
    std::ranges::copy(take_lines(at_, facts_.domain, left), std::back_inserter(lines));
    if (left.size() > kToldGroups) {
      curves.emplace_back(at_, left);
    } else {
      single.insert(single.end(), left.begin(), left.end());
    }
    return joined({sentence(plural(lines.size(), "line"), lines), sentence("curves", curves),
                   points(single)});
  }

 private:
  /// Takes the lines of constant u or v that are singular from one end to the other.
  std::vector<PlaceGroup> take_known_lines(Indices& left) const {
    const Domain& d = facts_.domain;
    const Extremes ends_u = {std::min(d.u0, d.u1), std::max(d.u0, d.u1)};
    const Extremes ends_v = {std::min(d.v0, d.v1), std::max(d.v0, d.v1)};
    std::vector<PlaceGroup> lines;
    const auto take_line = [&](int axis, double line, const Extremes& u, const Extremes& v) {
      const double near =
          kNearly * (axis == 0 ? ends_u.high - ends_u.low : ends_v.high - ends_v.low);
      const Indices here =
          take(left, [&](std::size_t k) { return std::fabs(at_[k][axis] - line) <= near; });
      if (here.empty()) return;
      PlaceGroup group(at_, here);
      group.low = {u.low, v.low};
      group.high = {u.high, v.high};
      lines.push_back(group);
    };
    for (const double u : facts_.singular_u) take_line(0, u, {u, u}, ends_v);
    for (const double v : facts_.singular_v) take_line(1, v, ends_u, {v, v});
    return lines;
  }

  double distance(std::size_t a, std::size_t b) const {
    return glm::distance(places_[a]->position, places_[b]->position);
  }

  /// Takes what is one point of space in many places.
  std::vector<PlaceGroup> take_points(Indices& left) const {
    std::vector<PlaceGroup> groups;
    Indices others = left;
    while (!others.empty()) {
      const std::size_t first = others.front();
      const Indices here = take(others, [&](std::size_t k) {
        // A place without a position has no distance to itself either.
        return k == first || distance(k, first) <= kSamePoint * diagonal_;
      });
      if (here.size() >= kManyAtPoint) groups.emplace_back(at_, here);
    }
    for (const PlaceGroup& group : groups) {
      take(left, [&](std::size_t k) {
        return std::ranges::find(group.members, k) != group.members.end();
      });
    }
    return groups;
  }

  /// The group's point, if it is one, and the normals there.
  std::string point_and_normal(const PlaceGroup& group) const {
    const SingularPlace& first = *places_[group.members.front()];
    bool one_point = true;
    bool one_normal = true;
    bool all_alone = true;
    std::size_t without = 0;
    for (const std::size_t k : group.members) {
      const SingularPlace& place = *places_[k];
      one_point &= glm::distance(place.position, first.position) <= kSamePoint * diagonal_;
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

  /// A place, and others of the same point of space.
  std::string text(const PlaceGroup& group, const Indices& others) const {
    std::string text = group.text(facts_.domain, kDigits);
    for (std::size_t k = 0; k < others.size(); ++k) {
      text +=
          (k == 0 ? " (also " : "; ") + PlaceGroup(at_, {others[k]}).text(facts_.domain, kDigits);
    }
    return text + (others.empty() ? "" : ")") + point_and_normal(group);
  }

  std::string sentence(const std::string& what, const std::vector<PlaceGroup>& groups) const {
    std::string text;
    for (std::size_t k = 0; k < std::min(groups.size(), kToldGroups); ++k) {
      text += (k == 0 ? what + ": " : "; ") + this->text(groups[k], {});
    }
    return groups.size() > kToldGroups ? text + "; and others" : text;
  }

  /// Single points of space, each with the places where it lies.
  std::string points(const Indices& places) const {
    Indices first;
    std::vector<Indices> others;
    for (const std::size_t k : places) {
      const auto same = std::ranges::find_if(
          first, [&](std::size_t f) { return distance(k, f) <= kSamePoint * diagonal_; });
      if (same != first.end()) {
        others[static_cast<std::size_t>(same - first.begin())].push_back(k);
      } else {
        first.push_back(k);
        others.emplace_back();
      }
    }
    const std::string count = plural(first.size(), "point");
    if (first.size() > kToldGroups) return sentence(count, one_by_one(at_, places));
    std::string all;
    for (std::size_t k = 0; k < first.size(); ++k) {
      all += (k == 0 ? count + ": " : "; ") + text(PlaceGroup(at_, {first[k]}), others[k]);
    }
    return all;
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
  return range_text(name, low, high, kDigits);
}

std::string near(const dvec2& uv, const Domain& domain) {
  const dvec2 place = without_rounding(uv, domain, kSame);
  return "near " + range(domain.names[0], place.x, place.x) + ", " +
         range(domain.names[1], place.y, place.y);
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

std::string cuts(std::span<const dvec2> listed, std::size_t count, const ParameterLines& lines,
                 const Domain& domain) {
  if (count == 0) return "none";
  const ToldCuts told(listed, lines, domain);
  const std::optional<std::size_t> points = told.points();
  return (points ? plural(*points, "place") + ": " : "") +
         told.text(count > listed.size(), kDigits);
}

std::string jumps(const MeshReport& report, const Domain& domain) {
  const std::size_t torn = report.without_limit.size();
  if (torn == 0) return cuts(report.jumps, report.jump_count, report.jump_lines, domain);
  std::string text = "no limit at " + text_of(one_by_one(report.without_limit, indices_of(torn)),
                                              false, domain, kDigits);
  if (report.jump_count == torn) return text;
  const auto others = std::span(report.jumps).subspan(torn);
  return cuts(others, report.jump_count - torn, report.jump_lines, domain) + "; " + text;
}

std::string singular(const Facts& facts, double diagonal) {
  return SingularWords(facts, diagonal).text();
}

}  // namespace saddle::words
