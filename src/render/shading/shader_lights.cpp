#include "render/shading/shader_lights.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "scene/model/instances.h"

namespace saddle {
namespace {

/// In units of the scene. From farther away a point light's direction is the same everywhere to a
/// float's precision, and the square of its distance must not overflow.
constexpr double kFarthestLight = 1e9;

/// Bounds of factors in floats: a light brighter than this is white at any angle that counts.
constexpr double kBrightest = 1e6;
/// An exponent whose highlight is narrower than any pixel's.
constexpr double kLargestExponent = 1e9;
/// 1 / (least width of a spot's edge, in cosines): narrower than a float's step near 1.
constexpr double kHardEdge = 1e9;
/// Attenuations beyond it leave no light at any distance that counts.
constexpr double kMostAttenuation = 1e30;

/// Set aside for matrices and materials, for what a driver adds, and for the constants of a
/// formula, each of which may take the room of four.
constexpr int kOtherComponents = 160 + 4 * static_cast<int>(kMostConstants);

dvec3 clamped_rgb(const Color& color) {
  return glm::min(dvec3(color.r, color.g, color.b), dvec3(kBrightest));
}

dvec3 unit_vector(const dvec3& v) {
  const double length = std::hypot(v.x, v.y, v.z);
  return length > 0 ? v / length : v;
}

/// Points are measured from the camera's target, as the meshes are.
class Frames {
 public:
  Frames(const Scene& scene, const FittedCamera& camera) : nodes_(scene), camera_(camera) {}

  dvec3 point(const std::string& frame, const dvec3& p) const {
    if (frame == "eye") return p;
    const dvec3 world(to_world(frame) * glm::dvec4(p, 1));
    return rotation() * (world - camera_.target) - dvec3(0, 0, camera_.distance);
  }

  dvec3 direction(const std::string& frame, const dvec3& d) const {
    if (frame == "eye") return unit_vector(d);
    const dvec3 world = glm::dmat3(to_world(frame)) * d;
    return unit_vector(rotation() * unit_vector(world));
  }

 private:
  const glm::dmat4& to_world(const std::string& frame) const {
    return frame == "world" ? nodes_.root() : nodes_.to_world(frame);
  }
  glm::dmat3 rotation() const { return glm::dmat3(camera_.world_to_eye); }

  NodeFrames nodes_;
  const FittedCamera& camera_;
};

dvec3 in_units(const dvec3& position, double unit) {
  const double length = std::hypot(position.x, position.y, position.z);
  return length > kFarthestLight * unit ? position / length * kFarthestLight : position / unit;
}

/// Constant, linear and quadratic, for distances in units of the scene.
dvec3 attenuation_in_units(const Attenuation& a, double unit) {
  const dvec3 k =
      a.range ? attenuation_of_range(*a.range) : dvec3(a.constant, a.linear, a.quadratic);
  return glm::min(dvec3(k.x, k.y * unit, k.z * unit * unit), dvec3(kMostAttenuation));
}

dvec3 spot_edge(const Spot& spot) {
  const double cutoff = std::cos(glm::radians(spot.cutoff.value));
  const double inner = spot.inner ? std::cos(glm::radians(spot.inner->value)) : cutoff;
  const double width = std::max(inner - cutoff, 1 / kHardEdge);
  return {cutoff, 1 / width, std::min(spot.exponent.value, kLargestExponent)};
}

/// A uniform array of shaders/lighting.glsl with an entry for each light.
struct LightUniform {
  const char* name;
  dvec3 ShaderLight::*member;
  bool is_color = false;  ///< a float in programs where no light has a hue
  /// Whether a program has it. Not set: every one that has lights.
  bool (*is_needed)(const ShaderNeeds& needs) = nullptr;
};

constexpr auto kLightUniforms = std::to_array<LightUniform>({
    {.name = "light_position", .member = &ShaderLight::position},
    {.name = "light_color", .member = &ShaderLight::color, .is_color = true},
    {.name = "light_highlight",
     .member = &ShaderLight::highlight,
     .is_color = true,
     .is_needed = [](const ShaderNeeds& needs) { return needs.specular && needs.highlights; }},
    {.name = "light_ambient",
     .member = &ShaderLight::ambient,
     .is_color = true,
     .is_needed = [](const ShaderNeeds& needs) { return needs.ambient; }},
    {.name = "light_attenuation",
     .member = &ShaderLight::attenuation,
     .is_needed = [](const ShaderNeeds& needs) { return needs.attenuation; }},
    {.name = "spot_direction", .member = &ShaderLight::spot_direction, .is_needed = has_cone},
    {.name = "spot_edge", .member = &ShaderLight::spot_edge, .is_needed = has_cone},
});

/// Each uniform is a vector, which may take the room of four components.
constexpr int kComponentsPerLight = 4 * static_cast<int>(kLightUniforms.size());

ShaderLight shader_light(const Light& light, const Frames& frames, double unit, bool perspective) {
  ShaderLight result;
  result.color = clamped_rgb(light.color);
  result.highlight = light.specular ? clamped_rgb(*light.specular) : result.color;
  result.ambient = clamped_rgb(light.ambient);
  result.attenuation = attenuation_in_units(light.attenuation, unit);
  result.position = light.directional ? frames.direction(light.frame, light.position)
                                      : in_units(frames.point(light.frame, light.position), unit);
  if (light.spot) {
    result.spot_direction = frames.direction(light.frame, light.spot->direction);
    result.spot_edge = spot_edge(*light.spot);
  }
  const std::span<const LightKind> kinds = light_kinds();
  const auto kind = std::ranges::find_if(
      kinds, [&](const LightKind& k) { return k.has(light, result, perspective); });
  assert(kind != kinds.end());
  result.kind = &*kind;
  return result;
}

bool is_black(const dvec3& color) {
  return color == dvec3(0);
}

bool is_lit(const Scene& scene) {
  const auto is_unlit = [&](const SurfaceSpec& spec) {
    return shading_of(scene, spec) == Shading::Unlit;
  };
  if (scene.surfaces.empty()) return scene.picture.shading != Shading::Unlit;
  return !std::ranges::all_of(scene.surfaces, is_unlit);
}

bool is_grey(const dvec3& color) {
  return color.r == color.g && color.g == color.b;
}

void set_vectors(Program& program, const LightUniform& uniform,
                 std::span<const ShaderLight> lights) {
  std::vector<dvec3> values;
  for (const ShaderLight& light : lights) values.push_back(light.*uniform.member);
  program.set(uniform.name, values);
}

void set_greys(Program& program, const LightUniform& uniform, std::span<const ShaderLight> lights) {
  std::vector<double> values;
  for (const ShaderLight& light : lights) values.push_back((light.*uniform.member).r);
  program.set(uniform.name, values);
}

}  // namespace

bool has_cone(const ShaderNeeds& needs) {
  return std::ranges::any_of(needs.lights, &LightKind::is_cone);
}

bool shines(const Light& light) {
  const bool is_dark = is_black(clamped_rgb(light.color)) && is_black(clamped_rgb(light.ambient)) &&
                       (!light.specular || is_black(clamped_rgb(*light.specular)));
  return light.enabled != 0 && !is_dark;
}

std::vector<ShaderLight> shader_lights(const Scene& scene, const FittedCamera& camera,
                                       double unit) {
  const Frames frames(scene, camera);
  std::vector<ShaderLight> result;
  if (!is_lit(scene)) return result;
  for (const Light& light : scene.lights) {
    if (shines(light)) result.push_back(shader_light(light, frames, unit, !scene.camera.ortho));
  }
  std::ranges::stable_sort(result, {}, &ShaderLight::kind);
  return result;
}

void add_light_needs(std::span<const ShaderLight> lights, ShaderNeeds& needs) {
  for (const ShaderLight& light : lights) {
    needs.lights.push_back(light.kind);
    needs.grey &= is_grey(light.color) && is_grey(light.highlight) && is_grey(light.ambient);
    needs.attenuation |= light.kind->reads_attenuation && is_attenuated(light);
    needs.focus |= light.kind->is_cone && light.spot_edge.z > 0;
    needs.ambient |= !is_black(light.ambient);
    needs.highlights |= light.highlight != light.color;
  }
}

std::size_t lights_at_once(int uniform_components) {
  return static_cast<std::size_t>(
      std::max((uniform_components - kOtherComponents) / kComponentsPerLight, 1));
}

void set_lights(Program& program, std::span<const ShaderLight> lights, const ShaderNeeds& needs) {
  if (lights.empty()) return;
  for (const LightUniform& uniform : kLightUniforms) {
    if (uniform.is_needed != nullptr && !uniform.is_needed(needs)) continue;
    uniform.is_color&& needs.grey ? set_greys(program, uniform, lights)
                                  : set_vectors(program, uniform, lights);
  }
}

dvec3 attenuation_of_range(double range) {
  struct Row {
    double range, linear, quadratic;
  };
  // Source: Ogre3D wiki, "-Point Light Attenuation". The constant is 1.
  constexpr std::array<Row, 12> kRows = {{{7, 0.7, 1.8},
                                          {13, 0.35, 0.44},
                                          {20, 0.22, 0.20},
                                          {32, 0.14, 0.07},
                                          {50, 0.09, 0.032},
                                          {65, 0.07, 0.017},
                                          {100, 0.045, 0.0075},
                                          {160, 0.027, 0.0028},
                                          {200, 0.022, 0.0019},
                                          {325, 0.014, 0.0007},
                                          {600, 0.007, 0.0002},
                                          {3250, 0.0014, 0.000007}}};
  // Powers of the range between rows, and beyond them as between the last two.
  std::size_t k = 0;
  while (k + 2 < kRows.size() && range > kRows[k + 1].range) ++k;
  const Row& a = kRows[k];
  const Row& b = kRows[k + 1];
  const double s = std::log(range / a.range) / std::log(b.range / a.range);
  return {1, a.linear * std::pow(b.linear / a.linear, s),
          a.quadratic * std::pow(b.quadratic / a.quadratic, s)};
}

}  // namespace saddle
