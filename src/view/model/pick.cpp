#include "view/model/pick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "surface/normal.h"

namespace saddle {
namespace {

/// The mesh is within half a pixel of the surface, where Newton's method doubles the digits each
/// time: past these many steps nothing is gained.
constexpr int kSteps = 8;
/// Steps that lead farther than this part of the domain from the hit lead to another sheet.
constexpr double kFarAway = 0.1;

/// A few roundings of a parameter, as a part of its range.
constexpr double kRounding = 1e-12;

/// Signed distance along the ray and weights of the second and third corner.
std::optional<dvec3> intersect(const Ray& ray, const std::array<dvec3, 3>& corner) {
  const dvec3 ab = corner[1] - corner[0];
  const dvec3 ac = corner[2] - corner[0];
  const dvec3 p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) return std::nullopt;
  const dvec3 from = ray.origin - corner[0];
  const double b = glm::dot(from, p) / determinant;
  const dvec3 q = glm::cross(from, ab);
  const double c = glm::dot(ray.direction, q) / determinant;
  if (!(b >= 0 && c >= 0 && b + c <= 1)) return std::nullopt;
  return dvec3(glm::dot(ac, q) / determinant, b, c);
}

dvec2 clamped(const dvec2& uv, const Domain& d) {
  return {std::clamp(uv.x, std::min(d.u0, d.u1), std::max(d.u0, d.u1)),
          std::clamp(uv.y, std::min(d.v0, d.v1), std::max(d.v0, d.v1))};
}

/// All that is told of a point of the surface, whose u and v here are its own.
SurfacePlace describe_place(const Surface& surface, const dvec2& own, const SurfacePoint& point) {
  const auto normal =
      unit_normal(point, safe_length(point.r_u), safe_length(point.r_v), surface.flip);
  const Curvature curvature = evaluate_curvature(surface, {&own, 1}, 1).front();
  dvec2 uv = own;
  take_user_parameters(surface, {&uv, 1});
  return {uv, point.position, normal, curvature};
}

/// Two directions across the ray.
std::array<dvec3, 2> across(const Ray& ray) {
  const dvec3 d = glm::normalize(ray.direction);
  const dvec3 a =
      glm::normalize(glm::cross(d, std::abs(d.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  return {a, glm::cross(d, a)};
}

/// The surface at some u and v, next to a line of sight.
struct Candidate {
  dvec2 uv;
  SurfacePoint point;
  dvec2 off;  ///< how far it is from the line, along the directions across
};

}  // namespace

std::optional<Hit> first_hit(const Mesh& mesh, const TriangleBoxes& boxes, const Ray& ray) {
  std::optional<Hit> nearest;
  const auto limit = [&] {
    return nearest ? nearest->distance : std::numeric_limits<double>::infinity();
  };
  boxes.along(ray, limit, [&](std::size_t triangle) {
    const auto& [i, j, k] = mesh.triangles[triangle];
    const auto met = intersect(ray, {mesh.position[i], mesh.position[j], mesh.position[k]});
    if (!met || met->x <= 0 || met->x >= limit()) return;
    const double rest = 1 - met->y - met->z;
    nearest = {met->x, rest * mesh.uv[i] + met->y * mesh.uv[j] + met->z * mesh.uv[k]};
  });
  return nearest;
}

SurfacePlace place_on_surface(const Surface& surface, const Ray& ray, const Hit& hit) {
  const auto [a, b] = across(ray);
  const auto candidate = [&, a = a, b = b](const dvec2& uv) {
    const dvec2 inside = clamped(uv, surface.domain);
    const SurfacePoint point = evaluate(surface, {&inside, 1}, 1).front();
    const dvec3 from = point.position - ray.origin;
    return Candidate{inside, point, {glm::dot(a, from), glm::dot(b, from)}};
  };
  const Domain& domain = surface.domain;
  const dvec2 reach = kFarAway * glm::abs(dvec2(domain.u1 - domain.u0, domain.v1 - domain.v0));
  dvec2 start = hit.uv;
  take_own_parameters(surface, {&start, 1});
  Candidate best = candidate(start);
  for (int step = 0; step < kSteps; ++step) {
    const SurfacePoint& p = best.point;
    const glm::dmat2 jacobian(glm::dot(a, p.r_u), glm::dot(b, p.r_u), glm::dot(a, p.r_v),
                              glm::dot(b, p.r_v));
    const Candidate next = candidate(best.uv - glm::inverse(jacobian) * best.off);
    const bool near = glm::all(glm::lessThanEqual(glm::abs(next.uv - start), reach));
    if (!near || !(glm::length(next.off) < glm::length(best.off))) break;  // so is what is NaN
    best = next;
  }
  return describe_place(surface, best.uv, best.point);
}

std::optional<SurfacePlace> place_at(const Surface& surface, const dvec2& uv) {
  dvec2 own = uv;
  take_own_parameters(surface, {&own, 1});
  // A place on an edge is off by rounding after the way to the surface's own parameters and back.
  const dvec2 inside = clamped(own, surface.domain);
  const Domain& domain = surface.domain;
  const dvec2 lengths = glm::abs(dvec2(domain.u1 - domain.u0, domain.v1 - domain.v0));
  const bool is_inside = glm::all(glm::lessThanEqual(glm::abs(own - inside), kRounding * lengths));
  if (!is_inside) return std::nullopt;  // so is what is NaN
  const SurfacePoint point = evaluate(surface, {&inside, 1}, 1).front();
  const dvec3& p = point.position;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return std::nullopt;
  SurfacePlace place = describe_place(surface, inside, point);
  place.uv = uv;  // stays as it is, however often the surface changes
  return place;
}

}  // namespace saddle
