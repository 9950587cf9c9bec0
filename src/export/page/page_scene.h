// The scene of a page, as the parts of its writer share it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "export/page/page_meshes.h"
#include "mesh/model/mesh.h"
#include "scene/model/camera.h"
#include "scene/model/color_scale.h"
#include "scene/model/scene.h"

namespace saddle {

/// A parameter that the page has a slider for.
struct PageParameter {
  std::string name;
  double value = 0, min = 0, max = 1;
  double step = 0;                   ///< 0: any value between
  std::vector<std::string> choices;  ///< the parameter is the number of one of these
};

/// A texture's picture as a PNG file with rows from below, as OpenGL has them.
struct PagePicture {
  const TexturePicture* picture = nullptr;
  std::string png;
};

/// Everything that the code of a page is about.
struct PageScene {
  Scene scene;                       ///< framed, with strokes; parameters of sliders are kept
  std::span<const Mesh> meshes;      ///< meshes[i] is that of scene.surfaces[i]
  std::span<const PageMesh> packed;  ///< the same
  std::vector<PageParameter> parameters;
  std::vector<ColorScale> scales;
  std::vector<PagePicture> pictures;  ///< of the surfaces' textures, each one once
  FittedCamera camera;
  dvec3 centre{0, 0, 0};  ///< of all that is drawn, in the world
  double unit = 1;        ///< what shaders measure lengths in
};

}  // namespace saddle
