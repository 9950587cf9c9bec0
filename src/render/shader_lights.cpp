#include "render/shader_lights.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "scene/instances.h"

namespace saddle {
namespace {

/// In units of the scene. From farther away a point light's direction is the same everywhere to a
/// float's precision, and the square of its distance must not overflow.
constexpr double kFarthestLight = 1e9;

/// Bounds of what floats multiply: a light brighter than this is white at any angle that counts.
constexpr double kBrightest = 1e6;
/// An exponent whose highlight is narrower than any pixel's.
constexpr double kLargestExponent = 1e9;
/// 1 / (least width of a spot's edge, in cosines): narrower than a float's step near 1.
constexpr double kHardEdge = 1e9;
/// Attenuations beyond it leave no light at any distance that counts.
constexpr double kMostAttenuation = 1e30;

/// Most uniform components of a light: seven vectors, each of which may take the room of four.
constexpr int kComponentsPerLight = 28;
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
    const dvec3 world = frame == "world" ? p : dvec3(nodes_.to_world(frame) * glm::dvec4(p, 1));
    return rotation() * (world - camera_.target) - dvec3(0, 0, camera_.distance);
  }

  dvec3 direction(const std::string& frame, const dvec3& d) const {
    if (frame == "eye") return unit_vector(d);
    const dvec3 world = frame == "world" ? d : glm::dmat3(nodes_.to_world(frame)) * d;
    return unit_vector(rotation() * unit_vector(world));
  }

 private:
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

/// `perspective`: the direction to the eye is that to its place.
LightKind kind_of(const Light& light, const ShaderLight& values, bool perspective) {
  if (light.directional) return LightKind::Directional;
  if (light.spot) {
    const bool smooth = light.spot->falloff == Spot::Falloff::Smooth && light.spot->inner;
    return smooth ? LightKind::SmoothSpot : LightKind::Spot;
  }
  if (values.attenuation != dvec3(1, 0, 0)) return LightKind::Attenuated;
  return perspective && values.position == dvec3(0) ? LightKind::AtEye : LightKind::Point;
}

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
  result.kind = kind_of(light, result, perspective);
  return result;
}

bool is_black(const dvec3& color) {
  return color == dvec3(0);
}

bool is_grey(const dvec3& color) {
  return color.r == color.g && color.g == color.b;
}

/// One uniform array.
void set_array(Program& program, const char* name, std::span<const ShaderLight> lights,
               dvec3 ShaderLight::*member) {
  std::vector<dvec3> values;
  for (const ShaderLight& light : lights) values.push_back(light.*member);
  program.set(name, values);
}

/// The same of colours, of which a number is enough if they are grey.
void set_colors(Program& program, const char* name, std::span<const ShaderLight> lights,
                dvec3 ShaderLight::*member, bool grey) {
  if (!grey) return set_array(program, name, lights, member);
  std::vector<double> values;
  for (const ShaderLight& light : lights) values.push_back((light.*member).r);
  program.set(name, values);
}

}  // namespace

std::vector<ShaderLight> shader_lights(const Scene& scene, const FittedCamera& camera,
                                       double unit) {
  const Frames frames(scene, camera);
  std::vector<ShaderLight> result;
  for (const Light& light : scene.lights) {
    if (light.enabled == 0) continue;
    const ShaderLight values = shader_light(light, frames, unit, !scene.camera.ortho);
    const bool dark =
        is_black(values.color) && is_black(values.highlight) && is_black(values.ambient);
    if (!dark) result.push_back(values);
  }
  std::ranges::stable_sort(result, {}, &ShaderLight::kind);
  return result;
}

void add_light_needs(std::span<const ShaderLight> lights, ShaderNeeds& needs) {
  for (const ShaderLight& light : lights) {
    const bool cone = light.kind == LightKind::Spot || light.kind == LightKind::SmoothSpot;
    needs.lights.push_back(light.kind);
    needs.grey &= is_grey(light.color) && is_grey(light.highlight) && is_grey(light.ambient);
    needs.attenuation |=
        light.kind != LightKind::Directional && light.attenuation != dvec3(1, 0, 0);
    needs.focus |= cone && light.spot_edge.z > 0;
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
  set_array(program, "light_position", lights, &ShaderLight::position);
  set_colors(program, "light_color", lights, &ShaderLight::color, needs.grey);
  if (needs.specular && needs.highlights) {
    set_colors(program, "light_highlight", lights, &ShaderLight::highlight, needs.grey);
  }
  if (needs.ambient) {
    set_colors(program, "light_ambient", lights, &ShaderLight::ambient, needs.grey);
  }
  if (needs.attenuation) set_array(program, "light_attenuation", lights, &ShaderLight::attenuation);
  if (lights.back().kind >= LightKind::Spot) {
    set_array(program, "spot_direction", lights, &ShaderLight::spot_direction);
    set_array(program, "spot_edge", lights, &ShaderLight::spot_edge);
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
