// A scene and its meshes become a picture.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"
#include "mesh/mesh.h"
#include "render/context.h"
#include "scene/scene.h"

namespace saddle {

/// Milliseconds of each stage.
struct RenderTimes {
  double context = 0;  ///< library, context and GL functions
  double upload = 0;   ///< meshes to the GPU
  double draw = 0;     ///< compiling shaders, drawing, reading back, averaging
};

struct Rendering {
  Image image;
  RenderTimes times;
  std::string renderer;               ///< "osmesa" ...
  std::string shaders;                ///< the programs that were made for the surfaces, as text
  std::vector<std::string> warnings;  ///< in which ways it is not what was asked for
};

/// Draws `meshes[i]` with the materials of `scene.surfaces[i]`. Throws Error: Machine if there is
/// no OpenGL, or the picture is larger than it can draw; Input for a camera that cannot be.
Rendering render(const Scene& scene, std::span<const Mesh> meshes, const PictureSettings& options,
                 Backend backend = Backend::Any);

/// Loads OpenGL ahead of time: call it in a thread beside tessellation when a picture will be
/// wanted. It saves render() the loading, and leaves any failure for render() to report.
void preload_renderer(Backend backend) noexcept;

}  // namespace saddle
