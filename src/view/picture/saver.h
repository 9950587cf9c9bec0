// Scenes, pictures and pages into files of the current folder. Meshes are made and files written
// beside the drawing.
#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "scene/model/scene.h"
#include "view/model/mesh_worker.h"

namespace saddle {

/// Writes a scene file: TITLE.toml, or the first of TITLE-2.toml ... that does not exist. Returns
/// its name. Throws Error (Machine) if it cannot be written.
std::filesystem::path save_scene(const Scene& scene);

/// All calls from the thread that draws; `wake` is called from others when pass() has something to
/// do.
class Saver {
 public:
  Saver(Tessellate tessellate, std::function<void()> wake);

  /// The picture that saddle -o would write of this scene, with the window's size, as TITLE.png or
  /// TITLE-2.png ... Throws Error for a scene that is wrong.
  void save_picture(Scene scene);

  /// The page that saddle -o would write, for a picture of the window's size, as TITLE.html or
  /// TITLE-2.html ... Throws Error for a scene that is wrong.
  void save_page(Scene scene);

  /// Goes on with what is there: draws a picture whose mesh is made, in the context that is
  /// current. Returns what there is to say about it: that it is saved, or why not.
  std::optional<std::string> pass();

  /// A picture or page that was asked for is not in its file yet.
  bool is_busy() const { return !waiting_.empty() || writer_.joinable(); }

 private:
  struct Wanted {
    Scene scene;
    bool page = false;  ///< else a picture
  };

  void save(Wanted wanted);
  void mesh_next();
  void start_writing(std::function<std::string()> write);

  std::function<void()> wake_;
  std::deque<Wanted> waiting_;  ///< the first one is being meshed, unless a file is being written
  MeshWorker worker_;
  std::string news_;  ///< of the writer, once it is done
  std::atomic<bool> is_written_ = false;
  std::jthread writer_;
};

}  // namespace saddle
