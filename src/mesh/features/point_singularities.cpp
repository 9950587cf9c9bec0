#include "mesh/features/point_singularities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <glm/common.hpp>

#include "base/bounds.h"
#include "mesh/features/approach.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Ways to a place, all around it. Every other one is aslant to the axes and diagonals, along which
/// formulas are often undefined or 0.
constexpr std::size_t kWays = 16;
constexpr double kAslantTurn = 0.07;  // of a turn between two ways
/// The length of the ways, in ranges of the parameters. The surface is evaluated at the first and
/// the last part of kApproach: 1e-6 and 1e-12 ranges away.
constexpr double kReach = 0x1p-8;
/// Chords of a curve with a common box.
constexpr std::size_t kChordsPerBox = 16;

/// Ways around an essential point: a circle of limits is 2e-5 of its radius from their chords.
constexpr std::size_t kManyWays = 512;

/// Directions beside the axes and diagonals, at slopes of 4^-1 to 4^-26 to them: between such
/// slopes run curves as v = u^2, along which a limit may be another one than on all straight ways.
constexpr int kSlopes = 26;
/// In ranges of the parameters: the distances at which these directions are compared. A parabola
/// is 2^-32 beside the axis at 2^-16, which doubles resolve.
constexpr std::array kLooksAside = {0x1p-9, 0x1p-16};

/// The ways to one place that lie in the domain.
struct Ways {
  std::vector<Line> lines;         ///< from the place outward
  std::vector<bool> is_aslant;     ///< of each line
  bool is_open_aslant = true;      ///< the surface is defined on all aslant ways
  bool is_open = true;             ///< the surface is defined on all ways
  std::array<Bounds, 2> at_looks;  ///< of the finite positions at each look
};

Ways ways_to(const dvec2& place, const Domain& d) {
  const dvec2 low = glm::min(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  const dvec2 high = glm::max(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  Ways ways;
  for (std::size_t k = 0; k < kWays; ++k) {
    const bool is_aslant = k % 2 != 0;
    const double turn = (static_cast<double>(k) + (is_aslant ? kAslantTurn : 0)) / kWays;
    const double angle = 2 * std::numbers::pi * turn;
    dvec2 way(std::cos(angle), std::sin(angle));
    if (!is_aslant) way = glm::round(1.1 * way);  // along axes and diagonals to the last digit
    const dvec2 end = place + kReach * (high - low) * way;
    const bool is_inside = end.x >= low.x && end.x <= high.x && end.y >= low.y && end.y <= high.y;
    if (!is_inside) continue;
    ways.lines.push_back({place, end});
    ways.is_aslant.push_back(is_aslant);
  }
  return ways;
}

void look(const Surface& surface, std::span<Ways> all, unsigned threads) {
  std::vector<dvec2> uv;
  for (const Ways& ways : all) {
    for (const double share : {kApproach.front(), kApproach.back()}) {
      for (const Line& line : ways.lines) uv.push_back(line[0] + share * (line[1] - line[0]));
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  std::size_t next = 0;
  for (Ways& ways : all) {
    for (Bounds& bounds : ways.at_looks) {
      for (const bool is_aslant : ways.is_aslant) {
        const dvec3& p = points[next++].position;
        if (is_finite(p)) {
          bounds.add(p);
        } else {
          ways.is_open = false;
          if (is_aslant) ways.is_open_aslant = false;
        }
      }
    }
  }
}

PointSingularity::Kind kind_of_point(const Surface& surface, const Ways& ways, double agree,
                                     unsigned threads) {
  const std::vector<bool> far = diverge(surface, ways.lines, agree, threads);
  if (std::ranges::count(far, true) > 0) return PointSingularity::Kind::Pole;
  const double before = ways.at_looks[0].diagonal();
  const double near = ways.at_looks[1].diagonal();
  return near > agree && near > before / kStays ? PointSingularity::Kind::Essential
                                                : PointSingularity::Kind::Removable;
}

/// Where positions go if their bounds move on as they did from the first look to the second, as
/// many halvings of the way each time, as ln does. It is beyond the limit of a power.
Bounds go_on(const std::array<Bounds, 2>& at_looks) {
  const int halvings = std::ilogb(kApproach.front() / kApproach.back());
  const double looks_left = static_cast<double>(kHalvingsToLeast) / halvings;
  const auto& [before, near] = at_looks;
  Bounds beyond = near;
  beyond.low += looks_left * glm::min(near.low - before.low, dvec3(0));
  beyond.high += looks_left * glm::max(near.high - before.high, dvec3(0));
  return beyond;
}

/// Many directions all around a point, in their order.
std::vector<dvec2> many_directions() {
  std::vector<dvec2> result;
  for (std::size_t k = 0; k < kManyWays; ++k) {
    const double turn = (static_cast<double>(k) + kAslantTurn) / kManyWays;
    const double angle = 2 * std::numbers::pi * turn;
    result.emplace_back(std::cos(angle), std::sin(angle));
  }
  return result;
}

/// Directions beside the axes and diagonals, in their order around a point.
std::vector<dvec2> directions_aside() {
  std::vector<dvec2> result;
  for (const dvec2& middle : kEightWays) {
    const dvec2 aside(-middle.y, middle.x);
    for (int k = 1; k <= kSlopes; ++k) result.push_back(middle - std::ldexp(1.0, -2 * k) * aside);
    for (int k = kSlopes; k >= 1; --k) result.push_back(middle + std::ldexp(1.0, -2 * k) * aside);
  }
  return result;
}

/// Places of the domain that are `reach` ranges from a place.
std::vector<dvec2> places_around(const Domain& d, const dvec2& place,
                                 std::span<const dvec2> directions, double reach) {
  const ParameterBox domain = box_of(d);
  const dvec2 low = glm::min(domain.low, domain.high);
  const dvec2 high = glm::max(domain.low, domain.high);
  std::vector<dvec2> uv;
  for (const dvec2& direction : directions) {
    const dvec2 beside = place + reach * (high - low) * direction;
    if (beside == glm::clamp(beside, low, high)) uv.push_back(beside);
  }
  return uv;
}

/// Positions at places_around(); empty if one of them is undefined.
std::vector<dvec3> look_around(const Surface& surface, const dvec2& place,
                               std::span<const dvec2> directions, double reach, unsigned threads) {
  const std::vector<dvec2> uv = places_around(surface.domain, place, directions, reach);
  std::vector<dvec3> around;
  for (const SurfacePoint& point : evaluate(surface, uv, threads)) {
    if (!is_finite(point.position)) return {};
    around.push_back(point.position);
  }
  return around;
}

/// Positions around a point to which all straight ways have one limit, if curves to it have others:
/// as of u^2*v/(u^4+v^2). Empty if there are none.
std::vector<dvec3> limits_aside(const Surface& surface, const dvec2& place, double agree,
                                unsigned threads) {
  const std::vector<dvec2> directions = directions_aside();
  const std::vector<dvec3> far = look_around(surface, place, directions, kLooksAside[0], threads);
  std::vector<dvec3> near = look_around(surface, place, directions, kLooksAside[1], threads);
  if (far.empty() || near.empty()) return {};
  const double before = bounds_of(far).diagonal();
  const double size = bounds_of(near).diagonal();
  const bool stays = size > agree && size > before / kStays && size < kStays * before;
  return stays ? near : std::vector<dvec3>();
}

/// Adds the limits around an essential point, if it is inside of the domain. A point that seems
/// removable is looked at along curves.
void add_limits_around(const Surface& surface, const Ways& ways, double diagonal, unsigned threads,
                       PointSingularity& singularity) {
  const dvec2 place = ways.lines[0][0];
  const bool is_inside = ways.lines.size() == kWays;
  std::vector<dvec3> around;
  if (singularity.kind == PointSingularity::Kind::Essential && is_inside) {
    around = look_around(surface, place, many_directions(), kReach * kApproach.back(), threads);
  } else if (singularity.kind == PointSingularity::Kind::Removable) {
    around = limits_aside(surface, place, kLimitsAgree * diagonal, threads);
    if (around.empty()) return;
    singularity.kind = PointSingularity::Kind::Essential;
    for (const dvec3& p : around) singularity.near.add(p);
  }
  if (is_inside) singularity.around = ClosedCurve(std::move(around));
}

/// Parts of a box that are followed. Four meet at a point on their corners.
constexpr std::size_t kMostBoxParts = 16;

class Narrowing {
 public:
  Narrowing(const Surface& surface, std::optional<double> diagonal)
      : surface_(surface), enclosure_(surface, Bounded::Position), diagonal_(diagonal) {}

  std::optional<dvec2> operator()(const ParameterBox& whole) {
    BoxSubdivision<ParameterBox> search({whole});
    std::vector<ParameterBox>& parts = search.open();
    bool is_followed = false;
    int crowded = 0;  // generations with more varied parts than meet at a point
    while (search.depth() < 2 * kHalvingsToEdge) {
      search.test([this](const ParameterBox& part) {
        return are_continuous(enclosure_.enclose(part)) ? ProofOutcome::Proved : ProofOutcome::Open;
      });
      if (parts.size() > kMostBoxParts && !is_followed && diagonal_ && followed_ < kMostFollowed) {
        is_followed = true;
        ++followed_;
      }
      if (is_followed && keep_varied(parts) && ++crowded > kHalvingsToSight) return std::nullopt;
      if (parts.empty() || parts.size() > kMostBoxParts) return std::nullopt;
      const dvec2 size = parts[0].size() / box_of(surface_.domain).size();
      search.halve(size.x < size.y ? 1 : 0);
    }
    Bounds left;
    for (const ParameterBox& part : parts) left.add(dvec3(part.middle(), 0));
    const dvec2 most = kSame * whole.size();
    if (left.size().x > most.x || left.size().y > most.y) return std::nullopt;
    // A coordinate that is 0 within the search's precision is 0.
    dvec2 place(left.centre());
    for (int k = 0; k < 2; ++k) {
      if (std::fabs(place[k]) <= most[k]) place[k] = 0;
    }
    return place;
  }

 private:
  /// Keeps the parts in which the surface varies the most, within kStays: around an essential point
  /// it varies by the same in parts of any size. None if limits agree in all, or if it
  /// goes to infinity. Returns whether there were too many, as there are again and again along a
  /// line of jumps.
  bool keep_varied(std::vector<ParameterBox>& parts) const {
    const std::vector<double> sizes = variations(parts);
    const double most = sizes.empty() ? 0 : *std::ranges::max_element(sizes);
    const double least = std::max(kLimitsAgree * *diagonal_, most / kStays);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (most <= *diagonal_ && sizes[k] > least) order.push_back(k);
    }
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return sizes[k]; });
    const bool are_many = order.size() > kMostBoxParts;
    if (are_many) order.resize(kMostBoxParts);
    std::vector<ParameterBox> kept;
    kept.reserve(order.size());
    for (const std::size_t k : order) kept.push_back(parts[k]);
    parts = std::move(kept);
    return are_many;
  }

  /// The diagonals of boxes around nine positions of each box of parameters.
  std::vector<double> variations(std::span<const ParameterBox> boxes) const {
    std::vector<dvec2> uv;
    for (const ParameterBox& box : boxes) {
      for (const double u : {box.low.x, box.middle().x, box.high.x}) {
        for (const double v : {box.low.y, box.middle().y, box.high.y}) uv.emplace_back(u, v);
      }
    }
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, 1);
    std::vector<double> sizes;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      Bounds bounds;
      for (const SurfacePoint& point : std::span(points).subspan(9 * k, 9)) {
        if (is_finite(point.position)) bounds.add(point.position);
      }
      sizes.push_back(bounds.diagonal());
    }
    return sizes;
  }

  const Surface& surface_;
  SurfaceEnclosure enclosure_;
  std::optional<double> diagonal_;  ///< empty: essential points are not searched
  std::size_t followed_ = 0;
};

}  // namespace

ClosedCurve::ClosedCurve(std::vector<dvec3> places) : places_(std::move(places)) {
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (k % kChordsPerBox == 0) boxes_.emplace_back();
    boxes_.back().add(places_[k]);
    boxes_.back().add(places_[(k + 1) % places_.size()]);
  }
}

bool ClosedCurve::is_within(const dvec3& place, double reach) const {
  for (std::size_t box = 0; box < boxes_.size(); ++box) {
    const Bounds around{boxes_[box].low - reach, boxes_[box].high + reach};
    if (!around.contains(place)) continue;
    const std::size_t end = std::min((box + 1) * kChordsPerBox, places_.size());
    for (std::size_t k = box * kChordsPerBox; k < end; ++k) {
      if (is_near_chord(k, place, reach)) return true;
    }
  }
  return false;
}

std::size_t ClosedCurve::count_chords(double length) const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (glm::distance(places_[k], places_[(k + 1) % places_.size()]) > length) ++count;
  }
  return count;
}

bool ClosedCurve::is_near_chord(std::size_t number, const dvec3& place, double reach) const {
  const dvec3& from = places_[number];
  const dvec3 way = places_[(number + 1) % places_.size()] - from;
  const double square = glm::dot(way, way);
  const double share =
      square > 0 ? std::clamp(glm::dot(place - from, way) / square, 0.0, 1.0) : 0.0;
  return glm::distance(place, from + share * way) <= reach;
}

std::vector<std::optional<dvec2>> find_point_singularities(const Surface& surface,
                                                           std::span<const ParameterBox> where,
                                                           std::optional<double> diagonal) {
  Narrowing narrow(surface, diagonal);
  std::vector<std::optional<dvec2>> places;
  for (const ParameterBox& box : where) places.push_back(narrow(box));
  return places;
}

bool has_limits_aside(const Surface& surface, const dvec2& place, double diagonal,
                      unsigned threads) {
  return !limits_aside(surface, place, kLimitsAgree * diagonal, threads).empty();
}

std::vector<std::optional<PointBeside>> points_beside_jumps(const Surface& surface,
                                                            std::span<const dvec2> places,
                                                            double diagonal, unsigned threads,
                                                            std::size_t& count) {
  const std::vector<dvec2> directions = many_directions();
  std::vector<std::optional<PointBeside>> result;
  for (const dvec2& place : places) {
    const std::vector<dvec2> around =
        places_around(surface.domain, place, directions, kReach * kApproach.back());
    const std::vector<SurfacePoint> points = evaluate(surface, around, threads);
    count += points.size();
    std::size_t leaps = 0;
    bool are_defined = !points.empty();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const dvec3& next = points[(k + 1) % points.size()].position;
      are_defined = are_defined && is_finite(points[k].position);
      if (glm::distance(points[k].position, next) > kNearly * diagonal) ++leaps;
    }
    const bool are_few = are_defined && leaps > 0 && leaps <= kLimitsOfLines;
    result.push_back(are_few ? std::optional(PointBeside{around[0], points[0]}) : std::nullopt);
  }
  return result;
}

std::vector<PointSingularity> classify_points(const Surface& surface, std::span<const dvec2> places,
                                              double diagonal, unsigned threads) {
  std::vector<Ways> all;
  for (const dvec2& place : places) all.push_back(ways_to(place, surface.domain));
  look(surface, all, threads);
  std::vector<PointSingularity> singularities;
  for (const Ways& ways : all) {
    PointSingularity singularity;
    if (ways.is_open && !ways.lines.empty()) {
      singularity = {kind_of_point(surface, ways, kLimitsAgree * diagonal, threads),
                     ways.at_looks[1]};
      if (singularity.kind == PointSingularity::Kind::Pole)
        singularity.beyond = go_on(ways.at_looks);
      add_limits_around(surface, ways, diagonal, threads, singularity);
    } else if (ways.is_open_aslant) {
      singularity.kind = PointSingularity::Kind::Line;
    }
    singularities.push_back(singularity);
  }
  return singularities;
}

}  // namespace saddle
