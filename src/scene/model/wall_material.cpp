#include "scene/model/wall_material.h"

namespace saddle {
namespace {

Color mean(const Color& a, const Color& b) {
  return {(a.r + b.r) / 2, (a.g + b.g) / 2, (a.b + b.b) / 2, (a.a + b.a) / 2};
}

}  // namespace

Material wall_material(const SurfaceSpec& surface) {
  const Material& a = surface.front;
  const Material& b = surface.back;
  Material wall;
  wall.diffuse = mean(a.diffuse, b.diffuse);
  wall.specular = mean(a.specular, b.specular);
  wall.shininess = (a.shininess + b.shininess) / 2;
  wall.emission = mean(a.emission, b.emission);
  if (a.ambient || b.ambient) {
    wall.ambient = mean(a.ambient.value_or(a.diffuse), b.ambient.value_or(b.diffuse));
  }
  return wall;
}

}  // namespace saddle
