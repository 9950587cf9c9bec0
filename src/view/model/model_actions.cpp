// The actions of keys and menus on a model.
#include <utility>

#include "view/model/controls.h"
#include "view/model/model.h"
#include "view/model/objects.h"

namespace saddle {
namespace {

Shading shading_of(Action action) {
  if (action == Action::ShadeVertices) return Shading::Vertex;
  return action == Action::ShadePixels ? Shading::Pixel : Shading::Exact;
}

/// The finest tolerance that a key gives: a sixteenth of a pixel is no more than eight bits show.
constexpr double kFinestPixels = 1.0 / 16;
/// The coarsest one, in pixels and as a share of the surface's size: in a picture of usual size an
/// eighth of it. Beyond that the mesh is bounded by its normals.
constexpr double kCoarsestPixels = 64;
constexpr double kCoarsestShare = 1.0 / 8;

}  // namespace

bool Model::act(Action action) {
  return act_on_looks(action) || act_on_camera(action) || act_on_scene(action) ||
         act_on_objects(action);
}

/// Actions that change colours and lines.
bool Model::act_on_looks(Action action) {
  Scene scene = scene_;
  ViewState view = view_;
  switch (action) {
    case Action::Grid:
      view.grid = !view.grid;
      change_view(view, "");
      return true;
    case Action::Wireframe:
      view.wireframe = !view.wireframe;
      change_view(view, "");
      return true;
    case Action::Normals:
      view.normals = !view.normals;
      change_view(view, "");
      return true;
    case Action::Turntable:
      view.turntable = !view.turntable;
      change_view(view, "");
      return true;
    case Action::Panel:
      record("panel", false);
      view_.panel = !view_.panel;
      return true;
    case Action::NextLights:
      scene.lights = view.lights.next(scene.lights);
      edit(std::move(scene), "");
      view_ = view;
      return true;
    case Action::ShadeVertices:
    case Action::ShadePixels:
    case Action::ShadeExactly:
      scene.picture.shading = shading_of(action);
      edit(std::move(scene), "");
      return true;
    case Action::Axes:
      scene.axes = !scene.axes;
      edit(std::move(scene), "");
      return true;
    default:
      return false;
  }
}

bool Model::act_on_camera(Action action) {
  Camera camera = scene_.camera;
  switch (action) {
    case Action::Orthographic:
      camera.ortho = !camera.ortho;
      look_by_hand(camera, "");
      return true;
    case Action::AlongX:
    case Action::AlongY:
    case Action::AlongZ:
      look_by_hand(seen_along(camera, static_cast<int>(action) - static_cast<int>(Action::AlongX)),
                   "");
      return true;
    case Action::Fit:
      record("", false);
      scene_.camera = fit_again(camera);
      frame();
      look_through(scene_.camera);
      return true;
    default:
      return false;
  }
}

/// Actions that change the meshes.
bool Model::act_on_scene(Action action) {
  Scene scene = scene_;
  switch (action) {
    case Action::Flip:
      for (SurfaceSpec& spec : scene.surfaces) spec.flip = !spec.flip;
      edit(std::move(scene), "");
      return true;
    case Action::Play:
      record("play", false);
      view_.playing = !view_.playing && !played_ && moves_;
      played_.reset();
      return true;
    case Action::Coarser:
    case Action::Finer:
      return change_tolerance(action == Action::Finer ? 0.5 : 2);
    case Action::Undo:
      undo();
      return true;
    case Action::Redo:
      redo();
      return true;
    case Action::Reload:
      reload();
      return true;
    default:
      return false;
  }
}

bool Model::change_tolerance(double factor) {
  Scene scene = scene_;
  scene.mesh.tolerance = tolerance();
  ToleranceValue& wanted = *scene.mesh.tolerance;
  if (factor < 1 && wanted.pixels && wanted.value <= kFinestPixels) {
    news_ = "a finer mesh would look the same; the field 'tolerance' takes any number";
    return true;
  }
  if (factor > 1 && wanted.value >= (wanted.pixels ? kCoarsestPixels : kCoarsestShare)) {
    news_ =
        "a coarser mesh would not look like the surface; the field 'tolerance' takes any number";
    return true;
  }
  wanted.value *= factor;
  edit(std::move(scene), "tolerance");
  return true;
}

bool Model::act_on_objects(Action action) {
  Scene scene = scene_;
  switch (action) {
    case Action::New:
      open(new_scene(), {});
      return true;
    case Action::AddSurface:
      add_surface(scene);
      break;
    case Action::AddCurve:
      add_curve(scene);
      break;
    case Action::AddPoint:
      add_point(scene);
      break;
    case Action::AddLight:
      scene.lights.emplace_back();
      break;
    default:
      return false;
  }
  edit(std::move(scene), "");
  end_edit();
  return true;
}

}  // namespace saddle
