// The parts of exported meshes that have materials of their own: a solid shows the front of its
// surface on one side, the back on the other, and walls between them.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/model/mesh.h"
#include "scene/model/scene.h"

namespace saddle {

enum class SolidPart { Front, Back, Walls };

/// Triangles of a mesh, one after the other.
struct PartRange {
  SolidPart part;
  std::size_t first = 0;
  std::size_t count = 0;

  std::size_t end() const { return first + count; }
};

/// The parts that have triangles, in the order of the triangles. A sheet is a front alone.
std::vector<PartRange> parts_of(const Mesh& mesh);

/// The material of a part, seen from outside. The surface is resolved.
Material material_of(const SurfaceSpec& surface, SolidPart part);

}  // namespace saddle
