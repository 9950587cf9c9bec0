#include "surface/normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "surface/limit_path.h"

namespace saddle {

namespace {

/// An extrapolation that changes by no more than this has used up a double's digits.
constexpr double kConverged = 1e-12;
/// An extrapolation whose best entry still changes by more (radians) has found no limit. Normals
/// analytic in tau settle below 1e-9; powers u^p, p >= 1/4, are then off by at most three times
/// their change; logarithms, off by a hundred times theirs, stay above 5e-4 for u*log(u).
constexpr double kSettled = 1e-4;
/// Once settled, a path that changes by more (radians) has lost its digits: beside 0/0, where
/// derivatives of rounding errors become so large that their direction seems to settle again.
constexpr double kLost = 1e-2;
/// A normal that comes nearer to its limit does not then move away by more than twice its distance
/// and by this much (radians); one that oscillates, as of u*sin(1/u), does.
constexpr double kRelapse = 0.1;
/// Corners whose paths are evaluated together: 4.3 MB of points.
constexpr std::size_t kApproachBlock = 4096;
/// How far from a singular point its sides are looked at, as a part of the ranges.
constexpr double kBeside = 1.0 / 128;
/// On so many ways, aslant to the axes: two of them are within the corner of a domain.
constexpr std::size_t kWays = 8;
constexpr double kAslant = 0.3;  // of a turn between two ways
/// Limits that differ by no more are one, degrees: those of regular surfaces agree to 1e-7.
constexpr double kSameDegrees = 1e-3;

double largest_component(const dvec3& a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

/// r_u x r_v with the tangents divided by numbers that keep it from overflow and underflow; zero
/// for a zero tangent, nothing where one is not finite.
struct ScaledCross {
  dvec3 vector{0};
  double size_u = 1;  ///< what r_u was divided by
  double size_v = 1;
};

std::optional<ScaledCross> scaled_cross(const SurfacePoint& point) {
  if (!is_finite(point.r_u) || !is_finite(point.r_v)) return std::nullopt;
  const double size_u = largest_component(point.r_u);
  const double size_v = largest_component(point.r_v);
  if (is_moderate(size_u) && is_moderate(size_v))
    return ScaledCross{glm::cross(point.r_u, point.r_v)};
  if (size_u == 0 || size_v == 0) return ScaledCross{};
  return ScaledCross{glm::cross(point.r_u / size_u, point.r_v / size_v), size_u, size_v};
}

/// The entry of Richardson's tableau that agrees best with the two it was made from.
struct Extrapolation {
  dvec3 value{0};
  double square = std::numeric_limits<double>::infinity();  ///< of the change from those
  std::size_t last = 0;  ///< the path's last normal that it was made from
};

double square_of(double x) {
  return x * x;
}
double square_of_distance(const dvec3& a, const dvec3& b) {
  return glm::dot(a - b, a - b);
}

/// Whether the normals approach the limit that was found from them.
bool is_approached(std::span<const dvec3> normals, const dvec3& limit) {
  double before = std::numeric_limits<double>::infinity();
  for (const dvec3& normal : normals) {
    const double off = glm::distance(normal, limit);
    if (off > std::max(2 * before, kRelapse)) return false;
    before = off;
  }
  return true;
}

/// The limit of the normals along a path, or nothing.
std::optional<dvec3> extrapolate(std::span<const SurfacePoint> path) {
  Extrapolation best;
  std::array<dvec3, kLimitSteps> normals;
  std::array<dvec3, kHighestPower + 1> previous{};
  std::array<dvec3, kHighestPower + 1> row{};
  for (std::size_t i = 0; i < path.size() && best.square > square_of(kConverged); ++i) {
    const std::optional<dvec3> normal = normal_direction(path[i]);
    if (!normal) break;
    normals[i] = row[0] = *normal;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k <= std::min(i, kHighestPower); ++k) {
      const double power = static_cast<double>(1U << k);
      row[k] = row[k - 1] + (row[k - 1] - previous[k - 1]) / (power - 1);
      const double square = std::max(square_of_distance(row[k], row[k - 1]),
                                     square_of_distance(row[k], previous[k - 1]));
      least = std::min(least, square);
      if (square < best.square) best = {row[k], square, i};
    }
    if (best.square <= square_of(kSettled) && least > square_of(kLost)) break;
    previous = row;
  }
  if (!(best.square <= square_of(kSettled))) return std::nullopt;
  if (!is_approached(std::span(normals).first(best.last + 1), best.value)) return std::nullopt;
  return glm::normalize(best.value);
}

/// The points on the way to each corner, kLimitSteps for each.
std::vector<dvec2> paths(std::span<const Approach> approaches) {
  std::vector<dvec2> uv;
  uv.reserve(approaches.size() * kLimitSteps);
  for (const Approach& approach : approaches) {
    const auto path = limit_path(approach.corner, approach.inside);
    uv.insert(uv.end(), path.begin(), path.end());
  }
  return uv;
}

bool is_inside(const Domain& d, const dvec2& uv) {
  return uv.x >= std::min(d.u0, d.u1) && uv.x <= std::max(d.u0, d.u1) &&
         uv.y >= std::min(d.v0, d.v1) && uv.y <= std::max(d.v0, d.v1);
}

/// Ways from within the domain to a point of it, as many through each quarter.
std::vector<Approach> ways_to(const Domain& d, const dvec2& uv) {
  const dvec2 step = kBeside * dvec2(d.u1 - d.u0, d.v1 - d.v0);
  std::vector<Approach> ways;
  for (std::size_t k = 0; k < kWays; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + kAslant) / kWays;
    const dvec2 inside = uv + dvec2(std::cos(angle), std::sin(angle)) * step;
    if (is_inside(d, inside)) ways.push_back({uv, inside});
  }
  return ways;
}

}  // namespace

double scaled_length(const dvec3& a) {
  if (!is_finite(a)) return std::numeric_limits<double>::infinity();
  const double size = largest_component(a);
  return size > 0 ? size * glm::length(a / size) : 0;
}

std::optional<dvec3> normal_direction(const SurfacePoint& point) {
  const std::optional<ScaledCross> cross = scaled_cross(point);
  if (!cross) return std::nullopt;
  const double length = glm::length(cross->vector);
  if (!(length > 0)) return std::nullopt;
  return cross->vector / length;
}

std::optional<dvec3> unit_normal(const SurfacePoint& point, double scale_u, double scale_v,
                                 bool flip) {
  const std::optional<ScaledCross> cross = scaled_cross(point);
  if (!cross) return std::nullopt;
  const double length = glm::length(cross->vector);
  const double relative = length * (cross->size_u / scale_u) * (cross->size_v / scale_v);
  if (!(relative > kDegenerateCross)) return std::nullopt;  // also 0/0, a scale of zero
  return (flip ? -cross->vector : cross->vector) / length;
}

ColumnPoint column_point(const NormalColumns& columns, std::size_t i, bool flip) {
  const auto at = [&](std::size_t first) {
    return dvec3(columns[first][i], columns[first + 1][i], columns[first + 2][i]);
  };
  const double front = flip ? -1 : 1;
  const dvec3 position = at(0);
  const dvec3 normal = front * at(kNormalColumn);
  // |r_u| and |r_v| may each be infinite or 0.
  const double scale =
      std::sqrt(columns[kSquareUColumn][i]) * std::sqrt(columns[kSquareVColumn][i]);
  // min(1, undefined) is undefined, but may have the derivatives of 1.
  const bool is_regular = columns[kAreaColumn][i] > kDegenerateCross * scale && is_finite(normal) &&
                          is_finite(position);
  return {position, normal, is_regular};
}

double cross_terms(const SurfacePoint& point) {
  const dvec3 a = glm::abs(point.r_u);
  const dvec3 b = glm::abs(point.r_v);
  return safe_length({std::max(a.y * b.z, a.z * b.y), std::max(a.z * b.x, a.x * b.z),
                      std::max(a.x * b.y, a.y * b.x)});
}

std::optional<dvec3> known_normal(const SurfacePoint& point, bool flip) {
  const double terms = cross_terms(point);
  const dvec3 cross = glm::cross(point.r_u, point.r_v);
  if (!std::isfinite(terms) || !(safe_length(cross) > kDegenerateCross * terms)) {
    return std::nullopt;
  }
  const std::optional<dvec3> normal = normal_direction(point);
  return normal && flip ? -*normal : normal;
}

std::vector<NormalLimit> limit_normals(const Surface& surface, std::span<const Approach> approaches,
                                       unsigned threads) {
  std::vector<NormalLimit> limits;
  limits.reserve(approaches.size());
  for (std::size_t begin = 0; begin < approaches.size(); begin += kApproachBlock) {
    const auto block =
        approaches.subspan(begin, std::min(kApproachBlock, approaches.size() - begin));
    const std::vector<SurfacePoint> points = evaluate(surface, paths(block), threads);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto normal = extrapolate(std::span(points).subspan(i * kLimitSteps, kLimitSteps));
      NormalLimit& limit = limits.emplace_back(NormalLimit{normal});
      if (normal && surface.flip) limit.normal = -*normal;
    }
  }
  return limits;
}

NormalLimit limit_normal(const Surface& surface, dvec2 corner, dvec2 inside) {
  const Approach approach{corner, inside};
  return limit_normals(surface, std::span(&approach, 1), 1).front();
}

std::vector<dvec3> normals_around(const Surface& surface, const dvec2& uv) {
  std::vector<dvec3> normals;
  for (const NormalLimit& limit : limit_normals(surface, ways_to(surface.domain, uv), 1)) {
    if (!limit.normal) continue;
    const auto is_same = [&](const dvec3& n) {
      return degrees_between(n, *limit.normal) <= kSameDegrees;
    };
    if (std::ranges::none_of(normals, is_same)) normals.push_back(*limit.normal);
  }
  return normals;
}

}  // namespace saddle
