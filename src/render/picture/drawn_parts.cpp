#include "render/picture/drawn_parts.h"

#include "scene/model/wall_material.h"

namespace saddle {
namespace {

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
    parts.push_back({&item, of_one_material(surface, surface.front), 0, front});
    parts.push_back({&item, of_one_material(surface, surface.back), front, back});
    if (walls > 0) {
      parts.push_back(
          {&item, of_one_material(surface, wall_material(surface)), front + back, walls});
    }
  }
  return parts;
}

}  // namespace saddle
