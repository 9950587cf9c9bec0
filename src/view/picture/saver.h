// Scenes and pictures into files of the current folder. Meshes are made and files written beside
// the drawing.
#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "base/image.h"
#include "scene/model/scene.h"
#include "view/model/mesh_worker.h"

namespace saddle {

/// "torus.png" of a title and ".png", or the first of "torus-2.png" ... that does not exist.
std::filesystem::path free_file_name(const std::string& title, const std::string& extension);

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

  /// Goes on with what is there: draws a picture whose mesh is made, in the context that is
  /// current. Returns what there is to say about it: that it is saved, or why not.
  std::optional<std::string> pass();

  /// A picture that was asked for is not in its file yet.
  bool is_busy() const { return !waiting_.empty() || writer_.joinable(); }

 private:
  void mesh_next();
  void start_writing(Image image, Scene scene);

  std::function<void()> wake_;
  std::deque<Scene> waiting_;  ///< the first one is being meshed, unless a file is being written
  MeshWorker worker_;
  std::string news_;  ///< of the writer, once it is done
  std::atomic<bool> is_written_ = false;
  std::jthread writer_;
};

}  // namespace saddle
