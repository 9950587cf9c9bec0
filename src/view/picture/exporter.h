// Files of any format, written beside the drawing: another process of this program makes each of
// them, so a file is byte for byte the one that the command line writes.
#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/child.h"
#include "scene/model/scene.h"

namespace saddle {

/// A file to write.
struct Export {
  std::filesystem::path path;
  std::optional<GridSize> size = {};  ///< of the picture; nothing: the scene's
};

/// The meaning of typed text: a file's name, and perhaps a picture's size after a space. Nothing:
/// the name has no extension of a format.
std::optional<Export> typed_export(const std::string& typed);

/// A line of a list of the files that can be written.
struct ExportChoice {
  Export file;
  std::string name;             ///< as it would be typed
  std::string detail;           ///< what the format is for
  bool needs_movement = false;  ///< something has to depend on t
};

/// The files that typed text leads to: `title` with each of the extensions, or those that begin as
/// it does.
std::vector<ExportChoice> export_choices(const std::string& title, const std::string& typed);

/// All calls from one thread; `wake` is called from another when pass() has something to say.
class Exporter {
 public:
  /// `program`: this one.
  Exporter(std::filesystem::path program, unsigned threads, std::function<void()> wake);
  /// Ends what is at work.
  ~Exporter();
  Exporter(const Exporter&) = delete;
  Exporter& operator=(const Exporter&) = delete;

  /// Writes a file, after those that were asked for before. One that exists is replaced.
  void write(const Scene& scene, const Export& file);
  /// Writes TITLE.html, of a title and ".html", or the first of TITLE-2.html ... that does not
  /// exist when those before are written.
  void write_new(const Scene& scene, const std::string& extension);

  /// Goes on with the next file. Returns what became of the last one.
  std::optional<std::string> pass();
  bool is_busy() const { return !waiting_.empty(); }

 private:
  struct Job {
    std::string scene;
    std::function<Export()> file;  ///< asked when its turn has come
  };

  void add(Job job);
  std::vector<std::string> command_for(const Export& file) const;
  void begin_next();
  void run(const std::string& scene, const std::filesystem::path& path);

  std::filesystem::path program_;
  unsigned threads_;
  std::function<void()> wake_;
  std::deque<Job> waiting_;  ///< the first one is at work
  std::unique_ptr<Child> child_;
  std::string news_;  ///< of the first one, once it is done
  std::atomic<bool> is_done_ = false;
  std::jthread worker_;
};

}  // namespace saddle
