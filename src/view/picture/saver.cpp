#include "view/picture/saver.h"

#include <cctype>
#include <ostream>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "export/pictures/scene_png.h"
#include "render/picture/picture_in_tiles.h"
#include "render/picture/renderer.h"
#include "scene/model/strokes.h"
#include "scene/options/resolve.h"
#include "scene/toml/scene_file.h"
#include "view/model/model.h"

namespace saddle {

std::filesystem::path free_file_name(const std::string& title, const std::string& extension) {
  std::string stem;
  for (const char c : title) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    stem += plain ? c : '-';
  }
  if (stem.empty()) stem = "saddle";
  std::filesystem::path path = stem + extension;
  for (int i = 2; std::filesystem::exists(path); ++i) {
    path = stem + "-" + std::to_string(i) + extension;
  }
  return path;
}

namespace {

/// The scene's picture and nothing else: no normals, no wires.
Image draw_meshed(const Meshed& meshed) {
  const Scene& scene = meshed.scene;
  Renderer renderer;
  for (std::size_t i = 0; i < meshed.surfaces.size(); ++i) {
    renderer.set_surface(scene, i, meshed.surfaces[i]->mesh);
  }
  const FittedCamera camera = fit_to(meshed, scene.picture);
  return draw_image(renderer, scene, camera, scene.picture);
}

std::string write_picture(const Image& image, const Scene& scene) {
  const auto path = free_file_name(scene.title, ".png");
  write_file_whole(path, [&](std::ostream& out) { write_scene_png(out, {image, scene}); });
  return "saved " + path.string();
}

}  // namespace

std::filesystem::path save_scene(const Scene& scene) {
  auto path = free_file_name(scene.title, ".toml");
  const std::string text = write_scene(scene);
  write_file_whole(path, [&](std::ostream& out) { out << text; });
  return path;
}

Saver::Saver(Tessellate tessellate, std::function<void()> wake)
    : wake_(wake), worker_(std::move(tessellate), std::move(wake)) {}

void Saver::save_picture(Scene scene) {
  const bool is_free = !is_busy();
  waiting_.push_back(with_strokes(resolve(std::move(scene))));
  if (is_free) mesh_next();
}

void Saver::mesh_next() {
  if (!waiting_.empty()) worker_.request(waiting_.front(), Manner::Full);
}

std::optional<std::string> Saver::pass() {
  if (is_written_.exchange(false)) {
    writer_.join();
    mesh_next();
    return std::move(news_);
  }
  const auto meshed = worker_.take();
  if (!meshed) return std::nullopt;
  waiting_.pop_front();
  try {
    if (meshed->error) throw Error(*meshed->error);
    start_writing(draw_meshed(*meshed), meshed->scene);
    return std::nullopt;
  } catch (...) {
    news_ = caught_error().what();
  }
  mesh_next();
  return std::move(news_);
}

void Saver::start_writing(Image image, Scene scene) {
  writer_ = std::jthread([this, image = std::move(image), scene = std::move(scene)] {
    try {
      news_ = write_picture(image, scene);
    } catch (...) {
      news_ = caught_error().what();
    }
    is_written_ = true;
    wake_();
  });
}

}  // namespace saddle
