// The parts of meshes that have materials of their own: a solid shows the front of its surface on
// one side, the back on the other, and walls between them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/gl/gpu_mesh.h"
#include "render/picture/placed_mesh.h"
#include "render/shading/shader_materials.h"
#include "scene/model/scene.h"

namespace saddle {

/// Triangles of a placed mesh that have the same two materials.
struct DrawnPart {
  const PlacedMesh* item;
  SideMaterials materials;
  std::size_t first = 0;
  std::size_t count = 0;
};

/// The parts of all items, in their order. A sheet is one part. Each part of a solid has one
/// material on both sides: the surface's front or back, or wall_material(). `meshes`: of the
/// scene's surfaces.
std::vector<DrawnPart> parts_of(const Scene& scene, std::span<const PlacedMesh> items,
                                std::span<const GpuMesh> meshes);

}  // namespace saddle
