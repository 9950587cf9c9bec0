// The actions of keys and buttons on a model.
#include <utility>

#include "view/model/controls.h"
#include "view/model/model.h"

namespace saddle {

bool Model::act(Action action) {
  return act_on_looks(action) || act_on_camera(action) || act_on_scene(action);
}

/// Actions that change colours and lines.
bool Model::act_on_looks(Action action) {
  Scene changed = scene_;
  switch (action) {
    case Action::Grid:
      grid = !grid;
      return true;
    case Action::Wireframe:
      wireframe = !wireframe;
      return true;
    case Action::NextLights:
      scene_.lights = lights_.next(scene_.lights);
      return true;
    case Action::ShadeVertices:
    case Action::ShadePixels:
    case Action::ShadeExactly:
      changed.picture.shading = action == Action::ShadeVertices ? Shading::Vertex
                                : action == Action::ShadePixels ? Shading::Pixel
                                                                : Shading::Exact;
      change_look(std::move(changed));
      return true;
    case Action::Axes:
      changed.axes = !changed.axes;
      change_look(std::move(changed));
      return true;
    default:
      return false;
  }
}

bool Model::act_on_camera(Action action) {
  switch (action) {
    case Action::Orthographic: {
      Camera camera = scene_.camera;
      camera.ortho = !camera.ortho;
      look_through(camera);
      return true;
    }
    case Action::Turntable:
      turntable = !turntable;
      return true;
    case Action::AlongX:
    case Action::AlongY:
    case Action::AlongZ:
      look_through(
          seen_along(scene_.camera, static_cast<int>(action) - static_cast<int>(Action::AlongX)));
      return true;
    case Action::Fit:
      scene_.camera = fit_again(scene_.camera);
      frame();
      look_through(scene_.camera);
      return true;
    default:
      return false;
  }
}

/// Actions that change the meshes.
bool Model::act_on_scene(Action action) {
  Scene changed = scene_;
  switch (action) {
    case Action::Flip:
      for (SurfaceSpec& spec : changed.surfaces) spec.flip = !spec.flip;
      edit(std::move(changed), "");
      return true;
    case Action::Play:
      playing = !playing;
      return true;
    case Action::Coarser:
    case Action::Finer:
      changed.mesh.tolerance = tolerance();
      changed.mesh.tolerance->value *= action == Action::Finer ? 0.5 : 2;
      edit(std::move(changed), "tolerance");
      return true;
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

}  // namespace saddle
