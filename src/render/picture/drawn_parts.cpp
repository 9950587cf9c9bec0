#include "render/picture/drawn_parts.h"

namespace saddle {
namespace {

Color mean(const Color& a, const Color& b) {
  return {(a.r + b.r) / 2, (a.g + b.g) / 2, (a.b + b.b) / 2, (a.a + b.a) / 2};
}

Material mean(const Material& a, const Material& b) {
  Material material;
  material.diffuse = mean(a.diffuse, b.diffuse);
  material.specular = mean(a.specular, b.specular);
  material.shininess = (a.shininess + b.shininess) / 2;
  material.emission = mean(a.emission, b.emission);
  if (a.ambient || b.ambient) {
    material.ambient = mean(a.ambient.value_or(a.diffuse), b.ambient.value_or(b.diffuse));
  }
  return material;
}

SurfaceSpec of_one_material(const SurfaceSpec& surface, const Material& material) {
  SurfaceSpec spec = surface;
  spec.front = spec.back = material;
  return spec;
}

}  // namespace

std::vector<DrawnPart> parts_of(const Scene& scene, std::span<const PlacedMesh> items,
                                std::span<const GpuMesh> meshes) {
  std::vector<DrawnPart> parts;
  for (const PlacedMesh& item : items) {
    const SurfaceSpec& surface = scene.surfaces[item.surface];
    const GpuMesh& mesh = meshes[item.surface];
    if (!mesh.solid()) {
      parts.push_back({&item, surface, 0, mesh.triangle_count()});
      continue;
    }
    const auto& [front, back, walls] = *mesh.solid();
    const Material middle = mean(surface.front, surface.back);
    parts.push_back({&item, of_one_material(surface, surface.front), 0, front});
    parts.push_back({&item, of_one_material(surface, surface.back), front, back});
    if (walls > 0) {
      parts.push_back({&item, of_one_material(surface, middle), front + back, walls});
    }
  }
  return parts;
}

}  // namespace saddle
