#include "formula/space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "formula/derive.h"

namespace saddle {
namespace {

bool is_constant_zero(Expression a) {
  return a.graph->is_constant(a.id, 0);
}

/// A product that a component 0 takes no part in: dot((0,0,1), p) is p.z.
Expression scaled(Expression a, Expression b) {
  return is_constant_zero(a) || is_constant_zero(b) ? a.of(0) : a * b;
}

template <class F>
Components each(const Components& a, F f) {
  Components result;
  for (std::size_t k = 0; k < a.size(); ++k) result.push_back(f(k));
  return result;
}

Components derivative(const Components& c, Symbol s) {
  Graph* const graph = c[0].graph;
  std::vector<NodeId> nodes;
  for (const Expression component : c) nodes.push_back(component.id);
  const std::vector<NodeId> slopes = derive(*graph, nodes, s);
  return each(c, [&](std::size_t k) { return Expression{graph, slopes[k]}; });
}

/// The coordinate axis that a constant vector lies on, 1 to 3, negative if against it; or 0.
int coordinate_axis(const Components& a) {
  int axis = 0;
  for (int k = 0; k < 3; ++k) {
    const Expression component = a[static_cast<std::size_t>(k)];
    if (is_constant_zero(component)) continue;
    if (axis != 0 || !component.graph->is_constant(component.id)) return 0;
    axis = (*component.graph)[component.id].value > 0 ? k + 1 : -k - 1;
  }
  return axis;
}

using Direction = std::array<double, 3>;

/// Directions to choose from, in the order of preference: the axes, then others all over the
/// sphere.
std::vector<Direction> candidates() {
  constexpr int kCount = 200;  // 8 degrees apart on the half sphere
  std::vector<Direction> result = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  for (int k = 0; k < kCount; ++k) {
    // A spiral with turns of the golden angle: J. Hannay and J. Nye, 2004.
    const double z = (k + 0.5) / kCount;
    const double angle = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    result.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return result;
}

/// The direction that the tangents are furthest from.
Direction free_direction(const Components& tangent, const Sampler& sampler) {
  // A direction is preferred to a later one that is better by less: roundings do not choose.
  constexpr double kClearlyBetter = 0.02;
  const std::array<NodeId, 3> nodes = {tangent[0].id, tangent[1].id, tangent[2].id};
  std::vector<Direction> tangents;
  for (const std::vector<double>& t : sampler(nodes)) {
    const double length = std::hypot(t[0], t[1], t[2]);
    if (length > 0 && std::isfinite(length)) {
      tangents.push_back({t[0] / length, t[1] / length, t[2] / length});
    }
  }
  Direction best = {0, 0, 1};
  double best_sine = -1;
  for (const Direction& a : candidates()) {
    double cosine = 0;
    for (const Direction& t : tangents) {
      cosine = std::max(cosine, std::fabs(a[0] * t[0] + a[1] * t[1] + a[2] * t[2]));
    }
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    if (sine <= best_sine + kClearlyBetter) continue;
    best_sine = sine;
    best = a;
  }
  return best;
}

}  // namespace

Components operator+(const Components& a, const Components& b) {
  return each(a, [&](std::size_t k) { return a[k] + b[k]; });
}
Components operator-(const Components& a, const Components& b) {
  return each(a, [&](std::size_t k) { return a[k] - b[k]; });
}
Components operator*(Expression a, const Components& b) {
  return each(b, [&](std::size_t k) { return scaled(a, b[k]); });
}
Components operator/(const Components& a, Expression b) {
  return each(a, [&](std::size_t k) { return is_constant_zero(a[k]) ? a[k] : a[k] / b; });
}

Expression dot(const Components& a, const Components& b) {
  Expression sum = scaled(a[0], b[0]);
  for (std::size_t k = 1; k < a.size(); ++k) sum = sum + scaled(a[k], b[k]);
  return sum;
}

Components cross(const Components& a, const Components& b) {
  return each(a, [&](std::size_t k) {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    return scaled(a[next], b[last]) - scaled(a[last], b[next]);
  });
}

Expression norm(const Components& a) {
  Expression sum = pow(a[0], 2);
  for (std::size_t k = 1; k < a.size(); ++k) sum = sum + pow(a[k], 2);
  return sqrt(sum);
}
Components unit(const Components& a) {
  return a / norm(a);
}

Components polar(Expression r, Expression angle, Expression z) {
  return {r * cos(angle), r * sin(angle), z};
}
Components spherical(Expression r, Expression pole, Expression angle) {
  return {r * sin(pole) * cos(angle), r * sin(pole) * sin(angle), r * cos(pole)};
}

Components rotate(const Components& a, const Components& axis, Expression angle) {
  if (const int along = coordinate_axis(axis); along != 0) {
    const std::size_t k = static_cast<std::size_t>(std::abs(along)) - 1;
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    const Expression c = cos(angle);
    const Expression s = along > 0 ? sin(angle) : -sin(angle);
    Components result = a;
    result[i] = scaled(a[i], c) - scaled(a[j], s);
    result[j] = scaled(a[i], s) + scaled(a[j], c);
    return result;
  }
  // O. Rodrigues, 1840: the part along the axis stays, the rest turns.
  const Components k = unit(axis);
  const Components along = dot(k, a) * k;
  return along + cos(angle) * (a - along) + sin(angle) * cross(k, a);
}

Value frame(const Components& c, Symbol s) {
  const Components velocity = derivative(c, s);
  const Components tangent = unit(velocity);
  const Components binormal = unit(cross(velocity, derivative(velocity, s)));
  const Components normal = cross(binormal, tangent);
  std::vector<NodeId> parts;
  for (const Components& vector : {tangent, normal, binormal}) {
    for (const Expression component : vector) parts.push_back(component.id);
  }
  return {Type::Frame, parts};
}

Components tube(const Components& c, Symbol s, Expression r, Expression angle,
                const Sampler& sampler) {
  const Components tangent = derivative(c, s);
  const Direction a = free_direction(tangent, sampler);
  const Components away = each(c, [&](std::size_t k) { return r.of(a[k]); });
  const Components across = unit(cross(away, tangent));
  const Components beside = cross(across, unit(tangent));
  return c + r * (cos(angle) * across + sin(angle) * beside);
}

}  // namespace saddle
