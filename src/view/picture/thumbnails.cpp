#include "view/picture/thumbnails.h"

#include <exception>
#include <utility>

#include "base/parallel.h"
#include "meshing/tessellate.h"
#include "render/picture/picture_in_tiles.h"
#include "render/picture/renderer.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

/// A picture of a hundred pixels shows no more.
constexpr GridSize kCells{32, 32};

/// New pictures are shown together: each showing paints the whole window.
constexpr std::chrono::milliseconds kWakeEvery{100};

/// The context is this thread's while it lives.
class Entered {
 public:
  explicit Entered(Context& context) : context_(context) { context_.enter(); }
  ~Entered() { context_.leave(); }
  Entered(const Entered&) = delete;
  Entered& operator=(const Entered&) = delete;

 private:
  Context& context_;
};

Image draw_entry(Renderer& renderer, const GalleryEntry& entry, int width, int height) {
  Scene scene = resolve(gallery_scene(entry));
  scene.picture.width = width;
  scene.picture.height = height;
  scene.mesh.samples = kCells;
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    SurfaceSpec& spec = scene.surfaces[i];
    spec.grid = GridSize{0, 0};
    meshes.push_back(tessellate(scene, spec, {.picture = true}, 1).mesh);
    renderer.set_surface(scene, i, meshes.back());
  }
  renderer.keep_meshes(meshes.size());
  const FittedCamera camera = fit_to_meshes(scene, meshes, dvec2(width, height));
  return draw_image(renderer, scene, camera, scene.picture);
}

}  // namespace

Thumbnails::Thumbnails(std::unique_ptr<Context> context, int width, int height,
                       std::function<void()> wake)
    : context_(std::move(context)), width_(width), height_(height), wake_(std::move(wake)) {}

/// The context ends once the worker has left it.
Thumbnails::~Thumbnails() {
  worker_ = {};
}

void Thumbnails::go_on() {
  if (are_all_taken()) return;
  if (worker_.joinable() && !worker_.get_stop_token().stop_requested()) return;
  worker_ = {};
  worker_ = std::jthread([this](const std::stop_token& end) { draw_all(end); });
}

/// Without a context there are no pictures.
void Thumbnails::draw_all(const std::stop_token& end) {
  const Abandonable abandonable(end);
  try {
    const Entered entered(*context_);
    Renderer renderer;
    while (drawn_ < gallery().size()) {
      try {
        add(draw_entry(renderer, gallery()[drawn_], width_, height_));
      } catch (const Abandoned&) {
        return;
      } catch (const std::exception&) {
        add({});
      }
    }
  } catch (const std::exception&) {
    while (drawn_ < gallery().size()) add({});
  }
}

void Thumbnails::add(Image image) {
  {
    const std::lock_guard lock(mutex_);
    images_.push_back(std::move(image));
  }
  const auto now = std::chrono::steady_clock::now();
  if (++drawn_ < gallery().size() && now < woken_ + kWakeEvery) return;
  woken_ = now;
  wake_();
}

bool Thumbnails::take() {
  std::vector<Image> images;
  {
    const std::lock_guard lock(mutex_);
    images.swap(images_);
  }
  for (const Image& image : images) {
    auto& texture = textures_.emplace_back();
    if (image.width > 0) texture.emplace(image);
  }
  return !images.empty();
}

bool Thumbnails::are_all_taken() const {
  return textures_.size() == gallery().size();
}

unsigned Thumbnails::texture(std::size_t entry) const {
  if (entry >= textures_.size() || !textures_[entry]) return 0;
  return textures_[entry]->name();
}

}  // namespace saddle
