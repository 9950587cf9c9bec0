// The solid of a mesh of a million vertices, beside the PLY of the same mesh: compare within one
// run. The solid has twice the mesh's corners and triangles.
#include <benchmark/benchmark.h>

#include <ostream>
#include <streambuf>

#include "bench_surfaces.h"
#include "export/meshes/placed_meshes.h"
#include "export/meshes/ply.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/solid/solid_facts.h"
#include "mesh/solid/thicken.h"

namespace saddle {
namespace {

constexpr std::size_t kSolidCells = 1000;
constexpr Thickening kThin = {0.005, 0.005};

/// Takes bytes and forgets them.
class Nowhere : public std::streambuf {
 protected:
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

Mesh million(const BenchSurface& formula) {
  GridOptions options;
  options.cells_u = options.cells_v = kSolidCells;
  options.lines_u = options.lines_v = 0;
  options.threads = 1;
  return mesh_on_grid(compile_surface(formula), options).mesh;
}

void ply_of_million(benchmark::State& state, const BenchSurface& formula) {
  const Mesh mesh = million(formula);
  const SurfaceSpec spec;
  ExportedMesh exported;
  exported.mesh = &mesh;
  exported.spec = &spec;
  Nowhere nowhere;
  std::ostream out(&nowhere);
  for (auto _ : state) write_ply(out, {&exported, 1});
}

void solid_of_million(benchmark::State& state, const BenchSurface& formula) {
  const Mesh mesh = million(formula);
  for (auto _ : state) benchmark::DoNotOptimize(thicken(mesh, kThin));
}

void facts_of_million(benchmark::State& state, const BenchSurface& formula) {
  const Mesh solid = thicken(million(formula), kThin);
  for (auto _ : state) benchmark::DoNotOptimize(solid_facts(solid, 1));
}

[[maybe_unused]] const bool kSolidsRegistered = [] {
  for (const BenchSurface& formula : kBenchSurfaces) {
    const std::string name = formula.name;
    benchmark::RegisterBenchmark((name + "/PLY").c_str(), ply_of_million, formula);
    benchmark::RegisterBenchmark((name + "/solid").c_str(), solid_of_million, formula);
    benchmark::RegisterBenchmark((name + "/solid's facts").c_str(), facts_of_million, formula);
  }
  return true;
}();

}  // namespace
}  // namespace saddle
