// Nanoseconds per vertex of a 1001 x 1001 grid, for our tapes, for muparser with central
// differences, and for loops hoisted by hand; and the time from text to tapes. Compare within one
// run: machines differ.
#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

#include "bench_surfaces.h"
#include "by_hand.h"
#include "eval/batch.h"
#include "eval/vectors.h"
#include "muparser_surface.h"

namespace saddle {
namespace {

constexpr std::size_t kSide = 1001;
/// Cells per side of a tile: longer than the mesh's, since nothing but one row is kept.
constexpr std::size_t kTile = 512;

struct Parameters {
  explicit Parameters(const Domain& d) : u(steps(d.u0, d.u1, kSide)), v(steps(d.v0, d.v1, kSide)) {}
  std::vector<double> u, v;
};

void per_vertex(benchmark::State& state, std::size_t vertices = kSide * kSide) {
  state.counters["per vertex"] = benchmark::Counter(
      static_cast<double>(vertices),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Outputs of a tape into warm arrays of doubles.
void run_tape(benchmark::State& state, const Tape& tape, const Domain& domain, unsigned threads) {
  const Parameters at(domain);
  std::vector<std::vector<double>> columns(tape.outputs.size(), std::vector<double>(kSide * kSide));
  std::vector<double*> outputs;
  for (std::vector<double>& column : columns) outputs.push_back(column.data());
  for (auto _ : state) evaluate_grid(tape, at.u, at.v, outputs, threads);
  per_vertex(state);
}

void positions(benchmark::State& state, const BenchSurface& formula, unsigned threads) {
  run_tape(state, compile_positions(formula), formula.domain, threads);
}
void tangents(benchmark::State& state, const BenchSurface& formula, unsigned threads) {
  run_tape(state, compile_surface(formula).tangents, formula.domain, threads);
}
void curvatures(benchmark::State& state, const BenchSurface& formula, unsigned threads) {
  run_tape(state, compile_surface(formula, Order::Second).curvatures, formula.domain, threads);
}

/// Positions and unit normals as floats into warm arrays.
void normals(benchmark::State& state, const BenchSurface& formula, unsigned threads) {
  const Tape tape = compile_with_normals(formula);
  const Parameters at(formula.domain);
  std::vector<float> position(3 * kSide * kSide);
  std::vector<float> normal(3 * kSide * kSide);
  const GridTiling tiling(kSide - 1, kSide - 1, kTile);
  const VectorLoops& loops = vector_loops(cpu_level());
  for (auto _ : state) {
    evaluate_tiles(tape, at.u, at.v, tiling, threads, [&](TileRows& rows) {
      const std::size_t columns = rows.tile().columns;
      while (rows.next()) {
        const std::size_t first = 3 * (rows.row() * kSide + rows.tile().column);
        const auto out = rows.outputs();
        loops.floats(&out[0], &out[kNormalColumn], columns, position.data() + first,
                     normal.data() + first);
      }
    });
    benchmark::ClobberMemory();
  }
  per_vertex(state);
}

constexpr std::size_t kMuparserPoints = 20000;

/// Points that lie scattered over the domain.
std::array<std::vector<double>, 2> scattered(const Domain& d) {
  std::array<std::vector<double>, 2> points;
  for (std::size_t i = 0; i < kMuparserPoints; ++i) {
    const auto part = [](std::size_t k) {
      return static_cast<double>(k % kMuparserPoints) / kMuparserPoints;
    };
    points[0].push_back(d.u0 + (d.u1 - d.u0) * part(i));
    points[1].push_back(d.v0 + (d.v1 - d.v0) * part(7 * i));
  }
  return points;
}

void muparser(benchmark::State& state, const BenchSurface& formula) {
  MuparserSurface surface(formula);
  const auto [u, v] = scattered(formula.domain);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kMuparserPoints; ++i) {
      benchmark::DoNotOptimize(surface.position(u[i], v[i]));
      benchmark::DoNotOptimize(surface.normal(u[i], v[i]));
    }
  }
  per_vertex(state, kMuparserPoints);
}

void muparser_bulk(benchmark::State& state, const BenchSurface& formula) {
  constexpr double kStep = MuparserSurface::kStep;
  MuparserBulkSurface surface(formula, kMuparserPoints);
  const auto [u, v] = scattered(formula.domain);
  for (auto _ : state) {
    benchmark::DoNotOptimize(surface.positions(u, v, 0, 0));
    const auto right = surface.positions(u, v, kStep, 0);
    const auto left = surface.positions(u, v, -kStep, 0);
    const auto above = surface.positions(u, v, 0, kStep);
    const auto below = surface.positions(u, v, 0, -kStep);
    for (std::size_t i = 0; i < kMuparserPoints; ++i) {
      dvec3 by_u;
      dvec3 by_v;
      for (int k = 0; k < 3; ++k) {
        const auto c = static_cast<std::size_t>(k);
        by_u[k] = right[c][i] - left[c][i];
        by_v[k] = above[c][i] - below[c][i];
      }
      benchmark::DoNotOptimize(glm::normalize(glm::cross(by_u, by_v)));
    }
  }
  per_vertex(state, kMuparserPoints);
}

void by_hand(benchmark::State& state, const Domain& domain,
             void (*loop)(const std::vector<double>&, const std::vector<double>&, float*)) {
  const Parameters at(domain);
  std::vector<float> out(6 * kSide * kSide);
  for (auto _ : state) {
    loop(at.u, at.v, out.data());
    benchmark::ClobberMemory();
  }
  per_vertex(state);
}

/// Text to tapes of positions, tangents and normals.
void compile_formula(benchmark::State& state, const BenchSurface& formula) {
  for (auto _ : state) benchmark::DoNotOptimize(compile_surface(formula));
}
void compile_muparser(benchmark::State& state, const BenchSurface& formula) {
  for (auto _ : state) {
    MuparserSurface surface(formula);
    benchmark::DoNotOptimize(surface.position(1, 1));  // compiled at the first evaluation
  }
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const BenchSurface& formula : kBenchSurfaces) {
    const auto add = [&formula](const std::string& what, auto function, auto... arguments) {
      const std::string name = std::string(formula.name) + "/" + what;
      benchmark::RegisterBenchmark(name.c_str(), function, arguments...)->UseRealTime();
    };
    for (const unsigned threads : {1U, 2U}) {
      const std::string suffix = threads == 1 ? "" : ", 2 threads";
      add("positions" + suffix, positions, formula, threads);
      add("positions and normals as floats" + suffix, normals, formula, threads);
      add("positions and tangents" + suffix, tangents, formula, threads);
      add("second derivatives and curvatures" + suffix, curvatures, formula, threads);
    }
    add("muparser, central differences", muparser, formula);
    add("muparser bulk, central differences", muparser_bulk, formula);
    add("compile", compile_formula, formula);
    add("compile, muparser", compile_muparser, formula);
  }
  const auto add = [](const char* name, const BenchSurface& formula, auto loop) {
    benchmark::RegisterBenchmark(name, by_hand, formula.domain, loop)->UseRealTime();
  };
  add("torus/by hand, floats", kBenchSurfaces[0], torus_by_hand);
  add("enneper/by hand, floats", kBenchSurfaces[1], enneper_by_hand);
  return true;
}();

}  // namespace
}  // namespace saddle
