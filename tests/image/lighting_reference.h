// The lighting equation in double, written from its definition and not from the shader.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/model/scene.h"

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

inline dvec3 rgb(const Color& c) {
  return {c.r, c.g, c.b};
}

/// The share of a point light that arrives at distance d.
inline double arriving(const Attenuation& a, double d) {
  return 1 / (a.constant + a.linear * d + a.quadratic * d * d);
}

/// The share of a cone's light along a ray whose cosine with the axis is `c`.
inline double in_cone(const Spot& spot, double c) {
  constexpr double kDegree = std::numbers::pi / 180;
  const double cutoff = std::cos(spot.cutoff * kDegree);
  if (c <= cutoff) return 0;
  const double inner = spot.inner ? std::cos(*spot.inner * kDegree) : cutoff;
  const double a = inner == cutoff ? 1 : std::clamp((c - cutoff) / (inner - cutoff), 0.0, 1.0);
  const double edge = spot.falloff == Spot::Falloff::Smooth ? a * a * (3 - 2 * a) : a;
  return spot.exponent == 0 ? edge : edge * std::pow(std::max(c, 0.0), spot.exponent);
}

/// attenuation * (ambient + spot * (diffuse + specular)) of one light in eye coordinates.
inline dvec3 light_from(const Light& light, const SeenPoint& p, const Material& material,
                        Specular kind) {
  const dvec3 at = light.position;
  const dvec3 l = glm::normalize(light.directional ? at : at - p.position);
  const dvec3 ambient = rgb(light.ambient) * rgb(material.ambient.value_or(material.diffuse));
  const double attenuation =
      light.directional ? 1 : arriving(light.attenuation, glm::length(at - p.position));
  const double spot =
      light.spot ? in_cone(*light.spot, glm::dot(-l, glm::normalize(dvec3(light.spot->direction))))
                 : 1;
  const double n_l = glm::dot(p.normal, l);
  dvec3 reflected(0);
  if (n_l > 0) {
    reflected = n_l * rgb(light.color) * rgb(material.diffuse);
    const double cosine = kind == Specular::Blinn ? glm::dot(p.normal, glm::normalize(l + p.to_eye))
                                                  : glm::dot(-glm::reflect(l, p.normal), p.to_eye);
    if (cosine > 0) {
      reflected += std::pow(cosine, material.shininess) *
                   rgb(light.specular.value_or(light.color)) * rgb(material.specular);
    }
  }
  return attenuation * (ambient + spot * reflected);
}

/// What all lights that are on make of the point.
inline dvec3 lit_color(const SeenPoint& p, const Material& material,
                       const std::vector<Light>& lights, Specular kind = Specular::Phong) {
  dvec3 sum = rgb(material.emission);
  for (const Light& light : lights) {
    if (light.enabled != 0) sum += light_from(light, p, material, kind);
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
