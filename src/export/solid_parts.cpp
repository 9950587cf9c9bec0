#include "export/solid_parts.h"

#include "scene/model/wall_material.h"

namespace saddle {

std::vector<PartRange> parts_of(const Mesh& mesh) {
  if (!mesh.solid) return {{SolidPart::Front, 0, mesh.triangles.size()}};
  const auto& [front, back, walls] = *mesh.solid;
  std::vector<PartRange> parts;
  for (const PartRange& part :
       {PartRange{SolidPart::Front, 0, front}, PartRange{SolidPart::Back, front, back},
        PartRange{SolidPart::Walls, front + back, walls}}) {
    if (part.count > 0) parts.push_back(part);
  }
  return parts;
}

Material material_of(const SurfaceSpec& surface, SolidPart part) {
  if (part == SolidPart::Walls) return wall_material(surface);
  return part == SolidPart::Back ? surface.back : surface.front;
}

}  // namespace saddle
