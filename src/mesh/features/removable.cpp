#include "mesh/features/removable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "base/bounds.h"
#include "base/numbers.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// 64 epsilon: a parameter is rounded where its line is placed, and again where a formula
/// multiplies it, as in sin(10*pi*u).
constexpr double kRoundingOfParameters = 0x1p-46;

/// Positions on a few lines may be rounding. Where one in 4 is, that is the surface.
constexpr std::size_t kMostOnLines = 4;

/// A point beside a place.
struct NearbyLook {
  bool is_defined;
  std::optional<dvec3> known;  ///< the position, if it is not rounding
};

/// The mean of the pairs of opposite looks that are both known. A line of 0/0 along one axis leaves
/// the pair along the other.
std::optional<dvec3> middle_of_pairs(std::span<const NearbyLook> looks) {
  dvec3 sum(0);
  double count = 0;
  for (std::size_t k = 0; k < looks.size(); k += 2) {
    if (!looks[k].known || !looks[k + 1].known) continue;
    sum += *looks[k].known + *looks[k + 1].known;
    count += 2;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

/// The limit on which all known looks agree.
Beside judge(std::span<const NearbyLook> looks, double diagonal) {
  Beside beside;
  const auto is_known = [](const NearbyLook& look) { return look.known.has_value(); };
  beside.is_alone = std::ranges::all_of(looks, is_known);
  beside.is_within = std::ranges::all_of(looks.first(kFourWays.size()), is_known);
  Bounds bounds;
  for (const NearbyLook& look : looks) {
    beside.is_defined = beside.is_defined || look.is_defined;
    if (look.known) bounds.add(*look.known);
  }
  if (!bounds.empty() && bounds.diagonal() <= kLimitsAgree * diagonal) {
    beside.limit = middle_of_pairs(looks.first(kFourWays.size()));
  }
  return beside;
}

}  // namespace

double moved_by_last_digit(const SurfacePoint& point, const dvec2& uv) {
  return moved_by_last_digit(dvec2(safe_length(point.r_u), safe_length(point.r_v)), uv);
}

double moved_by_last_digit(const dvec2& lengths, const dvec2& uv) {
  return std::numeric_limits<double>::epsilon() * glm::dot(lengths, glm::abs(uv));
}

bool moves_by_last_digit(const SurfacePoint& point, const dvec2& uv, double most) {
  const double moved = moved_by_last_digit(point, uv);
  return std::isfinite(moved) && moved > most;
}

bool moves_by_last_digit(const Surface& surface, const dvec2& uv, double most) {
  return moves_by_last_digit(evaluate(surface, std::span(&uv, 1), 1)[0], uv, most);
}

bool is_rounding(const SurfacePoint& point, const dvec2& uv, double diagonal) {
  return moves_by_last_digit(point, uv, kLimitsAgree * diagonal);
}

double diagonal_without_rounding(std::span<const SurfacePoint> points, std::span<const dvec2> uv,
                                 double diagonal) {
  Bounds others;
  std::size_t rounded = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_rounding(points[k], uv[k], diagonal)) {
      ++rounded;
    } else if (is_finite(points[k].position)) {
      others.add(points[k].position);
    }
  }
  const bool is_everywhere = kMostOnLines * rounded > points.size() || others.empty();
  return is_everywhere ? kInfinity : others.diagonal();
}

dvec3 rounding_by_parameters(const SurfacePoint& point, const dvec2& uv, const Domain& domain) {
  const dvec2 range(domain.u1 - domain.u0, domain.v1 - domain.v0);
  const dvec2 rounding = kRoundingOfParameters * glm::max(glm::abs(uv), glm::abs(range));
  dvec3 moved = glm::abs(point.r_u) * rounding.x + glm::abs(point.r_v) * rounding.y;
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(moved[k])) moved[k] = 0;
  }
  return moved;
}

std::vector<Beside> look_beside(const Surface& surface, std::span<const dvec2> places,
                                double diagonal, unsigned threads, std::size_t& count) {
  const Domain& d = surface.domain;
  // The nearest looks. A smooth surface moves by kNearly of its size, and the mean of opposite
  // looks is off by the square of that.
  const dvec2 step = kNearly * dvec2(d.u1 - d.u0, d.v1 - d.v0);
  // Twice as far, too: positions around a pole are alike at one distance. And aslant: an essential
  // point may have one limit along both axes.
  const std::array<dvec2, 10> ways = {
      dvec2(step.x, 0),       dvec2(-step.x, 0),       dvec2(0, step.y),
      dvec2(0, -step.y),      2.0 * dvec2(step.x, 0),  2.0 * dvec2(-step.x, 0),
      2.0 * dvec2(0, step.y), 2.0 * dvec2(0, -step.y), step,
      dvec2(-step.x, step.y)};
  const auto look = [&](std::span<const std::size_t> which, std::span<const dvec2> where) {
    std::vector<dvec2> uv;
    for (const std::size_t k : which) {
      for (const dvec2& way : where) uv.push_back(places[k] + way);
    }
    count += uv.size();
    std::vector<NearbyLook> found;
    const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
    for (std::size_t k = 0; k < points.size(); ++k) {
      found.push_back({is_finite(points[k].position), std::nullopt});
      const bool is_known = found[k].is_defined && !is_rounding(points[k], uv[k], diagonal);
      if (is_known) found[k].known = points[k].position;
    }
    return found;
  };
  // Within an undefined region one look suffices. It is aslant: the axes may be undefined alone.
  std::vector<std::size_t> all(places.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto first = look(all, std::array{dvec2(step.x, 0.37 * step.y)});
  std::vector<Beside> result(places.size());
  std::vector<std::size_t> open;
  for (const std::size_t k : all) {
    result[k].is_defined = first[k].is_defined;
    if (first[k].known) open.push_back(k);
  }
  const auto around = look(open, ways);
  for (std::size_t i = 0; i < open.size(); ++i) {
    result[open[i]] = judge(std::span(around).subspan(i * ways.size(), ways.size()), diagonal);
  }
  return result;
}

}  // namespace saddle
