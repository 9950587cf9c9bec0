// The viewer's state, without window and OpenGL: the scene that is edited, the meshes that are
// shown, and what keys and hands do to them.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "render/picture/renderer.h"
#include "scene/model/scene.h"
#include "view/model/actions.h"
#include "view/model/controls.h"
#include "view/model/history.h"
#include "view/model/mesh_worker.h"
#include "view/model/meshed_scene.h"
#include "view/model/sliders.h"

namespace saddle {

/// The program's options for the viewer.
struct ViewerSetup {
  Scene scene;
  bool start = false;             ///< begin with the start page
  std::function<Scene()> reload;  ///< the scene anew, from where it came from; empty: from nowhere
  std::filesystem::path file;     ///< that reload() reads; empty: none
  std::filesystem::path watched;  ///< reload when this file changes; empty: do not
  unsigned threads = 0;           ///< of meshing; 0: all
  bool quiet = false;             ///< show no warnings
  bool verbose = false;           ///< say at the end what it took
  std::filesystem::path program = "/proc/self/exe";  ///< writes files beside the window
  Tessellate tessellate = {};  ///< for tests, in place of tessellate_for_picture()
};

/// The object that an error is about: its place among surfaces, then curves, then points.
struct FaultyObject {
  std::size_t place;
  std::string name;
};

class Model {
 public:
  using Clock = std::chrono::steady_clock;

  /// `wake`: called from another thread when a mesh is there.
  Model(ViewerSetup setup, std::function<void()> wake);

  // The scenes and meshes that are shown. `scene` is as it is edited, right or wrong; `drawn_scene`
  // has its looks, and one surface for each of the meshes.
  const Scene& scene() const { return scene_; }
  const ViewState& view() const { return view_; }
  Look look() const { return {.lines = view_.grid, .wireframe = view_.wireframe}; }
  Scene drawn_scene() const;
  const std::vector<std::shared_ptr<const SightedMesh>>& meshes() const { return good_.surfaces; }
  const Meshed& last_good() const { return good_; }
  const std::optional<Error>& error() const { return error_; }
  /// That has the error; nothing: it is about no object, or there is none.
  const std::optional<FaultyObject>& faulty() const { return faulty_; }
  const std::optional<PickedPoint>& picked() const { return picked_; }
  ToleranceValue tolerance() const;  ///< of the mesh
  bool is_meshing() const { return worker_.is_busy(); }
  /// How long a mesh has been in the making, once that is worth telling.
  std::optional<double> meshing_seconds() const;
  /// The picked point is behind a surface.
  bool is_picked_hidden() const;
  /// Something would be elsewhere, or look otherwise, at another t.
  bool moves() const { return moves_; }

  // The picture, in pixels.
  dvec2 size() const;
  void resize(const dvec2& size);
  Grip grip() const;
  const Bounds& bounds() const { return bounds_; }  ///< of what is shown
  /// Length of the diagonal of what is shown.
  double surface_size() const { return bounds_.diagonal(); }

  // Changes, all of which can be undone: undo and redo go to whole states. `what` names the thing
  // that is changed: those of the same thing in a row are one.
  void edit(Scene scene, const std::string& what);
  void change_view(ViewState view, const std::string& what);
  /// A hand moves the camera; end_edit() lets go.
  void look_by_hand(const Camera& camera, const std::string& what);
  void set_time(double t);
  void end_edit();
  void undo();
  void redo();
  /// In place of the scene. `reload` and `file` as in ViewerSetup.
  void open(Scene scene, std::function<Scene()> reload, std::filesystem::path file = {});
  const History& history() const { return history_; }
  /// The scene from where it came from, the camera as it is; its error, if it has one, is kept.
  void reload();

  /// This alone is no change to undo.
  void look_through(const Camera& camera);
  /// Finds and keeps the point of a surface under a pixel; nothing there: forgets the last one.
  void pick(const dvec2& pixel);
  /// The point of a mesh under a pixel, or of the plane through the target.
  dvec3 under(const dvec2& pixel) const;

  /// Does what concerns the scene and what is shown of it; false: it is none of the model's.
  bool act(Action action);
  /// The thing that an action needs is there. Work that was not saved is none of the model's.
  bool has(Needs needs) const;

  /// Takes what the worker has; true if the picture is another.
  bool take_result();
  /// The message for the user since the last call.
  std::optional<std::string> take_news() { return std::exchange(news_, std::nullopt); }
  /// Time goes by: t if it plays, a finer mesh some time after the camera has moved.
  void pass(Clock::time_point now);
  /// When pass() wants to be called next, at the latest.
  std::optional<Clock::time_point> next_pass() const;

  /// The scene as it is to be saved: with the camera and what keys have changed.
  Scene scene_to_save() const;

  /// A parameter goes from end to end, in the view's manner; nothing: none does.
  void play(const std::optional<ParameterPlace>& parameter);
  const std::optional<ParameterPlace>& played() const { return played_; }

 private:
  void frame();
  void move_to(double t);
  void advance_time(double seconds);
  void advance_played(double seconds);
  double advance_phase(double share);
  void request_meshes(Manner manner);
  void record(const std::string& what, bool is_work);
  void restore(std::optional<PastState> step);
  void take_place(Scene scene);
  bool keeps_up() const;
  bool is_close(const Camera& camera) const;
  void show(Meshed meshed);
  void follow_picked();
  bool act_on_looks(Action action);
  bool act_on_camera(Action action);
  bool act_on_scene(Action action);
  bool act_on_objects(Action action);
  bool change_tolerance(double factor);

  Scene scene_;
  ViewState view_;
  std::function<Scene()> reload_;
  std::filesystem::path file_;
  unsigned threads_;
  std::optional<FramedCamera> framed_;  ///< by frame()
  bool is_edited_ = false;              ///< since the last end of an edit
  History history_;
  Meshed good_;  // the last one without an error
  std::optional<Error> error_;
  std::optional<FaultyObject> faulty_;
  std::optional<PickedPoint> picked_;
  std::optional<std::string> news_;
  Bounds bounds_;  ///< of the meshes
  bool moves_ = false;
  std::optional<ParameterPlace> played_;
  double phase_ = 0;  ///< of it, there and back from 0 to 1
  std::optional<Camera> meshed_camera_;
  std::optional<Clock::time_point> refine_at_;
  Clock::time_point requested_;  ///< meshes, or the last ones came, if that is later
  std::optional<Clock::time_point> last_tick_;
  mutable std::optional<ViewPyramid> seen_;  ///< around the meshes, for the last view asked for
  double full_ms_ = 0;                       ///< that the last mesh took that was no preview
  MeshWorker worker_;                        // the last member: it ends first
};

}  // namespace saddle
