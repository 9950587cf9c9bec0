// Rays of equal solid angle fill each cone. Where one meets a triangle, what arrives there is
// compared with what the triangle's corners blend to.
#include "render/picture/light_findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/format.h"
#include "formula/lexer.h"
#include "render/picture/picture_in_tiles.h"
#include "render/shading/shader_lights.h"
#include "scene/model/choices.h"
#include "scene/model/instances.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

/// Rays of a cone: a ring for each sixteenth of its solid angle. A cone that falls between the
/// corners of one triangle meets that triangle with all of them.
constexpr int kRings = 16;
constexpr int kRaysOfRing = 16;

/// Share of a cone's light that may be lost before it is told: a soft edge blended across a
/// triangle loses less.
constexpr double kMostLost = 0.25;

/// Per-vertex meshes of more triangles are finer than any cone that a picture shows.
constexpr std::size_t kMostTriangles = 200'000;

bool is_black(const Color& color) {
  return color.r == 0 && color.g == 0 && color.b == 0;
}

/// "light takes 0 to 4", for each parameter with ends or choices that a light's `enabled` uses.
std::string values_of_switches(const Scene& scene) {
  std::set<std::string> names;
  for (const Light& light : scene.lights) names.merge(names_in(light.enabled.text));
  std::string text;
  for (const Slider& slider : scene.sliders) {
    if (!names.contains(slider.name)) continue;
    const std::string values = slider.choices.empty()
                                   ? format_number(slider.min) + " to " + format_number(slider.max)
                                   : choices_text(slider);
    text += (text.empty() ? ": " : "; ") + slider.name + " takes " + values;
  }
  return text;
}

/// How much of a cone's light leaves at this cosine from its axis, as shaders/lighting.glsl has it.
double leaving(const ShaderLight& light, double cosine) {
  const dvec3& edge = light.spot_edge;
  const double a = std::clamp((cosine - edge.x) * edge.y, 0.0, 1.0);
  const double rim = light.kind->is_smooth ? a * a * (3 - 2 * a) : a;
  return rim * std::pow(std::max(cosine, 0.0), edge.z);
}

double arriving(const ShaderLight& light, const dvec3& at) {
  return leaving(light, glm::dot(glm::normalize(at - light.position), light.spot_direction));
}

std::vector<dvec3> rays_of(const ShaderLight& light) {
  const dvec3& axis = light.spot_direction;
  const dvec3 other = std::abs(axis.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 across = glm::normalize(glm::cross(axis, other));
  const dvec3 third = glm::cross(axis, across);
  std::vector<dvec3> rays;
  for (int ring = 0; ring < kRings; ++ring) {
    const double cosine = 1 - (1 - light.spot_edge.x) * (ring + 0.5) / kRings;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    for (int k = 0; k < kRaysOfRing; ++k) {
      const double turn = 2 * std::numbers::pi * (k + 0.5 * (ring % 2)) / kRaysOfRing;
      rays.push_back(cosine * axis + sine * (std::cos(turn) * across + std::sin(turn) * third));
    }
  }
  return rays;
}

/// A cone's light on a surface, as it is and as its corners show it.
struct Shown {
  double all = 0;
  double lost = 0;
};

/// Adds what a triangle takes of a cone. Source: T. Moeller, B. Trumbore, "Fast, minimum storage
/// ray/triangle intersection", 1997.
void add_triangle(const std::array<dvec3, 3>& p, const ShaderLight& light,
                  std::span<const dvec3> rays, bool perspective, Shown& shown) {
  const dvec3 a = p[1] - p[0];
  const dvec3 b = p[2] - p[0];
  const dvec3 normal = glm::cross(a, b);
  const dvec3 to_light = light.position - p[0];
  const dvec3 to_eye = perspective ? -p[0] : dvec3(0, 0, 1);
  // The side that is seen is dark where the light is behind it.
  if (!(glm::dot(normal, to_light) * glm::dot(normal, to_eye) > 0)) return;
  const std::array<double, 3> corners = {arriving(light, p[0]), arriving(light, p[1]),
                                         arriving(light, p[2])};
  for (const dvec3& ray : rays) {
    const dvec3 h = glm::cross(ray, b);
    const double f = 1 / glm::dot(a, h);
    const double u = f * glm::dot(to_light, h);
    const dvec3 q = glm::cross(to_light, a);
    const double v = f * glm::dot(ray, q);
    if (!(u >= 0 && v >= 0 && u + v <= 1 && f * glm::dot(b, q) > 0)) continue;
    const double there = leaving(light, glm::dot(ray, light.spot_direction));
    const double blended = (1 - u - v) * corners[0] + u * corners[1] + v * corners[2];
    shown.all += there;
    shown.lost += std::max(0.0, there - blended);
  }
}

/// The share of a cone's light on a surface that is lost between its vertices.
double lost_share(const Mesh& mesh, std::span<const glm::dmat4> to_eye, const ShaderLight& light,
                  bool perspective) {
  const std::vector<dvec3> rays = rays_of(light);
  Shown shown;
  for (const glm::dmat4& m : to_eye) {
    for (const auto& triangle : mesh.triangles) {
      std::array<dvec3, 3> p;
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = dvec3(m * glm::dvec4(mesh.position[triangle[k]], 1));
      add_triangle(p, light, rays, perspective, shown);
    }
  }
  return shown.all > 0 ? shown.lost / shown.all : 0;
}

/// From the world to the eye, in the scene's units.
glm::dmat4 world_to_eye(const FittedCamera& camera) {
  glm::dmat4 result(glm::dmat3(camera.world_to_eye));
  result[3] = {glm::dmat3(camera.world_to_eye) * -camera.target - dvec3(0, 0, camera.distance), 1};
  return result;
}

SceneFinding lost_cone(const std::string& surface, double share) {
  const std::string percent = formatted("%.0f %%", 100 * share);
  return {surface,
          {.kind = Finding::Kind::ConeLost,
           .text = "lit per vertex, it loses " + percent +
                   " of a spot light's cone between its vertices; --shading pixel shows all of it",
           .warns = true,
           .share = share}};
}

}  // namespace

std::string warning_of(const SceneFinding& found) {
  return (found.surface.empty() ? "" : found.surface + ": ") + found.finding.text;
}

std::optional<SceneFinding> no_light(const Scene& scene) {
  const auto is_dark = [&](const SurfaceSpec& spec) {
    return !spec.is_stroke() && shading_of(scene, spec) != Shading::Unlit &&
           is_black(spec.front.emission) && is_black(spec.back.emission);
  };
  if (std::ranges::any_of(scene.lights, shines)) return std::nullopt;
  if (std::ranges::none_of(scene.surfaces, is_dark)) return std::nullopt;
  const std::string why = scene.lights.empty() ? ": the scene has none" : values_of_switches(scene);
  return SceneFinding{
      "", {.kind = Finding::Kind::NoLight, .text = "no light is on" + why, .warns = true}};
}

std::vector<SceneFinding> lost_cones(const Scene& scene, std::span<const Mesh> meshes,
                                     const dvec2& size) {
  std::vector<SceneFinding> found;
  const auto is_spot = [](const Light& light) { return light.spot.has_value(); };
  const auto is_per_vertex = [&](const SurfaceSpec& spec) {
    return shading_of(scene, spec) == Shading::Vertex;
  };
  if (std::ranges::none_of(scene.lights, is_spot)) return found;
  if (std::ranges::none_of(scene.surfaces, is_per_vertex)) return found;
  const FittedCamera camera = fit_to_meshes(scene, meshes, size);
  std::vector<ShaderLight> cones = shader_lights(scene, camera, 1);
  std::erase_if(cones, [](const ShaderLight& light) { return !light.kind->is_cone; });
  const NodeFrames frames(scene);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const SurfaceSpec& spec = scene.surfaces[i];
    if (!is_per_vertex(spec)) continue;
    if (meshes[i].triangles.size() > kMostTriangles) continue;
    std::vector<glm::dmat4> to_eye = places(frames, spec);
    for (glm::dmat4& place : to_eye) place = world_to_eye(camera) * place;
    double most = 0;
    for (const ShaderLight& light : cones) {
      most = std::max(most, lost_share(meshes[i], to_eye, light, !scene.camera.ortho));
    }
    if (most > kMostLost) found.push_back(lost_cone(spec.name, most));
  }
  return found;
}

}  // namespace saddle
