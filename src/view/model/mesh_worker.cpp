#include "view/model/mesh_worker.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "meshing/solids.h"
#include "scene/model/prepare.h"
#include "view/model/mesh_key.h"

namespace saddle {
namespace {

/// A preview that takes longer is not worth waiting for while the user types on.
constexpr std::chrono::milliseconds kPatience{150};

/// Meshes that take no longer have no preview: that takes as long as they do.
constexpr std::chrono::milliseconds kQuick{100};

/// Asks to stop when its time has come, unless it has ended before.
class Alarm {
 public:
  Alarm(std::stop_source what, std::chrono::milliseconds after)
      : thread_([what = std::move(what), after](const std::stop_token& end) mutable {
          std::mutex mutex;
          std::unique_lock lock(mutex);
          std::condition_variable_any().wait_for(lock, end, after, [] { return false; });
          if (!end.stop_requested()) what.request_stop();
        }) {}

 private:
  std::jthread thread_;
};

/// Cells of a preview each way: a few thousand triangles, which take some milliseconds.
constexpr GridSize kPreview{60, 60};

/// Definitions that a surface does not use may be wrong, too. Throws Error (Input).
void check_formulas(const Scene& scene, const SurfaceSpec& spec) {
  if (!spec.is_stroke()) bind_surface(scene, spec);
}

/// Puts solids in place of the meshes of surfaces with a thickness: of all surfaces together, as
/// millimetres of a print depend on its size. Throws Error (Input).
void make_solids(Meshed& meshed) {
  const Scene& scene = meshed.scene;
  const auto is_thick = [&](const SurfaceSpec& spec) {
    return thickness_of(scene, spec).has_value();
  };
  if (std::ranges::none_of(scene.surfaces, is_thick)) return;
  std::vector<Tessellation> sheets;
  for (const auto& sheet : meshed.surfaces) sheets.push_back(*sheet);
  std::vector<Tessellation*> made(sheets.size());
  std::ranges::transform(sheets, made.begin(), [](Tessellation& sheet) { return &sheet; });
  thicken_scene(scene, made, false, 0);
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    if (is_thick(scene.surfaces[k]))
      meshed.surfaces[k] = std::make_shared<const SightedMesh>(std::move(sheets[k]));
  }
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
    lock.unlock();
    try {
      work(request);
    } catch (const Abandoned&) {
      // The newer request is waiting.
    } catch (...) {
      Meshed failed;
      failed.error = caught_error();
      deliver(std::move(failed));
    }
  }
}

/// Coarse meshes stand in for those that are not known yet.
Meshed MeshWorker::mesh_all(const Scene& scene, Detail detail) {
  Meshed result;
  result.scene = scene;
  const auto begin = Clock::now();
  Known wanted;
  try {
    for (std::size_t& k = result.faulty_surface; k < scene.surfaces.size(); ++k) {
      const std::string key = mesh_key(scene, scene.surfaces[k]);
      auto known = known_.find(key);
      if (known != known_.end()) {
        check_formulas(scene, scene.surfaces[k]);
      } else {
        auto made = std::make_shared<const SightedMesh>(tessellate_(scene, k, detail));
        result.preview = detail == Detail::Preview;
        if (result.preview) {
          result.surfaces.push_back(std::move(made));
          continue;
        }
        known = known_.emplace(key, std::move(made)).first;
      }
      wanted.insert(*known);
      result.surfaces.push_back(known->second);
    }
    make_solids(result);
  } catch (const Abandoned&) {
    throw;
  } catch (...) {
    result.error = caught_error();
  }
  if (result.error) {
    result.surfaces.clear();
  } else if (!result.preview) {
    known_ = std::move(wanted);
  }
  const std::chrono::duration<double, std::milli> passed = Clock::now() - begin;
  result.milliseconds = passed.count();
  return result;
}

Meshed MeshWorker::mesh_unless(const std::stop_token& unwanted, const Scene& scene, Detail detail) {
  const Abandonable abandonable(unwanted);
  return mesh_all(scene, detail);
}

/// The real meshes; nothing if they take too long.
std::optional<Meshed> MeshWorker::mesh_quickly(const Scene& scene) {
  if (!std::exchange(is_quick_, false)) return std::nullopt;
  std::stop_source late;
  const std::stop_callback newer(current_.get_token(), [late]() mutable { late.request_stop(); });
  const Alarm alarm(late, kQuick);
  try {
    Meshed all = mesh_unless(late.get_token(), scene, Detail::Full);
    is_quick_ = true;
    return all;
  } catch (const Abandoned&) {
    if (current_.stop_requested()) throw;
    return std::nullopt;
  }
}

void MeshWorker::work(const Request& request) {
  const std::stop_token newer = current_.get_token();
  if (request.manner == Manner::PreviewFirst) {
    if (auto all = mesh_quickly(request.scene)) return deliver(*std::move(all));
    Meshed preview = mesh_unless(newer, request.scene, Detail::Preview);
    const bool is_whole = !preview.preview && !preview.error;
    // An error may be that of the coarse mesh; the other one will tell.
    if (!preview.error) deliver(std::move(preview));
    if (is_whole) return;
    const std::lock_guard lock(mutex_);
    if (next_) return;
    previewing_ = false;
  }
  Meshed all = mesh_unless(newer, request.scene, Detail::Full);
  is_quick_ = all.milliseconds < static_cast<double>(kQuick.count());
  deliver(std::move(all));
}

void MeshWorker::deliver(Meshed result) {
  {
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
  }
  wake_();
}

}  // namespace saddle
