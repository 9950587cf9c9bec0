#include "view/drawing.h"

#include <algorithm>
#include <utility>

#include "render/picture/light_findings.h"
#include "view/marks.h"

namespace saddle {
namespace {

/// A moving picture that takes longer is drawn with one sample per pixel.
constexpr double kSmoothMs = 20;

/// Length of the normals shown, as a share of the surface's size.
constexpr double kNormalLength = 0.03;

}  // namespace

void Drawing::take_meshes(const Model& model) {
  const auto& meshes = model.meshes();
  Scene scene = model.last_good().scene;
  scene.picture.shading = model.scene().picture.shading;
  const bool exact = draws_parameters(scene);
  // Without meshes until all of them are there: uploading may throw.
  auto before = std::exchange(uploaded_, {});
  if (exact && !exact_) before.clear();
  exact_ = exact;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (i < before.size() && before[i] == meshes[i]) continue;
    renderer_.set_surface(scene, i, meshes[i]->mesh);
  }
  renderer_.keep_meshes(meshes.size());
  uploaded_ = meshes;
  make_marks(model);
  change();
}

void Drawing::show_normals(const Model& model, bool shown) {
  normals_ = shown;
  make_marks(model);
}

/// Normals, if they are wanted.
void Drawing::make_marks(const Model& model) {
  renderer_.remove_marks();
  Mesh marks;
  if (normals_) {
    for (const Instance& instance : instances(model.last_good().scene)) {
      append_normal_marks(model.meshes()[instance.surface]->mesh, instance.to_world,
                          kNormalLength * model.surface_size(), marks);
    }
  }
  if (!marks.lines.empty()) renderer_.set_marks(marks);
}

void Drawing::change() {
  stale_ = true;
  moved_ = Clock::now();
}

std::optional<Drawing::Clock::time_point> Drawing::due() const {
  if (!coarse_) return std::nullopt;
  return moved_ + kRest;
}

void Drawing::draw(const Model& model) {
  const auto begin = Clock::now();
  const bool rested = is_due(begin);
  if (!stale_ && !rested) return;
  if (!exact_ && draws_parameters(model.scene())) take_meshes(model);
  if (uploaded_ != model.meshes()) return give_up();
  const bool fast_enough = figures_.frame_ms * (per_side_ == 1 ? 4 : 1) <= kSmoothMs;
  PictureSettings picture = model.scene().picture;
  const int most = std::min(2, picture.antialias);
  per_side_ = rested || fast_enough ? most : 1;
  coarse_ = per_side_ < most;
  picture.antialias = per_side_;
  canvas_.draw(renderer_, model.drawn_scene(), model.grip().fitted,
               {.lines = model.grid, .wireframe = model.wireframe}, picture);
  const auto passed = Clock::now() - begin;
  spent_ += passed;
  figures_.frame_ms = std::chrono::duration<double, std::milli>(passed).count();
  ++figures_.frames;
  figures_.warnings = renderer_.warnings();
  if (const auto dark = no_light(model.scene())) figures_.warnings.push_back(warning_of(*dark));
  stale_ = false;
}

}  // namespace saddle
