#include "view/mesh_worker.h"

#include <chrono>
#include <utility>

#include "base/parallel.h"
#include "meshing/solids.h"

namespace saddle {
namespace {

/// A preview that takes longer is not worth waiting for while the user types on.
constexpr std::chrono::milliseconds kPatience{150};

/// Cells of a preview each way: a few thousand triangles, which take some milliseconds.
constexpr GridSize kPreview{60, 60};

Meshed mesh_all(const Tessellate& tessellate, const Scene& scene, Detail detail) {
  Meshed result;
  result.scene = scene;
  result.preview = detail == Detail::Preview;
  const auto begin = std::chrono::steady_clock::now();
  try {
    std::vector<Tessellation> made;
    for (std::size_t& k = result.faulty_surface; k < scene.surfaces.size(); ++k) {
      made.push_back(tessellate(scene, k, detail));
    }
    result.faulty_surface = 0;
    std::vector<Tessellation*> meshes;
    for (Tessellation& surface : made) meshes.push_back(&surface);
    thicken_scene(scene, meshes, false, 0);
    for (Tessellation& surface : made) {
      result.surfaces.push_back(std::make_shared<const Tessellation>(std::move(surface)));
    }
  } catch (const Abandoned&) {
    throw;
  } catch (...) {
    result.error = caught_error();
  }
  if (result.error) result.surfaces.clear();
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
  result.milliseconds = passed.count();
  return result;
}

}  // namespace

Tessellate tessellate_for_picture(unsigned threads) {
  return [threads](const Scene& scene, std::size_t surface, Detail detail) {
    Scene asked = scene;
    if (detail == Detail::Preview && !asked.mesh.samples) asked.mesh.samples = kPreview;
    return tessellate(asked, asked.surfaces[surface], {.picture = true}, threads);
  };
}

MeshWorker::MeshWorker(Tessellate tessellate, std::function<void()> wake)
    : tessellate_(std::move(tessellate)),
      wake_(std::move(wake)),
      thread_([this](const std::stop_token& end) { run(end); }) {}

void MeshWorker::request(Scene scene, Manner manner) {
  {
    const std::lock_guard lock(mutex_);
    next_ = {std::move(scene), manner};
    const bool has_only_just_begun = previewing_ && Clock::now() - begun_ < kPatience;
    if (working_ && manner != Manner::InTurn && !has_only_just_begun) current_.request_stop();
  }
  changed_.notify_one();
}

std::optional<Meshed> MeshWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(result_, std::nullopt);
}

bool MeshWorker::is_busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || next_;
}

void MeshWorker::run(const std::stop_token& end) {
  const std::stop_callback stop_work(end, [this] {
    const std::lock_guard lock(mutex_);
    current_.request_stop();
  });
  while (true) {
    std::unique_lock lock(mutex_);
    working_ = false;
    if (!changed_.wait(lock, end, [this] { return next_.has_value(); })) return;
    const Request request = *std::exchange(next_, std::nullopt);
    working_ = true;
    previewing_ = request.manner == Manner::PreviewFirst;
    begun_ = Clock::now();
    current_ = std::stop_source();
    if (end.stop_requested()) return;
    const Abandonable abandonable(current_.get_token());
    lock.unlock();
    try {
      work(request);
    } catch (const Abandoned&) {
      // The newer request is waiting.
    }
  }
}

void MeshWorker::work(const Request& request) {
  if (request.manner == Manner::PreviewFirst) {
    Meshed preview = mesh_all(tessellate_, request.scene, Detail::Preview);
    // An error may be that of the coarse mesh; the other one will tell.
    if (!preview.error) deliver(std::move(preview));
    const std::lock_guard lock(mutex_);
    if (next_) return;
    previewing_ = false;
  }
  deliver(mesh_all(tessellate_, request.scene, Detail::Full));
}

void MeshWorker::deliver(Meshed result) {
  {
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
  }
  wake_();
}

}  // namespace saddle
