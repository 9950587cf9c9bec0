#include "view/picture/thumbnails.h"

#include <exception>
#include <utility>

#include "meshing/tessellate.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

/// A picture of a hundred pixels shows no more.
constexpr GridSize kCells{32, 32};

/// draw() returns after this time.
constexpr std::chrono::milliseconds kThumbnailTurn{15};

}  // namespace

void Thumbnails::fit(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  pictures_.clear();
}

bool Thumbnails::draw() {
  const auto begin = std::chrono::steady_clock::now();
  while (pictures_.size() < gallery().size()) {
    if (std::chrono::steady_clock::now() > begin + kThumbnailTurn) return true;
    draw_next();
  }
  renderer_.reset();
  return false;
}

unsigned Thumbnails::texture(std::size_t entry) const {
  if (entry >= pictures_.size() || !pictures_[entry]) return 0;
  return pictures_[entry]->name();
}

/// One that cannot be drawn stays empty.
void Thumbnails::draw_next() {
  const std::size_t entry = pictures_.size();
  pictures_.emplace_back();
  if (!renderer_) renderer_.emplace();
  try {
    Scene scene = resolve(gallery_scene(gallery()[entry]));
    scene.picture.width = width_;
    scene.picture.height = height_;
    scene.mesh.samples = kCells;
    std::vector<Mesh> meshes;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
      SurfaceSpec& spec = scene.surfaces[i];
      spec.grid_u = spec.grid_v = 0;
      meshes.push_back(tessellate(scene, spec, {.picture = true}, 1).mesh);
      renderer_->set_surface(scene, i, meshes.back());
    }
    renderer_->keep_meshes(meshes.size());
    const FittedCamera camera =
        fit_to_meshes(scene, meshes, dvec2(scene.picture.width, scene.picture.height));
    pictures_[entry].emplace(draw_image(*renderer_, scene, camera, scene.picture));
  } catch (const std::exception&) {
  }
}

}  // namespace saddle
