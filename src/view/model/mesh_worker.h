// Meshing beside the drawing: only the newest request counts.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "meshing/tessellate.h"
#include "scene/model/scene.h"
#include "view/model/triangle_boxes.h"

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

/// A mesh, and where its triangles are.
struct SightedMesh : Tessellation {
  explicit SightedMesh(Tessellation tessellation)
      : Tessellation(std::move(tessellation)), boxes(mesh) {}

  TriangleBoxes boxes;
};

/// The result of a request.
struct Meshed {
  Scene scene;  ///< as it was requested
  /// One per surface of the scene; none if there is an error.
  std::vector<std::shared_ptr<const SightedMesh>> surfaces;
  std::optional<Error> error;
  std::size_t faulty_surface = 0;  ///< the surface that has the error; past the last: none has
  bool preview = false;            ///< a coarse mesh; the real one follows
  double milliseconds = 0;         ///< of meshing
};

/// Which meshes a request is answered with.
enum class Manner {
  PreviewFirst,  ///< a coarse mesh at once, the real one later; where that is quick, it alone
  Full,          ///< the real one
  InTurn         ///< the real one, once that of the request before is there
};

/// Meshes only those surfaces of a scene that differ from those of the scene before. All calls from
/// one thread, which `wake` tells, from another, that there is something to take.
class MeshWorker {
 public:
  MeshWorker(Tessellate tessellate, std::function<void()> wake);

  /// Abandons the work on an earlier request, unless this one is done in turn, or that work is a
  /// preview that has only just begun: an endless stream of requests must show something too.
  void request(Scene scene, Manner manner);

  /// The newest result, once.
  std::optional<Meshed> take();

  /// A request has no result yet.
  bool is_busy() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Request {
    Scene scene;
    Manner manner = Manner::Full;
  };

  void run(const std::stop_token& end);
  void work(const Request& request);
  Meshed mesh_all(const Scene& scene, Detail detail);
  Meshed mesh_unless(const std::stop_token& unwanted, const Scene& scene, Detail detail);
  std::optional<Meshed> mesh_quickly(const Scene& scene);
  void deliver(Meshed result);

  /// Meshes that keep the tolerance, by what they depend on.
  using Known = std::map<std::string, std::shared_ptr<const SightedMesh>>;

  Tessellate tessellate_;
  Known known_;            ///< of the last scenes, for the worker's thread alone
  bool is_quick_ = false;  ///< the last real meshes were; the same thread's
  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Request> next_;
  std::optional<Meshed> result_;
  bool working_ = false;
  bool previewing_ = false;
  Clock::time_point begun_;
  std::stop_source current_;  // stops what is being done
  std::jthread thread_;       // the last member: it ends before the others go
};

}  // namespace saddle
