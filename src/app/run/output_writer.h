// Writes the meshes, pictures, films and scene files of a run: pictures beside the drawing of the
// next one, films when all of them are whole.
#pragma once

#include <future>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/report/clock.h"
#include "app/run/outputs.h"
#include "app/run/shots.h"
#include "base/file.h"
#include "base/image.h"
#include "base/parallel.h"
#include "export/formats/losses.h"
#include "export/pictures/video.h"
#include "mesh/model/mesh.h"
#include "scene/model/scene.h"
#include "scene/options/run_settings.h"

namespace saddle {

/// One piece of work at a time on a thread of its own, in order.
class WorkBehind {
 public:
  /// Does `work` once the last is done. Throws what that has thrown.
  template <typename Work>
  void start(Work work) {
    wait();
    last_ = run_beside([work = std::move(work)] {
      const auto begin = Clock::now();
      work();
      return milliseconds_since(begin);
    });
  }
  void wait() {
    if (last_.valid()) milliseconds_ += last_.get();
  }

  /// The time of all work that was waited for.
  double milliseconds() const { return milliseconds_; }

 private:
  std::future<double> last_;
  double milliseconds_ = 0;
};

/// A picture's and a mesh's scene is the one that was written, not what an animation's framing has
/// made of it.
class OutputWriter {
 public:
  /// `outputs` stay where they are. With --strict no file gets its name before finish(). Throws
  /// Error (Machine) for a film without ffmpeg.
  OutputWriter(std::span<const Output> outputs, const Scene& scene, const RunSettings& run);

  /// Looks at the meshes of this moment and their files. Returns whether a file lacks something.
  /// Throws Error (Nothing) if a format has room for nothing of the scene.
  bool take_meshes(const Shot& shot, const Scene& scene, std::span<const Mesh> meshes);

  /// Into the files of meshes that show the moment of take_meshes(), whose arguments are still
  /// there.
  void write_meshes();

  /// Into the pages that show this moment.
  void write_pages_of(const Shot& shot, const PageContent& content);

  /// Into the files and films that show this moment, while the caller goes on. Throws what writing
  /// the picture before has thrown.
  void start_writing(const Shot& shot, const Scene& scene, Image image);

  /// Until the last picture is written. Throws what that has thrown.
  void wait() { behind_.wait(); }

  /// Gives files that were held back their names, writes scene files, then films. After wait().
  void finish(const Scene& scene);

  /// Differences of the films and the files of meshes from what was asked for.
  std::vector<std::string> warnings() const;

  /// The time of writing, without a picture that is still being written.
  double milliseconds() const { return milliseconds_ + behind_.milliseconds(); }

 private:
  struct Film {
    std::string path;
    std::unique_ptr<Video> video;
  };

  /// Meshes on their way to a file.
  struct MeshFile {
    const Output& output;
    int frame;
    MeshContent content;
  };
  /// The first loss of each kind that a file has; another frame's may differ.
  void add_losses(const Output& output, const std::vector<Loss>& losses);

  void write_picture_of(const Shot& shot, const Scene& scene, const Image& image);
  void write_films();
  /// Writes files that belong together, which may be held back.
  void put(const std::vector<FileToWrite>& files);

  std::span<const Output> outputs_;
  unsigned threads_;
  bool holds_back_;
  std::mutex mutex_;              ///< of held_: meshes are written beside pictures
  std::vector<StagedFile> held_;  ///< without their names
  MeshUp mesh_up_;
  std::vector<Shells> shells_;  ///< of the meshes at hand
  std::vector<MeshFile> mesh_files_;
  std::set<std::pair<const Output*, Loss::Kind>> known_losses_;
  std::vector<std::string> warnings_;  ///< of files of meshes, and of pages
  std::vector<Film> films_;
  double milliseconds_ = 0;  ///< of writing that the caller waits for
  WorkBehind behind_;        // the last member: it ends before what it writes to
};

}  // namespace saddle
