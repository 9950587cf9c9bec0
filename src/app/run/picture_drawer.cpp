#include "app/run/picture_drawer.h"

#include "base/parallel.h"
#include "scene/model/instances.h"

namespace saddle {

PictureDrawer::PictureDrawer(Backend backend)
    : starting_(run_beside([backend] { return start_picture_maker(backend); })) {}

Image PictureDrawer::draw(const Scene& scene, std::span<const Mesh> meshes,
                          std::span<const std::size_t> updated) {
  if (!maker_) {
    maker_ = starting_.get();
    maker_->enter();
  }
  for (const std::size_t i : updated) maker_->set_surface(scene, i, meshes[i]);
  return maker_->draw(scene, meshes, scene.picture);
}

std::vector<std::string> PictureDrawer::warnings() const {
  return maker_ ? maker_->warnings() : std::vector<std::string>();
}

ImageReport PictureDrawer::describe(const Image& image, const Scene& scene) const {
  return {image.width,
          image.height,
          maker_->renderer(),
          scene.surfaces.size(),
          instances(scene).size(),
          maker_->shader_texts()};
}

}  // namespace saddle
