// A scene as JavaScript: its formulas as functions of the parameters, its numbers, its shaders.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "export/page_meshes.h"
#include "mesh/model/mesh.h"
#include "scene/model/camera.h"
#include "scene/model/color_scale.h"
#include "scene/model/scene.h"

namespace saddle {

/// Text in quotes that is safe inside of a script of a page.
std::string js_string(const std::string& text);

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

/// The statement that defines `scene`, which the scripts of src/export/page/ read.
std::string page_scene_code(const PageScene& page);

/// A parameter's place in the array that the page's functions take; 0 is t.
inline std::string parameter_of(std::size_t index) {
  return "p[" + std::to_string(index) + "]";
}

}  // namespace saddle
