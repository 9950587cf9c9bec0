// The data that writers of formats get.
#pragma once

#include <span>

#include "base/image.h"
#include "mesh/model/mesh.h"
#include "scene/model/scene.h"

namespace saddle {

/// A picture of a scene at one moment.
struct PictureContent {
  const Image& image;
  const Scene& scene;
  unsigned threads = 0;  ///< 0: all
};

/// The meshes of a scene at one moment.
struct MeshContent {
  std::span<const Mesh> meshes;  ///< meshes[i] is that of scene.surfaces[i]
  const Scene& scene;
};

}  // namespace saddle
