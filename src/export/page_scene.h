// The scene of a page, as the parts of its writer share it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "export/page_meshes.h"
#include "mesh/model/mesh.h"
#include "scene/model/camera.h"
#include "scene/model/color_scale.h"
#include "scene/model/scene.h"

namespace saddle {

/// A parameter that the page has a slider for.
struct PageParameter {
  std::string name;
  double value = 0, min = 0, max = 1;
};

/// Everything that the code of a page is about.
struct PageScene {
  Scene scene;                       ///< framed, with strokes; parameters of sliders are kept
  std::span<const Mesh> meshes;      ///< meshes[i] is that of scene.surfaces[i]
  std::span<const PageMesh> packed;  ///< the same
  std::vector<PageParameter> parameters;
  std::vector<ColorScale> scales;
  FittedCamera camera;
  double unit = 1;  ///< what shaders measure lengths in
};

}  // namespace saddle
