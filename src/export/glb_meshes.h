// The meshes of a GLB file.
#pragma once

#include <cstddef>
#include <optional>

#include "export/content.h"
#include "export/glb_file.h"
#include "scene/model/color_scale.h"

namespace saddle {

/// A surface as a mesh of glTF. It refers to the mesh.
struct GlbSurface {
  const Mesh& mesh;
  const SurfaceSpec& spec;
  bool unlit = false;
  std::optional<ColorScale> scale = {};
  std::size_t row = 0;   ///< of its scale in the picture of colours,
  std::size_t rows = 1;  ///< which has so many
};

/// Adds the mesh around the centre of its box, with its materials. Returns its number. The file's
/// texture 0 is the picture of colours.
std::size_t add_mesh(const GlbSurface& surface, GlbFile& file);

}  // namespace saddle
