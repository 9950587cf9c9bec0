#include "render/shading/light_kinds.h"

#include <array>

namespace saddle {
namespace {

/// A light that shines to all sides, equally far.
bool is_plain_point(const Light& light, const ShaderLight& uniforms) {
  return !light.directional && !light.spot && !is_attenuated(uniforms);
}

bool is_at_eye(const ShaderLight& uniforms, bool perspective) {
  return perspective && uniforms.position == dvec3(0);
}

bool is_spot(const Light& light) {
  return !light.directional && light.spot;
}

/// A hard edge looks the same with either falloff.
bool is_smooth(const Spot& spot) {
  return spot.falloff == Spot::Falloff::Smooth && spot.inner;
}

constexpr auto kLightKinds = std::to_array<LightKind>({
    {.name = "DIRECTIONAL",
     .function = "directional_light",
     .has = [](const Light& light, const ShaderLight&, bool) { return light.directional; }},
    {.name = "AT_EYE",
     .function = "light_at_eye",
     .has =
         [](const Light& light, const ShaderLight& uniforms, bool perspective) {
           return is_plain_point(light, uniforms) && is_at_eye(uniforms, perspective);
         }},
    {.name = "POINT",
     .function = "point_light",
     .has =
         [](const Light& light, const ShaderLight& uniforms, bool perspective) {
           return is_plain_point(light, uniforms) && !is_at_eye(uniforms, perspective);
         }},
    {.name = "ATTENUATED",
     .function = "attenuated_light",
     .reads_attenuation = true,
     .has = [](const Light& light, const ShaderLight& uniforms,
               bool) { return !light.directional && !light.spot && is_attenuated(uniforms); }},
    {.name = "SPOT",
     .function = "spot_light",
     .reads_attenuation = true,
     .is_cone = true,
     .has = [](const Light& light, const ShaderLight&,
               bool) { return is_spot(light) && !is_smooth(*light.spot); }},
    {.name = "SMOOTH_SPOT",
     .function = "smooth_spot_light",
     .reads_attenuation = true,
     .is_cone = true,
     .is_smooth = true,
     .has = [](const Light& light, const ShaderLight&,
               bool) { return is_spot(light) && is_smooth(*light.spot); }},
});

}  // namespace

std::span<const LightKind> light_kinds() {
  return kLightKinds;
}

bool is_attenuated(const ShaderLight& light) {
  return light.attenuation != dvec3(1, 0, 0);
}

}  // namespace saddle
