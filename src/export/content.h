// The data that writers of formats get.
#pragma once

#include <span>
#include <string>

#include "base/image.h"
#include "export/shells.h"
#include "mesh/model/mesh.h"
#include "scene/model/scene.h"
#include "scene/options/run_settings.h"

namespace saddle {

/// A picture of a scene at one moment.
struct PictureContent {
  const Image& image;
  const Scene& scene;
  unsigned threads = 0;  ///< 0: all
};

/// The meshes of a scene at one moment, and how their file has them.
struct MeshContent {
  std::span<const Mesh> meshes;  ///< meshes[i] is that of scene.surfaces[i]
  const Scene& scene;
  std::span<const Shells> shells = {};  ///< of the meshes; empty: the writer finds them if need be
  unsigned threads = 0;                 ///< 0: all
  double factor = 1;                    ///< from the scene's units to the file's
  bool y_up = false;  ///< the file's y axis is the scene's z axis, as in GLB always
  /// The file's name without its extension, with which names of the files beside it begin. Empty:
  /// there are none, as beside standard output.
  std::string stem = {};
};

/// A scene at one moment, for a page that draws it.
struct PageContent {
  std::span<const Mesh> meshes;  ///< meshes[i] is that of scene.surfaces[i]
  const Scene& scene;
  const Scene& seen;                ///< the same with the camera and the colours of the picture
  std::string sliders;              ///< the parameters that the page offers: "all", "off", or names
  bool fragment = false;            ///< without html and body, for another page
  Backend renderer = Backend::Any;  ///< of a figure's image
};

}  // namespace saddle
