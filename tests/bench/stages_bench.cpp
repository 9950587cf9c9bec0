// What each stage of a run costs for a torus, and how it grows: with the tolerance, the size of the
// picture and threads. tests/bench/ratios.py divides all of them by the yardstick.
#include <benchmark/benchmark.h>

#include <cmath>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "base/heap.h"
#include "base/image_png.h"
#include "eval/batch.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "render/gl/context.h"
#include "render/picture/picture.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/gallery.h"
#include "scene/model/prepare.h"

namespace saddle {
namespace {

const Scene& torus() {
  static const Scene kTorus = gallery_scene(*find_gallery_entry("torus"));
  return kTorus;
}

/// A loop of the C library's: what this machine is worth.
void yardstick(benchmark::State& state) {
  std::vector<double> values(100'000);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = 1e-4 * static_cast<double>(k);
  for (auto _ : state) {
    double sum = 0;
    for (const double x : values) sum += std::sin(x) * std::exp(-x);
    benchmark::DoNotOptimize(sum);
  }
}

void prepare(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(prepare_surface(torus(), torus().surfaces[0], Order::Second));
  }
}

void evaluation(benchmark::State& state, unsigned threads) {
  const Surface surface = prepare_surface(torus(), torus().surfaces[0]).surface;
  constexpr std::size_t kSide = 1000;
  std::vector<double> u(kSide);
  for (std::size_t k = 0; k < kSide; ++k) u[k] = 6e-3 * static_cast<double>(k);
  for (auto _ : state) benchmark::DoNotOptimize(evaluate_normals_on_grid(surface, u, u, threads));
}

const Surface& torus_surface() {
  static const Surface kSurface =
      prepare_surface(torus(), torus().surfaces[0], Order::Second).surface;
  return kSurface;
}

MeshRequest within(double share, unsigned threads) {
  MeshRequest options;
  options.tolerance = [share](const Probe& probe) {
    const double length = share * probe.bounds().diagonal();
    return [length](const dvec3&) { return length; };
  };
  options.threads = threads;
  return options;
}

std::optional<MeshResult> mesh_of(double share, unsigned threads) {
  return try_mesh(torus_surface(), within(share, threads));
}

void mesh(benchmark::State& state, double share, unsigned threads) {
  std::optional<MeshResult> result;
  for (auto _ : state) result = mesh_of(share, threads);
  state.counters["triangles"] = static_cast<double>(result->mesh.triangles.size());
}

/// From the mesh to pixels in memory; context and shaders are there.
void draw(benchmark::State& state, int width, int height, int antialias, bool axes) {
  const auto context = make_osmesa_context();
  Renderer renderer;
  const Mesh torus_mesh = mesh_of(1e-3, 0)->mesh;
  renderer.set_mesh(0, torus_mesh);
  Scene scene = torus();
  scene.axes = axes;
  const FittedCamera camera = fit_to_meshes(scene, std::span(&torus_mesh, 1), dvec2(width, height));
  const PictureSettings settings{width, height, antialias};
  draw_image(renderer, scene, camera, settings);  // compiles the shaders
  for (auto _ : state) {
    benchmark::DoNotOptimize(draw_image(renderer, scene, camera, settings));
  }
}

void encode(benchmark::State& state) {
  const Mesh torus_mesh = mesh_of(1e-3, 0)->mesh;
  const Image image = render(torus(), std::span(&torus_mesh, 1), {800, 600, 2}).image;
  for (auto _ : state) {
    std::ostringstream out;
    write_png(out, image);
    benchmark::DoNotOptimize(out);
  }
}

[[maybe_unused]] const bool kRegistered = [] {
  use_huge_pages();  // as the program does
  const auto add = [](const std::string& what, auto function, auto... arguments) {
    benchmark::RegisterBenchmark(("stage/" + what).c_str(), function, arguments...)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
  };
  add("yardstick", yardstick);
  add("prepare", prepare);
  add("evaluate 1000x1000", evaluation, 1U);
  add("evaluate 1000x1000, 2 threads", evaluation, 2U);
  for (const char* const share : {"1e-1", "1e-2", "1e-3", "1e-4", "1e-5", "1e-6"}) {
    add(std::string("mesh ") + share, mesh, std::stod(share), 1U);
  }
  add("mesh 1e-4, 2 threads", mesh, 1e-4, 2U);
  add("draw 400x300", draw, 400, 300, 2, false);
  add("draw 800x600", draw, 800, 600, 2, false);
  add("draw 800x600, antialias 1", draw, 800, 600, 1, false);
  add("draw 800x600, antialias 4", draw, 800, 600, 4, false);
  add("draw 1600x1200", draw, 1600, 1200, 2, false);
  add("draw 3840x2160", draw, 3840, 2160, 2, false);
  add("draw 800x600, axes and text", draw, 800, 600, 2, true);
  add("encode 800x600", encode);
  return true;
}();

}  // namespace
}  // namespace saddle
