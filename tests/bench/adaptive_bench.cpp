// Milliseconds to mesh the gallery's surfaces within half a pixel of 800 x 600, one thread, and how
// many triangles that takes beside the least possible.
#include <benchmark/benchmark.h>

#include <string>

#include "app/tolerance.h"
#include "mesh/adaptive_mesh.h"
#include "scene/gallery.h"
#include "scene/prepare.h"

namespace saddle {
namespace {

void mesh_entry(benchmark::State& state, const GalleryEntry& entry) {
  const Scene scene = gallery_scene(entry);
  const Surface surface = prepare_surface(scene, scene.surfaces.front(), Order::Second).surface;
  AdaptiveOptions options;
  options.tolerance = [&](const Probe& probe) {
    return tolerance_of(scene, scene.surfaces.front(), {.picture = true}, probe);
  };
  options.normal_tolerance = scene.mesh.normal_tolerance;
  options.threads = 1;
  std::optional<GridMesh> mesh;
  for (auto _ : state) mesh = mesh_within_tolerance(surface, options);
  if (!mesh) {
    state.SkipWithError("not defined everywhere: a uniform grid is used");
    return;
  }
  const MeshReport& report = mesh->report;
  const auto triangles = static_cast<double>(mesh->mesh.triangles.size());
  state.counters["triangles"] = triangles;
  state.counters["efficiency"] = triangles / report.least_triangles;
  state.counters["error"] = report.max_error / *report.tolerance;
  state.counters["degrees"] = report.max_normal_error;
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const GalleryEntry& entry : gallery()) {
    const std::string name = "gallery/mesh/" + std::string(entry.name);
    benchmark::RegisterBenchmark(name.c_str(), mesh_entry, entry)->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace saddle
