#include "render/picture/drawn_parts.h"

#include "scene/model/wall_material.h"

namespace saddle {

std::vector<DrawnPart> parts_of(const Scene& scene, std::span<const PlacedMesh> items,
                                std::span<const GpuMesh> meshes) {
  std::vector<DrawnPart> parts;
  for (const PlacedMesh& item : items) {
    const SurfaceSpec& surface = scene.surfaces[item.surface];
    const GpuMesh& mesh = meshes[item.surface];
    if (!mesh.solid()) {
      parts.push_back({&item, {surface.front, surface.back}, 0, mesh.triangle_count()});
      continue;
    }
    const auto& [front, back, walls] = *mesh.solid();
    parts.push_back({&item, {surface.front, surface.front}, 0, front});
    parts.push_back({&item, {surface.back, surface.back}, front, back});
    if (walls > 0) {
      const Material wall = wall_material(surface);
      parts.push_back({&item, {wall, wall}, front + back, walls});
    }
  }
  return parts;
}

}  // namespace saddle
