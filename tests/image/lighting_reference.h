// The lighting equation in double, written from its definition and not from the shader.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/scene.h"

namespace saddle {

/// The three lights of the default scene.
inline std::vector<Light> three_lights() {
  return {{{0, 0, 0}, false, {0.6, 0.6, 0.6, 1}},
          {{0, 1, 1}, true, {0.3, 0.3, 0.3, 1}},
          {{0, -1, 0}, true, {0.3, 0.3, 0.3, 1}}};
}

/// A point of a surface in eye coordinates, as its front or its back is seen.
struct SeenPoint {
  dvec3 position;
  dvec3 normal;  ///< unit, of the side that is seen
  dvec3 to_eye;  ///< unit
};

/// Phong: N.L of the diffuse colour and (R.V)^s of the specular one for each light in front.
inline dvec3 lit_color(const SeenPoint& p, const Material& material,
                       const std::vector<Light>& lights) {
  const auto rgb = [](const Color& c) { return dvec3(c.r, c.g, c.b); };
  dvec3 sum(0);
  for (const Light& light : lights) {
    const dvec3 at = light.position;
    const dvec3 l = glm::normalize(light.directional ? at : at - p.position);
    const double n_l = glm::dot(p.normal, l);
    if (n_l <= 0) continue;
    sum += n_l * rgb(light.color) * rgb(material.diffuse);
    const dvec3 r = -glm::reflect(l, p.normal);
    const double r_v = glm::dot(r, p.to_eye);
    if (r_v > 0)
      sum += std::pow(r_v, material.shininess) * rgb(light.color) * rgb(material.specular);
  }
  return glm::min(sum, dvec3(1));
}

/// The line of sight through the middle of a pixel, in eye coordinates.
struct Sight {
  dvec3 from;
  dvec3 along;  ///< unit
};

/// `camera` has a distance; x and y count from the upper left.
inline Sight sight_through(const Camera& camera, int width, int height, int x, int y) {
  const double slope = std::tan(camera.fov * std::numbers::pi / 360);
  const dvec3 at((2 * (x + 0.5) / width - 1) * slope * width / height,
                 (1 - 2 * (y + 0.5) / height) * slope, -1);
  if (camera.ortho) return {dvec3(at.x, at.y, 0) * double{*camera.distance}, dvec3(0, 0, -1)};
  return {dvec3(0), glm::normalize(at)};
}

/// Where a sight meets the plane through `point`.
inline dvec3 meet_plane(const Sight& sight, const dvec3& point, const dvec3& normal) {
  const double t = glm::dot(point - sight.from, normal) / glm::dot(sight.along, normal);
  return sight.from + t * sight.along;
}

/// Where a sight first meets a sphere from outside (`inside`: leaves it from inside); NaN: never.
inline dvec3 meet_sphere(const Sight& sight, const dvec3& centre, double radius, bool inside) {
  const dvec3 to_centre = centre - sight.from;
  const double b = glm::dot(to_centre, sight.along);
  const double root = std::sqrt(b * b - glm::dot(to_centre, to_centre) + radius * radius);
  return sight.from + (inside ? b + root : b - root) * sight.along;
}

}  // namespace saddle
