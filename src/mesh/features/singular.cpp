#include "mesh/features/singular.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/random.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Steps of a descent: from a sample beside a simple or a double zero five are enough; of others
/// each step leaves a third or a half of the way.
constexpr int kDescentSteps = 48;
/// After the first few of them, none leaves more of |r_u x r_v| than this, or there is no zero.
constexpr int kFirstDescents = 3;
constexpr double kLeaves = 0.5;
/// No step is longer, in ranges, four of the stretches that samples are apart; it is tried doubled,
/// too.
constexpr double kLongest = 1.0 / 16;
/// A step that is no longer has used up a double's digits.
constexpr double kArrivedAtZero = 1e-15;
/// Squares of singular values of a matrix that differ by more are one and 0: along a curve of zeros
/// there is no way to go.
constexpr double kRankOne = 1e-10;

/// |r_u x r_v| is compared with what it is so far away, in ranges; it is 0 if it is less than this
/// part of it. Double zeros, known to 1e-8 only, are 1e-8 of it.
constexpr double kAroundZero = 1e-4;
constexpr double kZero = 1e-6;
/// Places all around are as many.
constexpr std::size_t kPlacesAround = 8;

/// Zeros that are this near to each other, in ranges, are one: double ones are known to 1e-8.
constexpr double kSame = 1e-6;
/// So many zeros on a line of constant u or v, and this part of some places on it, tell that all of
/// it is.
constexpr std::size_t kFewZeros = 4;
constexpr std::size_t kOnLine = 32;
/// How far from a zero descents begin, in ranges, that tell whether there are others beside it, and
/// the part of that within which they then end if there are none.
constexpr double kBesideZero = 1e-3;
constexpr double kBack = 0.1;
/// How far from each other places on curves of zeros are named, in ranges.
constexpr double kAlongCurves = 1.0 / 16;
/// So many zeros, of which derivatives do not tell, may be tried so; more are on curves.
constexpr std::size_t kMostUnclear = 64;
/// Squares of singular values of a matrix that differ by less are both not 0.
constexpr double kRankTwo = 1e-6;
/// Squares of derivatives that are less than this part of those beside are rounding.
constexpr double kRoundedDerivative = 1e-8;

using Places = std::vector<dvec2>;  // in parts of the ranges

/// Ways that a descent may go.
enum class Along { U, V, Both };

/// r_u x r_v and its derivatives by the parts of the ranges.
struct Area {
  dvec3 cross;
  dvec3 by_u, by_v;
  /// The sum of the derivatives' squares.
  double square() const { return glm::dot(by_u, by_u) + glm::dot(by_v, by_v); }
};

class ZeroFinder {
 public:
  ZeroFinder(const Surface& surface, const Bounds& bounds, unsigned threads,
             std::span<const double> even_u, std::span<const double> even_v)
      : surface_(surface), threads_(threads), scale_(axis_scale(bounds)) {
    const Domain& d = surface.domain;
    low_ = {d.u0, d.v0};
    range_ = {d.u1 - d.u0, d.v1 - d.v0};
    for (const double u : even_u) even_[0].push_back(part({u, 0}).x);
    for (const double v : even_v) even_[1].push_back(part({0, v}).y);
  }

  dvec2 part(const dvec2& uv) const { return (uv - low_) / range_; }
  dvec2 parameters(const dvec2& part) const { return low_ + part * range_; }
  Places parts(std::span<const dvec2> uv) const {
    Places parts;
    for (const dvec2& place : uv) parts.push_back(part(place));
    return parts;
  }

  /// Where descents from some places end, at 0 or not.
  Places descend(Places places, Along along) const {
    std::vector<double> left(places.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> going(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      places[k] = clamped(places[k]);
      going[k] = k;
    }
    for (int step = 0; step < kDescentSteps && !going.empty(); ++step) {
      Places from;
      for (const std::size_t k : going) from.push_back(places[k]);
      const Places ways = ways_down(from, along);
      Places trials;
      for (std::size_t i = 0; i < going.size(); ++i) {
        trials.push_back(clamped(from[i] + ways[i]));
        trials.push_back(clamped(from[i] + 2.0 * ways[i]));
      }
      const std::vector<double> sizes = sizes_at(trials);
      std::vector<std::size_t> still;
      for (std::size_t i = 0; i < going.size(); ++i) {
        const std::size_t best = 2 * i + (sizes[2 * i + 1] < sizes[2 * i] ? 1 : 0);
        places[going[i]] = trials[best];
        double& size = left[going[i]];
        const bool comes_down = step < kFirstDescents || sizes[best] < kLeaves * size;
        size = sizes[best];
        if (comes_down && size > 0 && glm::distance(trials[best], from[i]) > kArrivedAtZero) {
          still.push_back(going[i]);
        }
      }
      going = std::move(still);
    }
    return places;
  }

  /// |r_u x r_v|; infinite where it is not defined.
  std::vector<double> sizes_at(const Places& places) const {
    Places uv;
    uv.reserve(places.size());
    for (const dvec2& place : places) uv.push_back(parameters(place));
    std::vector<double> sizes;
    sizes.reserve(places.size());
    for (const SurfacePoint& p : evaluate(surface_, uv, threads_)) {
      const double size = glm::length(glm::cross(scale_ * p.r_u, scale_ * p.r_v));
      const bool is_known = is_finite(p.position) && std::isfinite(size);
      sizes.push_back(is_known ? size : std::numeric_limits<double>::infinity());
    }
    return sizes;
  }

  /// Whether |r_u x r_v| is 0 at places, compared with what it is around them.
  std::vector<bool> are_zeros(const Places& places) const {
    Places around;
    for (const dvec2& place : places) {
      for (const dvec2& way : ways()) around.push_back(place + kAroundZero * way);
    }
    const std::vector<double> sizes = sizes_at(places);
    const std::vector<double> beside = sizes_at(around);
    std::vector<bool> are;
    for (std::size_t k = 0; k < places.size(); ++k) {
      double largest = 0;
      for (std::size_t w = 0; w < kPlacesAround; ++w) {
        const double size = beside[k * kPlacesAround + w];
        if (std::isfinite(size)) largest = std::max(largest, size);
      }
      are.push_back(largest > 0 && sizes[k] <= kZero * largest);
    }
    return are;
  }

  /// Those of some places that are zeros; at even coordinates, if they are zeros there as well.
  Places zeros(const Places& places) const {
    Places even = places;
    for (dvec2& place : even) {
      for (int axis = 0; axis < 2; ++axis) {
        for (const double at : even_[axis]) {
          if (std::fabs(at - place[axis]) <= kSame) place[axis] = at;
        }
      }
    }
    const std::vector<bool> are = are_zeros(places);
    Places zeros;
    Places evened;
    std::vector<std::size_t> numbers;  // of those, among the zeros
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!are[k]) continue;
      if (even[k] != places[k]) {
        evened.push_back(even[k]);
        numbers.push_back(zeros.size());
      }
      zeros.push_back(places[k]);
    }
    const std::vector<bool> are_even = are_zeros(evened);
    for (std::size_t i = 0; i < evened.size(); ++i) {
      if (are_even[i]) zeros[numbers[i]] = evened[i];
    }
    return zeros;
  }

  /// Whether derivatives of r_u x r_v tell that there is no zero beside a place.
  std::vector<bool> stand_alone(const Places& places) const {
    Places beside;
    for (const dvec2& place : places) beside.push_back(clamped(place + kBesideZero * ways()[0]));
    const std::vector<Area> here = areas_at(places);
    const std::vector<Area> there = areas_at(beside);
    std::vector<bool> do_stand;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const dvec3 normal = glm::cross(here[k].by_u, here[k].by_v);
      const double square = here[k].square();
      do_stand.push_back(square > kRoundedDerivative * there[k].square() &&
                         glm::dot(normal, normal) > kRankTwo * square * square);
    }
    return do_stand;
  }

  /// Ways all around a place, aslant to the axes.
  static std::array<dvec2, kPlacesAround> ways() {
    std::array<dvec2, kPlacesAround> ways;
    for (std::size_t k = 0; k < kPlacesAround; ++k) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.3) / kPlacesAround;
      ways[k] = {std::cos(angle), std::sin(angle)};
    }
    return ways;
  }

 private:
  static dvec2 clamped(const dvec2& place) { return glm::clamp(place, dvec2(0), dvec2(1)); }

  std::vector<Area> areas_at(const Places& places) const {
    Places uv;
    uv.reserve(places.size());
    for (const dvec2& place : places) uv.push_back(parameters(place));
    const std::vector<SurfacePoint> first = evaluate(surface_, uv, threads_);
    const std::vector<Curvature> second = evaluate_curvature(surface_, uv, threads_);
    std::vector<Area> areas;
    areas.reserve(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      const dvec3 r_u = scale_ * first[k].r_u;
      const dvec3 r_v = scale_ * first[k].r_v;
      const dvec3 r_uv = scale_ * second[k].r_uv;
      areas.push_back(
          {glm::cross(r_u, r_v),
           range_.x * (glm::cross(scale_ * second[k].r_uu, r_v) + glm::cross(r_u, r_uv)),
           range_.y * (glm::cross(r_uv, r_v) + glm::cross(r_u, scale_ * second[k].r_vv))});
    }
    return areas;
  }

  /// To where r_u x r_v is 0 if it is linear, the shortest ways.
  Places ways_down(const Places& places, Along along) const {
    Places ways;
    ways.reserve(places.size());
    for (Area& area : areas_at(places)) {
      if (along == Along::U) area.by_v = dvec3(0);
      if (along == Along::V) area.by_u = dvec3(0);
      ways.push_back(way_down(area));
    }
    return ways;
  }

  static dvec2 way_down(const Area& area) {
    const double uu = glm::dot(area.by_u, area.by_u);
    const double uv = glm::dot(area.by_u, area.by_v);
    const double vv = glm::dot(area.by_v, area.by_v);
    const dvec2 slope(glm::dot(area.by_u, area.cross), glm::dot(area.by_v, area.cross));
    const double trace = area.square();
    if (!(trace > 0)) return dvec2(0);
    const double determinant = uu * vv - uv * uv;
    dvec2 way = -slope / trace;
    if (determinant > kRankOne * trace * trace) {
      way = -dvec2(vv * slope.x - uv * slope.y, uu * slope.y - uv * slope.x) / determinant;
    }
    const double length = glm::length(way);
    if (!std::isfinite(length)) return dvec2(0);
    return length > kLongest ? way * (kLongest / length) : way;
  }

  const Surface& surface_;
  unsigned threads_;
  dvec3 scale_;  // of the axes: what is singular is so in any units
  dvec2 low_, range_;
  std::array<std::vector<double>, 2> even_;  // parts of each range
};

bool are_near(const dvec2& a, const dvec2& b, double reach) {
  return glm::all(glm::lessThanEqual(glm::abs(a - b), dvec2(reach)));
}

/// Each zero once, that which is the nearest to 0: about one to which |r_u x r_v| falls in
/// different ways from different sides, descents end before it.
Places distinct(const ZeroFinder& finder, const Places& places) {
  const std::vector<double> sizes = finder.sizes_at(places);
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return sizes[k]; });
  Places result;
  for (const std::size_t k : order) {
    const auto is_same = [&](const dvec2& other) {
      return are_near(places[k], other, kBesideZero);
    };
    if (std::ranges::none_of(result, is_same)) result.push_back(places[k]);
  }
  return result;
}

/// Coordinates `axis` of lines that several of the places are on.
std::vector<double> shared_coordinates(const Places& places, int axis) {
  std::vector<double> sorted;
  for (const dvec2& place : places) sorted.push_back(place[axis]);
  std::ranges::sort(sorted);
  std::vector<double> shared;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end] - sorted[begin] <= kSame) ++end;
    if (end - begin >= kFewZeros) shared.push_back(sorted[begin + (end - begin) / 2]);
  }
  return shared;
}

/// The places of which several share their coordinate `axis`, or may once they are at even ones.
Places places_in_line(Places places, int axis) {
  constexpr double kApartInLine = 3 * kSame;  // each is moved by less than kSame
  std::ranges::sort(places, {}, [axis](const dvec2& place) { return place[axis]; });
  Places result;
  for (std::size_t begin = 0, end = 1; begin < places.size(); begin = end++) {
    while (end < places.size() && places[end][axis] - places[end - 1][axis] <= kApartInLine) ++end;
    if (end - begin < kFewZeros) continue;
    result.insert(result.end(), places.begin() + static_cast<std::ptrdiff_t>(begin),
                  places.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return result;
}

/// The lines of zeros across `axis` among the ends of descents.
std::vector<double> find_lines(const ZeroFinder& finder, int axis, const Places& ends) {
  std::vector<double> lines;
  const Places places = finder.zeros(places_in_line(ends, axis));
  for (const double line : shared_coordinates(places, axis)) {
    Places on_line;
    for (std::size_t k = 0; k < kOnLine; ++k) {
      dvec2 place(line);
      place[1 - axis] = (static_cast<double>(k) + random_unit(k)) / kOnLine;
      on_line.push_back(place);
    }
    const std::vector<bool> are = finder.are_zeros(on_line);
    if (std::ranges::count(are, false) == 0) lines.push_back(line);
  }
  return lines;
}

/// Takes the zeros away that have no others beside them.
Places take_isolated(const ZeroFinder& finder, Places& places) {
  Places isolated;
  Places unclear;
  const std::vector<bool> stand_alone = finder.stand_alone(places);
  for (std::size_t k = 0; k < places.size(); ++k) {
    (stand_alone[k] ? isolated : unclear).push_back(places[k]);
  }
  places = std::move(unclear);
  if (places.size() > kMostUnclear) return isolated;
  Places starts;
  for (const dvec2& place : places) {
    for (const dvec2& way : ZeroFinder::ways()) starts.push_back(place + kBesideZero * way);
  }
  const Places ends = finder.descend(std::move(starts), Along::Both);
  const std::vector<bool> are = finder.are_zeros(ends);
  Places others;
  for (std::size_t k = 0; k < places.size(); ++k) {
    bool is_isolated = true;
    for (std::size_t w = k * kPlacesAround; w < (k + 1) * kPlacesAround; ++w) {
      is_isolated = is_isolated && (!are[w] || are_near(ends[w], places[k], kBack * kBesideZero));
    }
    (is_isolated ? isolated : others).push_back(places[k]);
  }
  places = std::move(others);
  return isolated;
}

}  // namespace

SingularSet find_singular(const Surface& surface, const Dips& dips, std::span<const double> even_u,
                          std::span<const double> even_v, unsigned threads) {
  SingularSet result{{}, {}, dips.edges_u, dips.edges_v, {}};
  if (dips.along_u.empty() && dips.along_v.empty()) return result;
  const ZeroFinder finder(surface, dips.bounds, threads, even_u, even_v);
  // Across lines of zeros first: free descents are drawn along them to where they meet.
  Places places = finder.descend(finder.parts(dips.along_u), Along::U);
  for (const double line : find_lines(finder, 0, places)) {
    result.lines_u.push_back(finder.parameters({line, 0}).x);
  }
  const Places across_v = finder.descend(finder.parts(dips.along_v), Along::V);
  for (const double line : find_lines(finder, 1, across_v)) {
    result.lines_v.push_back(finder.parameters({0, line}).y);
  }
  places.insert(places.end(), across_v.begin(), across_v.end());
  const auto is_on_line = [&](const dvec2& place) {
    const auto is_near_u = [&](double u) {
      return std::fabs(finder.part({u, 0}).x - place.x) <= kSame;
    };
    const auto is_near_v = [&](double v) {
      return std::fabs(finder.part({0, v}).y - place.y) <= kSame;
    };
    return std::ranges::any_of(result.lines_u, is_near_u) ||
           std::ranges::any_of(result.lines_v, is_near_v);
  };
  std::erase_if(places, is_on_line);
  places = distinct(finder, finder.zeros(finder.descend(std::move(places), Along::Both)));
  std::erase_if(places, is_on_line);
  for (const dvec2& place : take_isolated(finder, places)) {
    result.points.push_back(finder.parameters(place));
  }
  for (const dvec2& place : places) result.on_curves.push_back(finder.parameters(place));
  return result;
}

std::vector<bool> are_singular(const Surface& surface, std::span<const dvec2> uv,
                               unsigned threads) {
  if (uv.empty()) return {};
  const ZeroFinder finder(surface, {}, threads, {}, {});
  return finder.are_zeros(finder.parts(uv));
}

void name_singular(const SingularSet& singular, const Domain& domain, MeshReport& report) {
  const dvec2 range = glm::abs(dvec2(domain.u1 - domain.u0, domain.v1 - domain.v0));
  auto& listed = report.singular_points;
  const auto find = [&](const dvec2& uv, double reach) {
    return std::ranges::find_if(listed, [&](const SingularPoint& other) {
      return are_near(uv / range, other.uv / range, reach);
    });
  };
  for (const dvec2& uv : singular.points) {
    const auto known = find(uv, kSame);
    const bool is_new = known == listed.end();
    SingularPoint point = is_new ? SingularPoint{uv} : *known;
    point.is_alone = true;
    if (is_new) {
      ++report.singular_point_count;
    } else {
      listed.erase(known);
    }
    listed.insert(listed.begin(), point);
  }
  if (listed.size() > kMaxListed) listed.resize(kMaxListed);
  const auto name = [&](const dvec2& uv) {
    if (find(uv, kAlongCurves) == listed.end()) add_singular_point(uv, report);
  };
  for (const dvec2& uv : singular.on_curves) name(uv);
  for (double k = 0.5; k * kAlongCurves < 1; ++k) {
    const dvec2 part(k * kAlongCurves);
    const dvec2 uv =
        dvec2(domain.u0, domain.v0) * (1.0 - part) + dvec2(domain.u1, domain.v1) * part;
    for (const double u : singular.lines_u) name({u, uv.y});
    for (const double v : singular.lines_v) name({uv.x, v});
  }
  report.singular_u = singular.lines_u;
  report.singular_v = singular.lines_v;
}

}  // namespace saddle
