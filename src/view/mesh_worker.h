// Meshing beside the drawing: the newest wish is the only one that counts.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "base/error.h"
#include "meshing/tessellate.h"
#include "scene/scene.h"

namespace saddle {

enum class Detail {
  Preview,  ///< some thousand triangles, at once
  Full      ///< within the scene's tolerance
};

/// Tessellates one surface of a scene for a picture of it. Throws Error, and Abandoned where the
/// thread's work is not wanted any more.
using Tessellate = std::function<Tessellation(const Scene& scene, std::size_t surface, Detail)>;

/// tessellate() for a picture; a preview takes a coarse grid, or that of --samples.
Tessellate tessellate_for_picture(unsigned threads);

/// What became of a wish.
struct Meshed {
  Scene scene;  ///< as it was wished for
  /// One per surface of the scene; none if there is an error.
  std::vector<std::shared_ptr<const Tessellation>> surfaces;
  std::optional<Error> error;
  std::size_t guilty = 0;   ///< the surface that has the error
  bool preview = false;     ///< a coarse mesh; the real one follows
  double milliseconds = 0;  ///< of meshing
};

/// How a wish is to be fulfilled.
enum class Manner {
  PreviewFirst,  ///< a coarse mesh at once, the real one later
  Full,          ///< the real one
  InTurn         ///< the real one, when that of the wish before is there
};

/// All calls from one thread, which `wake` tells, from another, that there is something to take.
class MeshWorker {
 public:
  MeshWorker(Tessellate tessellate, std::function<void()> wake);

  /// What is being done for an earlier wish is abandoned, unless this one is to be done in turn, or
  /// that is a preview that has only just begun: an endless stream of wishes must show something
  /// too.
  void wish(Scene scene, Manner manner);

  /// The newest result, once.
  std::optional<Meshed> take();

  /// Something is wished for and not yet there to be taken.
  bool is_busy() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Wish {
    Scene scene;
    Manner manner = Manner::Full;
  };

  void run(const std::stop_token& end);
  void work(const Wish& wish);
  void deliver(Meshed result);

  Tessellate tessellate_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Wish> next_;
  std::optional<Meshed> result_;
  bool working_ = false;
  bool previewing_ = false;
  Clock::time_point begun_;
  std::stop_source current_;  // stops what is being done
  std::jthread thread_;       // the last member: it ends before the others go
};

}  // namespace saddle
