// The pictures of a run. OpenGL takes as long to start as a surface to tessellate, so it starts on
// a thread of its own.
#pragma once

#include <future>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "base/image.h"
#include "mesh/model/mesh.h"
#include "render/picture/picture.h"
#include "scene/model/scene.h"

namespace saddle {

class PictureDrawer {
 public:
  explicit PictureDrawer(Backend backend);

  /// Waits for OpenGL at the first picture. `updated`: the numbers of the surfaces that have other
  /// meshes than in the picture before. Throws Error as PictureMaker does.
  Image draw(const Scene& scene, std::span<const Mesh> meshes,
             std::span<const std::size_t> updated);

  /// Differences of the pictures from what was asked for.
  std::vector<std::string> warnings() const;

  /// The report of a scene's picture. After draw(), like the functions below.
  ImageReport describe(const Image& image, const Scene& scene) const;
  std::string shader_texts() const { return maker_->shader_texts(); }
  const RenderTimes& times() const { return maker_->times(); }

 private:
  std::future<std::unique_ptr<PictureMaker>> starting_;
  std::unique_ptr<PictureMaker> maker_;
};

}  // namespace saddle
