#include "view/model/model.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>
#include <vector>

#include "base/format.h"
#include "render/picture/framing.h"
#include "scene/model/strokes.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

/// How long the camera must rest before the mesh is made for where it is, and the change of its
/// distance that is not waited for: the mesh's tolerance is off by as much.
constexpr std::chrono::milliseconds kRest{150};
constexpr double kMuchNearer = 1.5;

/// Nearer than this share of the distance at which the surface's whole box is in the picture, the
/// mesh may be finer where the camera looks.
constexpr double kClose = 0.7;

/// While t plays, meshes that take longer are not waited for: coarse ones are shown.
constexpr double kKeepsUpMs = 100;

/// Whether two cameras look at the same point from the same distance.
bool are_placed_alike(const Camera& a, const Camera& b) {
  return a.distance == b.distance && a.target == b.target;
}

/// The camera changes what a tolerance in pixels is.
bool sees_another_size(const Camera& a, const Camera& b) {
  return !are_placed_alike(a, b) || a.ortho != b.ortho || a.fov != b.fov || a.zoom != b.zoom;
}

/// So does what it sees, if it is close.
bool sees_from_elsewhere(const Camera& a, const Camera& b) {
  return a.view != b.view || a.up != b.up;
}

/// The camera of an animation, where it fits itself, holds all of it. A scene with an error is left
/// as it is: the viewer will show that.
void frame_animation(Scene& scene, unsigned threads) {
  try {
    Timeline timeline(scene);
    Framing framing = frame_scene(timeline, threads);
    framing.box.reset();  // what is edited has other ones soon
    framing.colors.clear();
    framing.contours.clear();
    framing.apply(scene);
  } catch (const std::exception&) {
  }
}

/// Some number of the scene depends on t, or the camera does.
bool has_moving_numbers(const Scene& scene) {
  if (scene.camera.turntable) return true;
  try {
    Timeline timeline(scene);
    timeline.at(scene.t);
    return timeline.moves();
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

Model::Model(ViewerSetup setup, std::function<void()> wake)
    : scene_(std::move(setup.scene)),
      reload_(std::move(setup.reload)),
      file_(std::move(setup.file)),
      threads_(setup.threads),
      worker_(setup.tessellate ? setup.tessellate : tessellate_for_picture(setup.threads),
              std::move(wake)) {
  view_.table_up = scene_.camera.up;
  frame();
  request_meshes(Manner::PreviewFirst);
}

/// Lets the camera hold an animation as it has become, unless a hand has placed it.
void Model::frame() {
  is_edited_ = false;
  Camera before = scene_.camera;
  if (framed_ && are_placed_alike(before, framed_->after)) {
    before.target = framed_->before.target;
    before.distance = framed_->before.distance;
  }
  scene_.camera = before;
  frame_animation(scene_, threads_);
  framed_.reset();
  if (!are_placed_alike(before, scene_.camera)) framed_ = FramedCamera{scene_.camera, before};
}

Scene Model::drawn_scene() const {
  Scene drawn = with_strokes(scene_);
  if (drawn.surfaces.size() != good_.surfaces.size()) drawn.surfaces = good_.scene.surfaces;
  drawn.surfaces.resize(good_.surfaces.size());  // to none before the first mesh is there
  return drawn;
}

Grip Model::grip() const {
  Bounds bounds = bounds_;
  if (bounds.empty()) bounds.add(dvec3(0));
  const dvec2 pixels = size();
  const double aspect = pixels.x / pixels.y;
  const Camera& camera = scene_.camera;
  const dvec3 scale = scene_.scale.factors;
  const ViewPyramid empty =
      pyramid_beside_annotations(drawn_scene(), good_.surfaces, bounds, pixels);
  if (camera.target && camera.distance) {  // what is seen is not asked for
    return {camera, fit_camera(drawn_camera(scene_), bounds, aspect, &empty), pixels, scale};
  }
  if (!seen_ || !seen_->fits(empty)) {
    seen_ = empty;
    add_meshes(good_, *seen_);
  }
  return {camera, fit_camera(drawn_camera(scene_), bounds, aspect, &*seen_), pixels, scale};
}

dvec2 Model::size() const {
  return {scene_.picture.width, scene_.picture.height};
}

void Model::resize(const dvec2& size) {
  scene_.picture.width = static_cast<int>(size.x);
  scene_.picture.height = static_cast<int>(size.y);
  refine_at_ = Clock::now() + kRest;
}

/// A file that cannot be read now is passing news; a mistake in one that can be stands until it is
/// mended.
void Model::reload() {
  if (!reload_) return;
  std::error_code ignored;
  if (!file_.empty() && !std::filesystem::exists(file_, ignored)) {
    news_ = "there is no " + file_.string() + " any more: its scene stays here, and S saves it";
    return;
  }
  try {
    Scene scene = reload_();
    scene.camera = scene_.camera;
    record("", true);
    take_place(std::move(scene));
  } catch (...) {
    const Error error = caught_error();
    if (error.status() == Status::Machine) {
      news_ = error.what();
      return;
    }
    error_ = error;
    faulty_.reset();
  }
}

/// To be called before a change.
void Model::record(const std::string& what, bool is_work) {
  history_.record({{scene_, view_, framed_}, is_work}, what);
}

void Model::edit(Scene scene, const std::string& what) {
  record(what, true);
  scene_ = std::move(scene);
  is_edited_ = true;
  request_meshes(Manner::PreviewFirst);
}

void Model::change_view(ViewState view, const std::string& what) {
  record(what, true);
  view_ = std::move(view);
}

/// While a field is being edited, the camera stays.
void Model::end_edit() {
  history_.end_edit();
  if (!is_edited_) return;
  frame();
  look_through(scene_.camera);
}

void Model::undo() {
  restore(history_.undo({scene_, view_, framed_}));
}

void Model::redo() {
  restore(history_.redo({scene_, view_, framed_}));
}

/// Takes a state of the history, if there is one. The window's size stays.
void Model::restore(std::optional<PastState> step) {
  if (!step) return;
  played_.reset();
  view_ = step->state.view;
  framed_ = step->state.framed;
  take_place(std::move(step->state.scene));
}

/// In place of the scene, in a window of the same size.
void Model::take_place(Scene scene) {
  scene.picture.width = scene_.picture.width;
  scene.picture.height = scene_.picture.height;
  scene_ = std::move(scene);
  frame();
  request_meshes(Manner::PreviewFirst);
}

void Model::open(Scene scene, std::function<Scene()> reload, std::filesystem::path file) {
  record("", true);
  reload_ = std::move(reload);
  file_ = std::move(file);
  view_.lights = {};
  view_.table_up = scene.camera.up;
  view_.playing = false;
  played_.reset();
  take_place(std::move(scene));
}

bool Model::has(Needs needs) const {
  switch (needs) {
    case Needs::Past:
      return history_.has_past();
    case Needs::Future:
      return history_.has_future();
    case Needs::Movement:
      return moves_ || view_.playing || played_;
    case Needs::Source:
      return reload_ != nullptr;
    case Needs::Surface:
      return !scene_.surfaces.empty();
    case Needs::Work:
    case Needs::Nothing:
      return true;
  }
  return true;
}

/// The mesh depends on what a pixel is, and close up on what is seen. Where a hand on a surface as
/// large as numbers get leads beyond them, the camera stays.
void Model::look_through(const Camera& camera) {
  if (!is_possible(camera)) return;
  const bool close = is_close(camera);
  const Camera before = meshed_camera_.value_or(scene_.camera);
  const bool refine =
      sees_another_size(camera, before) || (close && sees_from_elsewhere(camera, before));
  scene_.camera = camera;
  if (!refine) return;
  refine_at_ = Clock::now() + kRest;
  if (close && keeps_up()) return request_meshes(Manner::InTurn);
  if (!camera.distance || !before.distance) return;
  const double nearer = *before.distance / *camera.distance;
  if (nearer > kMuchNearer && !worker_.is_busy()) request_meshes(Manner::Full);
}

void Model::look_by_hand(const Camera& camera, const std::string& what) {
  record(what, false);
  look_through(camera);
}

bool Model::is_close(const Camera& camera) const {
  if (!camera.distance || bounds_.empty()) return false;
  const dvec2 pixels = size();
  const FittedCamera whole = fit_camera(fit_again(camera), bounds_, pixels.x / pixels.y);
  return *camera.distance < kClose * whole.distance;
}

ToleranceValue Model::tolerance() const {
  return scene_.mesh.tolerance.value_or(ToleranceValue{0.5, true});
}

bool Model::keeps_up() const {
  return full_ms_ > 0 && full_ms_ <= kKeepsUpMs;
}

/// A formula that is wrong is for the worker to find; a number that is, is found here.
void Model::request_meshes(Manner manner) {
  refine_at_.reset();
  try {
    scene_ = resolve(scene_);
  } catch (...) {
    error_ = caught_error();
    faulty_.reset();
    return;
  }
  // Seen from elsewhere, but not closely, meshes stay as they are.
  const Camera& camera = scene_.camera;
  if (!meshed_camera_ || sees_another_size(camera, *meshed_camera_) || is_close(camera)) {
    meshed_camera_ = camera;
  }
  if (!is_meshing()) requested_ = Clock::now();
  Scene asked = with_strokes(scene_);
  asked.camera = *meshed_camera_;
  worker_.request(std::move(asked), manner);
}

bool Model::take_result() {
  auto result = worker_.take();
  if (!result) return false;
  requested_ = Clock::now();  // others may be in the making already
  error_ = result->error;
  faulty_.reset();
  if (error_ && result->faulty_surface < result->scene.surfaces.size()) {
    faulty_ = {result->faulty_surface, result->scene.surfaces[result->faulty_surface].name};
  }
  if (!error_) show(std::move(*result));
  return true;
}

void Model::show(Meshed meshed) {
  if (!meshed.preview) full_ms_ = meshed.milliseconds;
  good_ = std::move(meshed);
  bounds_ = bounds_of(good_);
  seen_.reset();
  const auto is_moving = [](const auto& surface) { return surface->moves; };
  moves_ = std::ranges::any_of(good_.surfaces, is_moving) || has_moving_numbers(good_.scene);
  if (!moves_) view_.playing = false;
  follow_picked();
}

/// A picked point is one of the surface that is shown, or none.
void Model::follow_picked() {
  if (!picked_) return;
  try {
    picked_ = pick_again(good_, *picked_);
  } catch (const Error& error) {
    picked_.reset();
    news_ = error.what();
  }
}

dvec3 Model::under(const dvec2& pixel) const {
  const Grip now = grip();
  const Ray ray = ray_through(now, pixel);
  const auto sight = look_along(good_, ray);
  return sight ? ray.origin + sight->hit.distance * ray.direction
               : point_on_target_plane(now, pixel);
}

void Model::pick(const dvec2& pixel) {
  const Ray ray = ray_through(grip(), pixel);
  picked_ = saddle::pick(good_, ray);
  const auto sight = look_along(good_, ray);
  if (picked_ || !sight) return;
  // A tube has no u and v, and the s of its mesh's corners has few digits.
  const SurfaceSpec& tube = good_.scene.surfaces[sight->instance.surface];
  const dvec3 p = ray.origin + sight->hit.distance * ray.direction;
  news_ = tube.name + formatted(": s %.3g  x %.3g  y %.3g  z %.3g", sight->hit.uv.x, p.x, p.y, p.z);
}

/// Nearer than the point by more than a mesh is off.
bool Model::is_picked_hidden() const {
  constexpr double kNearer = 1e-3;
  if (!picked_) return false;
  const Grip now = grip();
  const auto pixel = pixel_of(now.fitted, picked_->world, now.size);
  if (!pixel) return true;
  const Ray ray = ray_through(now, *pixel);
  const auto sight = look_along(good_, ray);
  const double distance = glm::dot(picked_->world - ray.origin, ray.direction);
  return sight && sight->hit.distance < distance - kNearer * surface_size();
}

Scene Model::scene_to_save() const {
  Scene scene = scene_;
  if (!view_.grid) {
    for (SurfaceSpec& spec : scene.surfaces) spec.grid = GridSize{0, 0};
  }
  return scene;
}

}  // namespace saddle
