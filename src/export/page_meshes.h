// The meshes of a page as bytes, which src/export/page/payload.js reads back.
#pragma once

#include <string>
#include <string_view>

#include "mesh/model/mesh.h"
#include "scene/model/scene.h"

namespace saddle {

/// The part of a mesh that formulas do not give.
struct PageMesh {
  std::string bytes;
  Bounds box;          ///< in which its baked places are numbers of 16 bits
  bool fixed = false;  ///< the mesh is not on the formulas' surface: a tube round a curve
};

/// A mesh of `spec`: the parameters of its corners, rounded to 16 bits, its triangles and lines.
/// Corners that the formulas have elsewhere than `within`, at the rounded parameters, or with
/// another normal, are baked. `scene`: resolved. Throws Error (Input) as prepare_surface() does.
PageMesh page_mesh(const Scene& scene, const SurfaceSpec& spec, const Mesh& mesh, double within);

/// The colours of a colormap as bytes, red, green and blue of 256 places.
std::string colormap_bytes(const std::string& name);

}  // namespace saddle
