#include "app/run/picture_drawer.h"

#include <algorithm>
#include <utility>

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
  find(scene, meshes);
  return maker_->draw(scene, meshes, scene.picture);
}

void PictureDrawer::find(const Scene& scene, std::span<const Mesh> meshes) {
  if (auto dark = no_light(scene)) {
    dark_ = std::move(dark);
  } else {
    ++bright_;
  }
  const dvec2 size(scene.picture.width, scene.picture.height);
  for (SceneFinding& found : lost_cones(scene, meshes, size)) {
    const auto is_known = [&](const SceneFinding& known) { return known.surface == found.surface; };
    if (std::ranges::none_of(lost_, is_known)) lost_.push_back(std::move(found));
  }
}

std::vector<SceneFinding> PictureDrawer::findings() const {
  std::vector<SceneFinding> all = lost_;
  if (dark_ && bright_ == 0) all.push_back(*dark_);
  return all;
}

std::vector<std::string> PictureDrawer::warnings() const {
  return maker_ ? maker_->warnings() : std::vector<std::string>();
}

bool PictureDrawer::culls(std::size_t surface) const {
  const auto known = maker_->culled().find(surface);
  return known != maker_->culled().end() && known->second;
}

ImageReport PictureDrawer::describe(const Image& image, const Scene& scene) const {
  return {image.width, image.height, maker_->renderer(), scene.surfaces.size(),
          instances(scene).size()};
}

}  // namespace saddle
