#include "export/page_solids.h"

#include <algorithm>
#include <utility>

#include "export/solid_parts.h"

namespace saddle {
namespace {

Mesh mesh_of_part(const Mesh& solid, const PartRange& part) {
  Mesh mesh = solid;
  mesh.triangles.resize(part.count);
  std::copy_n(solid.triangles.data() + part.first, part.count, mesh.triangles.data());
  if (part.first == 0) return mesh;
  mesh.lines.clear();
  mesh.contours = {};
  mesh.anchor.reset();
  return mesh;
}

}  // namespace

void split_solids(PageScene& page, std::vector<Mesh>& meshes) {
  const auto is_solid = [](const Mesh& mesh) { return mesh.solid.has_value(); };
  if (std::ranges::none_of(page.meshes, is_solid)) return;
  std::vector<SurfaceSpec> surfaces;
  for (std::size_t i = 0; i < page.meshes.size(); ++i) {
    const Mesh& mesh = page.meshes[i];
    const SurfaceSpec& spec = page.scene.surfaces[i];
    if (!mesh.solid) {
      meshes.push_back(mesh);
      surfaces.push_back(spec);
      continue;
    }
    for (const PartRange& part : parts_of(mesh)) {
      meshes.push_back(mesh_of_part(mesh, part));
      SurfaceSpec& own = surfaces.emplace_back(spec);
      own.front = own.back = material_of(spec, part.part);
    }
  }
  page.scene.surfaces = std::move(surfaces);
  page.meshes = meshes;
}

}  // namespace saddle
