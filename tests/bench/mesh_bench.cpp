// The whole mesh of a 1000 x 1000 grid in fresh memory, beside a loop written for the torus alone
// that fills the same arrays. Compare within one run: machines differ.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include "bench_surfaces.h"
#include "mesh/mesher/grid_mesh.h"

namespace saddle {
namespace {

constexpr std::size_t kCells = 1000;
constexpr std::size_t kVertices = (kCells + 1) * (kCells + 1);

void per_vertex(benchmark::State& state) {
  state.counters["per vertex"] = benchmark::Counter(
      static_cast<double>(kVertices),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void mesh_of_grid(benchmark::State& state, const BenchSurface& formula, unsigned threads) {
  const Surface surface = compile_surface(formula);
  GridOptions options;
  options.cells_u = options.cells_v = kCells;
  options.lines_u = options.lines_v = 0;
  options.threads = threads;
  for (auto _ : state) benchmark::DoNotOptimize(mesh_on_grid(surface, options));
  per_vertex(state);
}

/// Positions, normals, parameters, points and triangles of the torus, sines once per column and
/// row, in memory that nobody has touched.
void torus_mesh_by_hand(benchmark::State& state) {
  const std::vector<double> us = steps(0, 2 * kPi, kCells + 1);
  const std::vector<double> vs = steps(0, 2 * kPi, kCells + 1);
  for (auto _ : state) {
    const auto position = std::make_unique_for_overwrite<dvec3[]>(kVertices);
    const auto normal = std::make_unique_for_overwrite<dvec3[]>(kVertices);
    const auto uv = std::make_unique_for_overwrite<dvec2[]>(kVertices);
    const auto point = std::make_unique_for_overwrite<std::uint32_t[]>(kVertices);
    const auto triangles = std::make_unique_for_overwrite<Triangle[]>(2 * kCells * kCells);
    std::vector<double> cos_u(kCells + 1);
    std::vector<double> sin_u(kCells + 1);
    for (std::size_t i = 0; i <= kCells; ++i) {
      cos_u[i] = std::cos(us[i]);
      sin_u[i] = std::sin(us[i]);
    }
    std::uint32_t k = 0;
    Triangle* triangle = triangles.get();
    for (std::size_t j = 0; j <= kCells; ++j) {
      const double cos_v = std::cos(vs[j]);
      const double sin_v = std::sin(vs[j]);
      const double radius = 2 + cos_v;
      for (std::size_t i = 0; i <= kCells; ++i, ++k) {
        position[k] = {radius * cos_u[i], radius * sin_u[i], sin_v};
        normal[k] = {cos_v * cos_u[i], cos_v * sin_u[i], sin_v};
        uv[k] = {us[i], vs[j]};
        point[k] = k;
        if (i == kCells || j == kCells) continue;
        const auto above = static_cast<std::uint32_t>(k + kCells + 1);
        *triangle++ = {k, k + 1, above + 1};
        *triangle++ = {k, above + 1, above};
      }
    }
    benchmark::DoNotOptimize(position.get());
    benchmark::DoNotOptimize(normal.get());
    benchmark::DoNotOptimize(uv.get());
    benchmark::DoNotOptimize(point.get());
    benchmark::DoNotOptimize(triangles.get());
    benchmark::ClobberMemory();
  }
  per_vertex(state);
}

[[maybe_unused]] const bool kRegistered = [] {
  benchmark::RegisterBenchmark("torus/mesh by hand", torus_mesh_by_hand)->UseRealTime();
  for (const BenchSurface& formula : kBenchSurfaces) {
    const std::string name = formula.name;
    for (const unsigned threads : {1U, 2U}) {
      const std::string suffix = threads == 1 ? "/mesh" : "/mesh, 2 threads";
      benchmark::RegisterBenchmark((name + suffix).c_str(), mesh_of_grid, formula, threads)
          ->UseRealTime();
    }
  }
  return true;
}();

}  // namespace
}  // namespace saddle
