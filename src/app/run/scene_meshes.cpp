#include "app/run/scene_meshes.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/report/run_report.h"
#include "base/activity.h"
#include "base/parallel.h"
#include "meshing/solids.h"
#include "scene/model/prepare.h"

namespace saddle {
namespace {

/// From this many surfaces on, threads have a surface each and end at about the same time. Fewer
/// surfaces have all threads one after the other.
constexpr std::size_t kSurfacesPerThread = 4;

}  // namespace

/// In millimetres of a print, a thickness depends on all surfaces.
std::vector<std::size_t> SceneMeshes::surfaces_to_mesh(const Scene& scene) const {
  std::vector<std::size_t> moved;
  bool depends_on_all = false;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const auto thickness = thickness_of(scene, scene.surfaces[i]);
    const bool is_known = i < known_.size() && !known_[i].moves && known_[i].thickness == thickness;
    if (!is_known) moved.push_back(i);
    depends_on_all |= thickness && thickness->millimetres && scene.mesh.print_size;
  }
  if (moved.empty() || !depends_on_all) return moved;
  moved.resize(scene.surfaces.size());
  std::iota(moved.begin(), moved.end(), std::size_t{0});
  return moved;
}

bool SceneMeshes::warn() const {
  return std::ranges::any_of(known_, [](const Known& known) { return !known.warnings.empty(); });
}

std::vector<std::size_t> SceneMeshes::update(const Scene& scene, const std::string& frame) {
  std::vector<std::size_t> updated = surfaces_to_mesh(scene);
  std::vector<Made> made(updated.size());
  const unsigned threads = threads_ > 0 ? threads_ : available_threads();
  const bool side_by_side = updated.size() >= kSurfacesPerThread * threads;
  Activity meshing("meshing", updated.size());
  parallel_chunks(updated.size(), 1, side_by_side ? threads : 1, [&](std::size_t k, std::size_t) {
    try {
      const SurfaceSpec& spec = scene.surfaces[updated[k]];
      made[k].mesh = tessellate(scene, spec, purpose_, side_by_side ? 1 : threads);
    } catch (...) {
      made[k].failure = std::current_exception();
    }
    meshing.advance();
  });
  std::vector<Tessellation*> meshes(scene.surfaces.size());
  for (std::size_t k = 0; k < updated.size(); ++k) {
    if (made[k].mesh) meshes[updated[k]] = &*made[k].mesh;
  }
  thicken_scene(scene, meshes, true, threads);
  for (std::size_t k = 0; k < updated.size(); ++k) {
    take(scene, updated[k], frame, std::move(made[k]));
  }
  return updated;
}

void SceneMeshes::take(const Scene& scene, std::size_t surface, const std::string& frame,
                       Made result) {
  if (surface == known_.size()) {
    known_.emplace_back();
    known_.back().report.meshes = 0;
    meshes_.emplace_back();
  }
  Known& known = known_[surface];
  known.thickness = thickness_of(scene, scene.surfaces[surface]);
  std::vector<std::string> warnings;
  std::vector<Finding> findings = std::move(known.report.findings);
  const int meshes = known.report.meshes + 1;
  try {
    if (result.failure) std::rethrow_exception(result.failure);
    Tessellation& made = *result.mesh;
    add_times(made, times_);
    warnings = std::move(made.warnings);
    known.report = report_of(scene.surfaces[surface].name, made);
    meshes_[surface] = std::move(made.mesh);
    known.moves = made.moves;
    known.drawn = true;
  } catch (const Error& error) {
    const bool may_vanish = !frame.empty() && bind_surface(scene, scene.surfaces[surface]).moves;
    if (error.status() != Status::Nothing || !may_vanish) throw;
    if (!nothing_) nothing_ = error;
    meshes_[surface] = {};
    known.report.name = scene.surfaces[surface].name;
    known.report.findings = {{Finding::Kind::Nothing, error.what(), true}};
    warnings = warnings_of(known.report.name, known.report.findings);
    known.moves = true;
  }
  known.report.meshes = meshes;
  const bool is_first = !warnings.empty() && known.frames++ == 0;
  // Findings are those of the first frame that warns; of the first frame if none does.
  if (!is_first && meshes > 1) known.report.findings = std::move(findings);
  if (!is_first) return;
  known.warnings = std::move(warnings);
  known.first = frame;
}

void SceneMeshes::report(RunReport& report) const {
  if (nothing_ && std::ranges::none_of(known_, &Known::drawn)) throw *nothing_;
  report.times.parse = times_.parse;
  report.times.compile = times_.compile;
  report.times.tessellate = times_.tessellate;
  for (const Known& known : known_) {
    report.surfaces.push_back(known.report);
    for (std::string warning : known.warnings) {
      if (known.moves && !known.first.empty()) {
        warning += " (" + known.first;
        if (known.frames > 1) warning += ", and in " + std::to_string(known.frames - 1) + " more";
        warning += ")";
      }
      report.warnings.push_back(std::move(warning));
    }
  }
}

}  // namespace saddle
