// The defaults of a scene.
#include "scene/model/scene.h"

#include <algorithm>

namespace saddle {

std::vector<Light> default_lights() {
  return {
      {.position = {0, 0, 0}, .directional = false, .color = {0.6, 0.6, 0.6}},
      {.position = {0, 1, 1}, .directional = true, .color = {0.3, 0.3, 0.3}},
      {.position = {0, -1, 0}, .directional = true, .color = {0.3, 0.3, 0.3}},
  };
}

Shading shading_of(const Scene& scene, const SurfaceSpec& spec) {
  return spec.shading.value_or(scene.picture.shading);
}

Specular specular_of(const Scene& scene, const SurfaceSpec& spec) {
  return spec.specular.value_or(scene.picture.specular);
}

std::optional<GridSize> samples_of(const Scene& scene, const SurfaceSpec& spec) {
  return spec.samples ? spec.samples : scene.mesh.samples;
}

std::optional<Thickness> thickness_of(const Scene& scene, const SurfaceSpec& spec) {
  const std::optional<Thickness>& asked = spec.thickness ? spec.thickness : scene.mesh.thickness;
  const bool has_none = spec.is_stroke() || !asked || asked->where == Thickness::Where::Off;
  return has_none ? std::nullopt : asked;
}

bool draws_parameters(const Scene& scene) {
  return std::ranges::any_of(scene.surfaces, [&](const SurfaceSpec& spec) {
    return shading_of(scene, spec) == Shading::Exact || spec.texture;
  });
}

void set_time_range(Scene& scene, const Number& from, const Number& to) {
  if (!scene.animation) scene.animation.emplace();
  scene.animation->from = from;
  scene.animation->to = to;
  scene.t = from;
}

}  // namespace saddle
