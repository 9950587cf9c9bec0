// Milliseconds to mesh the gallery's surfaces within half a pixel of 800 x 600, one thread, and how
// many triangles that takes beside the least possible.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mesh/model/mesh_report.h"
#include "meshing/tessellate.h"
#include "scene/model/gallery.h"

namespace saddle {
namespace {

Tessellation mesh_for_picture(const Scene& scene) {
  return tessellate(scene, scene.surfaces.front(), {.picture = true}, 1);
}

void mesh_entry(benchmark::State& state, const GalleryEntry& entry) {
  const Scene scene = gallery_scene(entry);
  MeshReport report;
  double triangles = 0;
  for (auto _ : state) {
    Tessellation result = mesh_for_picture(scene);
    state.SetIterationTime(result.tessellate_ms / 1000);
    report = std::move(result.report);
    triangles = static_cast<double>(result.mesh.triangles.size());
  }
  state.counters["triangles"] = triangles;
  if (report.least_triangles > 0) state.counters["efficiency"] = triangles / report.least_triangles;
  state.counters["error"] = report.max_error / *report.tolerance;
  state.counters["degrees"] = report.max_normal_error;
}

/// The time of the median surface; the label and a counter tell the worst one. Each is the best of
/// a few: what other programs do to a run is no part of it.
void whole_gallery(benchmark::State& state) {
  constexpr int kRuns = 3;
  struct Time {
    double seconds;
    std::string name;
  };
  std::vector<Time> times;
  for (auto _ : state) {
    times.clear();
    for (const GalleryEntry& entry : gallery()) {
      const Scene scene = gallery_scene(entry);
      double best = mesh_for_picture(scene).tessellate_ms;
      for (int run = 1; run < kRuns; ++run) {
        best = std::min(best, mesh_for_picture(scene).tessellate_ms);
      }
      times.push_back({best / 1000, std::string(entry.name)});
    }
    std::ranges::sort(times, {}, &Time::seconds);
    state.SetIterationTime(times[times.size() / 2].seconds);
  }
  state.SetLabel("median " + times[times.size() / 2].name + ", worst " + times.back().name);
  state.counters["worst, ms"] = 1000 * times.back().seconds;
}

[[maybe_unused]] const bool kRegistered = [] {
  benchmark::RegisterBenchmark("gallery/mesh, median", whole_gallery)
      ->UseManualTime()
      ->Iterations(3)
      ->Unit(benchmark::kMillisecond);
  for (const GalleryEntry& entry : gallery()) {
    const std::string name = "gallery/mesh/" + std::string(entry.name);
    benchmark::RegisterBenchmark(name.c_str(), mesh_entry, entry)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace saddle
