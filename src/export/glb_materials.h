// The materials of a GLB file.
#pragma once

#include <cstddef>

#include "export/glb_file.h"
#include "scene/model/scene.h"

namespace saddle {

struct GlbMaterial {
  Material material;
  double opacity = 1;
  bool textured = false;  ///< by the picture of colours
  bool unlit = false;
  bool double_sided = false;
};

/// Adds the material unless the file has it. Returns its number.
std::size_t add_material(const GlbMaterial& look, GlbFile& file);

/// A material of one colour that no light changes, seen from both sides.
GlbMaterial plain_look(const Color& color);

}  // namespace saddle
