// The meshes of a GLB file.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "export/common/content.h"
#include "export/meshes/glb_file.h"
#include "export/meshes/glb_textures.h"
#include "scene/model/color_scale.h"

namespace saddle {

/// A surface as a mesh of glTF. It refers to the mesh.
struct GlbSurface {
  const Mesh& mesh;
  const SurfaceSpec& spec;
  Color contours = {};  ///< of its level lines
  bool unlit = false;
  std::optional<ColorScale> scale = {};
  std::size_t colors = 0;          ///< the texture of its colours
  std::size_t row = 0;             ///< of its scale in that picture,
  std::size_t rows = 1;            ///< which has so many
  std::vector<dvec2> places = {};  ///< on its own texture, of corners; empty: it has none
};

/// Adds the mesh around the centre of its box, with its materials. Returns its number.
std::size_t add_mesh(const GlbSurface& surface, GlbTextures& textures, GlbFile& file);

}  // namespace saddle
