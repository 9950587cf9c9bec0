#include "view/picture/saver.h"

#include <cctype>
#include <functional>
#include <ostream>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "export/page/page.h"
#include "export/pictures/scene_png.h"
#include "render/picture/picture_in_tiles.h"
#include "render/picture/renderer.h"
#include "scene/model/strokes.h"
#include "scene/options/resolve.h"
#include "scene/options/run_settings.h"
#include "scene/toml/scene_file.h"
#include "view/model/model.h"

namespace saddle {
namespace {

/// "torus.png", or the first of "torus-2.png" ... that does not exist.
std::filesystem::path free_name(const std::string& title, const std::string& extension) {
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

std::string write(const Scene& scene, const char* extension,
                  const std::function<void(std::ostream&)>& content) {
  const auto path = free_name(scene.title, extension);
  write_file_whole(path, content);
  return "saved " + path.string();
}

std::string write_picture(const Image& image, const Scene& scene) {
  return write(scene, ".png", [&](std::ostream& out) { write_scene_png(out, {image, scene}); });
}

std::string write_page_of(const Meshed& meshed) {
  std::vector<Mesh> meshes;
  for (const auto& surface : meshed.surfaces) meshes.push_back(surface->mesh);
  const PageContent content{meshes, meshed.scene, meshed.scene, RunSettings{}.sliders};
  return write(meshed.scene, ".html", [&](std::ostream& out) { write_page(out, content); });
}

}  // namespace

std::filesystem::path save_scene(const Scene& scene) {
  auto path = free_name(scene.title, ".toml");
  const std::string text = write_scene(scene);
  write_file_whole(path, [&](std::ostream& out) { out << text; });
  return path;
}

Saver::Saver(Tessellate tessellate, std::function<void()> wake)
    : wake_(wake), worker_(std::move(tessellate), std::move(wake)) {}

void Saver::save_picture(Scene scene) {
  save({std::move(scene)});
}

void Saver::save_page(Scene scene) {
  save({std::move(scene), true});
}

void Saver::save(Wanted wanted) {
  const bool is_free = !is_busy();
  wanted.scene = with_strokes(resolve(std::move(wanted.scene)));
  waiting_.push_back(std::move(wanted));
  if (is_free) mesh_next();
}

void Saver::mesh_next() {
  if (!waiting_.empty()) worker_.request(waiting_.front().scene, Manner::Full);
}

std::optional<std::string> Saver::pass() {
  if (is_written_.exchange(false)) {
    writer_.join();
    mesh_next();
    return std::move(news_);
  }
  const auto meshed = worker_.take();
  if (!meshed) return std::nullopt;
  const bool is_page = waiting_.front().page;
  waiting_.pop_front();
  try {
    if (meshed->error) throw Error(*meshed->error);
    if (is_page) {
      start_writing([meshed = *meshed] { return write_page_of(meshed); });
    } else {
      start_writing([image = draw_meshed(*meshed), scene = meshed->scene] {
        return write_picture(image, scene);
      });
    }
    return std::nullopt;
  } catch (...) {
    news_ = caught_error().what();
  }
  mesh_next();
  return std::move(news_);
}

void Saver::start_writing(std::function<std::string()> write) {
  writer_ = std::jthread([this, write = std::move(write)] {
    try {
      news_ = write();
    } catch (...) {
      news_ = caught_error().what();
    }
    is_written_ = true;
    wake_();
  });
}

}  // namespace saddle
