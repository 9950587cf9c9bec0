#include "mesh/features/singular.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "base/random.h"
#include "mesh/features/zero_finder.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// 4 zeros on a line of constant u or v, and a place in each of kDomainParts that is a zero, make a
/// line of zeros.
constexpr std::size_t kFewZeros = 4;
/// A zero is isolated if descents from kBesideZero away come back to within 0.1 of that.
constexpr double kBack = 0.1;

bool are_near(const dvec2& a, const dvec2& b, double reach) {
  return glm::all(glm::lessThanEqual(glm::abs(a - b), dvec2(reach)));
}

/// The place with the least |r_u x r_v| among places within kBesideZero of each other: descents
/// from different sides may end at different distances before one zero.
UnitPlaces distinct(const ZeroFinder& finder, const UnitPlaces& places) {
  const std::vector<double> sizes = finder.sizes_at(places);
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return sizes[k]; });
  UnitPlaces result;
  for (const std::size_t k : order) {
    const auto is_same = [&](const dvec2& other) {
      return are_near(places[k], other, kBesideZero);
    };
    if (std::ranges::none_of(result, is_same)) result.push_back(places[k]);
  }
  return result;
}

/// Coordinates `axis` of lines that several of the places are on.
std::vector<double> shared_coordinates(const UnitPlaces& places, int axis) {
  std::vector<double> sorted;
  for (const dvec2& place : places) sorted.push_back(place[axis]);
  std::ranges::sort(sorted);
  std::vector<double> shared;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end] - sorted[begin] <= kNearly) ++end;
    if (end - begin >= kFewZeros) shared.push_back(sorted[begin + (end - begin) / 2]);
  }
  return shared;
}

/// The places of which several share their coordinate `axis`, or may after they are moved to even
/// coordinates.
UnitPlaces places_in_line(UnitPlaces places, int axis) {
  constexpr double kApartInLine = 3 * kNearly;  // each is moved by less than kNearly
  std::ranges::sort(places, {}, [axis](const dvec2& place) { return place[axis]; });
  UnitPlaces result;
  for (std::size_t begin = 0, end = 1; begin < places.size(); begin = end++) {
    while (end < places.size() && places[end][axis] - places[end - 1][axis] <= kApartInLine) ++end;
    if (end - begin < kFewZeros) continue;
    result.insert(result.end(), places.begin() + static_cast<std::ptrdiff_t>(begin),
                  places.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return result;
}

/// The lines of zeros across `axis` among the ends of descents.
std::vector<double> find_lines(const ZeroFinder& finder, int axis, const UnitPlaces& ends) {
  std::vector<double> lines;
  const UnitPlaces places = finder.zeros(places_in_line(ends, axis));
  for (const double line : shared_coordinates(places, axis)) {
    UnitPlaces on_line;
    for (std::size_t k = 0; k < kDomainParts; ++k) {
      dvec2 place(line);
      place[1 - axis] = (static_cast<double>(k) + random_unit(k)) / kDomainParts;
      on_line.push_back(place);
    }
    const std::vector<bool> are = finder.are_zeros(on_line);
    if (std::ranges::count(are, false) == 0) lines.push_back(line);
  }
  return lines;
}

/// Removes the isolated zeros from `places` and returns them.
UnitPlaces take_isolated(const ZeroFinder& finder, UnitPlaces& places) {
  UnitPlaces isolated;
  UnitPlaces unclear;
  const std::vector<bool> stand_alone = finder.stand_alone(places);
  for (std::size_t k = 0; k < places.size(); ++k) {
    (stand_alone[k] ? isolated : unclear).push_back(places[k]);
  }
  places = std::move(unclear);
  if (places.size() > kMostFollowed) return isolated;
  UnitPlaces starts;
  for (const dvec2& place : places) {
    for (const dvec2& way : ZeroFinder::ways()) starts.push_back(place + kBesideZero * way);
  }
  const UnitPlaces ends = finder.descend(std::move(starts), Along::Both);
  const std::vector<bool> are = finder.are_zeros(ends);
  UnitPlaces others;
  for (std::size_t k = 0; k < places.size(); ++k) {
    bool is_isolated = true;
    for (std::size_t w = k * kWaysAround; w < (k + 1) * kWaysAround; ++w) {
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
  UnitPlaces places = finder.descend(finder.parts(dips.along_u), Along::U);
  for (const double line : find_lines(finder, 0, places)) {
    result.lines_u.push_back(finder.parameters({line, 0}).x);
  }
  const UnitPlaces across_v = finder.descend(finder.parts(dips.along_v), Along::V);
  for (const double line : find_lines(finder, 1, across_v)) {
    result.lines_v.push_back(finder.parameters({0, line}).y);
  }
  places.insert(places.end(), across_v.begin(), across_v.end());
  const auto is_on_line = [&](const dvec2& place) {
    const auto is_near_u = [&](double u) {
      return std::fabs(finder.part({u, 0}).x - place.x) <= kNearly;
    };
    const auto is_near_v = [&](double v) {
      return std::fabs(finder.part({0, v}).y - place.y) <= kNearly;
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
    const auto known = find(uv, kNearly);
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
    if (find(uv, kFarApart) == listed.end()) add_singular_point(uv, report);
  };
  for (const dvec2& uv : singular.on_curves) name(uv);
  for (double k = 0.5; k * kFarApart < 1; ++k) {
    const dvec2 part(k * kFarApart);
    const dvec2 uv =
        dvec2(domain.u0, domain.v0) * (1.0 - part) + dvec2(domain.u1, domain.v1) * part;
    for (const double u : singular.lines_u) name({u, uv.y});
    for (const double v : singular.lines_v) name({uv.x, v});
  }
  report.singular_u = singular.lines_u;
  report.singular_v = singular.lines_v;
}

}  // namespace saddle
