// The gallery: how many operations derivatives cost, how long formulas take to compile, and the
// nanoseconds per vertex of its median surface.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "bench_surfaces.h"
#include "eval/batch.h"
#include "formula/operations.h"
#include "scene/model/gallery.h"
#include "scene/model/prepare.h"
#include "scene/model/surface_scope.h"

namespace saddle {
namespace {

constexpr std::size_t kSide = 301;

/// x, y, z of a gallery surface, in `graph`.
std::array<NodeId, 3> coordinates(Graph& graph, const GalleryEntry& entry) {
  const Scene scene = gallery_scene(entry);
  const SurfaceSpec& spec = scene.surfaces.front();
  Scope scope(graph, surface_definitions(scene, spec), surface_view(scene, spec));
  const std::vector<NodeId> r =
      scope.bind(std::array{scope.node("x"), scope.node("y"), scope.node("z")}, scene.t);
  return {r[0], r[1], r[2]};
}

bool is_transcendental(Op op) {
  return row_of(op).kind != Kind::Arithmetic;
}

struct Operations {
  double all = 0;
  double transcendental = 0;
};

Operations count(const Tape& tape) {
  Operations operations;
  for (const auto& part : {tape.of_u, tape.of_v, tape.of_both}) {
    for (const Instruction& instruction : part) {
      operations.all += 1;
      operations.transcendental += is_transcendental(instruction.op) ? 1 : 0;
    }
  }
  return operations;
}

/// Times text to tapes, and counts the operations of x, y, z, and of them with tangents and with
/// normals.
void compile_entry(benchmark::State& state, const GalleryEntry& entry) {
  const Scene scene = gallery_scene(entry);
  Surface surface;
  for (auto _ : state) surface = prepare_surface(scene, scene.surfaces.front()).surface;
  Graph graph;
  const Operations value = count(compile(graph, coordinates(graph, entry)));
  const Operations tangents = count(surface.tangents);
  state.counters["value"] = value.all;
  state.counters["tangents"] = tangents.all / value.all;
  state.counters["normals"] = count(surface.normals).all / value.all;
  state.counters["calls"] = value.transcendental;
  state.counters["more calls"] = tangents.transcendental - value.transcendental;
}

/// The median surface's time for positions and normals; one iteration goes through the gallery.
void gallery_median(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  std::vector<Surface> surfaces;
  for (const GalleryEntry& entry : gallery()) {
    const Scene scene = gallery_scene(entry);
    surfaces.push_back(prepare_surface(scene, scene.surfaces.front()).surface);
  }
  for (auto _ : state) {
    std::vector<double> seconds;
    for (const Surface& surface : surfaces) {
      const Domain& d = surface.domain;
      const auto begin = Clock::now();
      benchmark::DoNotOptimize(
          evaluate_normals_on_grid(surface, steps(d.u0, d.u1, kSide), steps(d.v0, d.v1, kSide), 1));
      seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
    state.SetIterationTime(seconds[seconds.size() / 2]);
  }
  state.counters["per vertex"] = benchmark::Counter(
      kSide * kSide, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

[[maybe_unused]] const bool kRegistered = [] {
  benchmark::RegisterBenchmark("gallery/median, positions and normals", gallery_median)
      ->UseManualTime()
      ->Iterations(9);
  for (const GalleryEntry& entry : gallery()) {
    const std::string name = "gallery/compile/" + std::string(entry.name);
    benchmark::RegisterBenchmark(name.c_str(), compile_entry, entry)->Unit(benchmark::kMicrosecond);
  }
  return true;
}();

}  // namespace
}  // namespace saddle
