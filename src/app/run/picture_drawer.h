// The pictures of a run. OpenGL takes as long to start as a surface to tessellate, so it starts on
// a thread of its own.
#pragma once

#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "base/image.h"
#include "mesh/model/mesh.h"
#include "render/picture/light_findings.h"
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

  /// No light is on, if that is so in all pictures; cones that vertices lose, for each surface in
  /// the first picture that has some.
  std::vector<SceneFinding> findings() const;

  /// The report of a scene's picture. After draw(), like the functions below.
  ImageReport describe(const Image& image, const Scene& scene) const;
  /// The last picture left out the back faces of this surface.
  bool culls(std::size_t surface) const;
  const std::vector<SurfaceProgram>& programs() const { return maker_->surface_programs(); }
  const RenderTimes& times() const { return maker_->times(); }

 private:
  void find(const Scene& scene, std::span<const Mesh> meshes);

  std::future<std::unique_ptr<PictureMaker>> starting_;
  std::unique_ptr<PictureMaker> maker_;
  int bright_ = 0;  ///< pictures with lights that are on
  std::optional<SceneFinding> dark_;
  std::vector<SceneFinding> lost_;
};

}  // namespace saddle
