// Nanoseconds per vertex of a 1001 x 1001 grid, for our tapes, for muparser with central
// differences, and for loops hoisted by hand. Compare within one run: machines differ.
#include <benchmark/benchmark.h>
#include <muParser.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bench_surfaces.h"
#include "eval/batch.h"

namespace saddle {
namespace {

constexpr std::size_t kSide = 1001;

void per_vertex(benchmark::State& state) {
  state.counters["per vertex"] = benchmark::Counter(
      static_cast<double>(kSide * kSide),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Outputs of a tape into warm arrays.
void run_tape(benchmark::State& state, const Tape& tape, const Domain& domain, unsigned threads) {
  const std::vector<double> u = steps(domain.u0, domain.u1, kSide);
  const std::vector<double> v = steps(domain.v0, domain.v1, kSide);
  std::vector<std::vector<double>> columns(tape.outputs.size(), std::vector<double>(kSide * kSide));
  std::vector<double*> outputs;
  for (std::vector<double>& column : columns) outputs.push_back(column.data());
  for (auto _ : state) evaluate_grid(tape, u, v, outputs, threads);
  per_vertex(state);
}

void positions(benchmark::State& state, const BenchSurface& formula, unsigned threads) {
  const Surface surface = compile_surface(formula);
  Tape tape = surface.normals;
  tape.outputs.resize(3);
  run_tape(state, tape, formula.domain, threads);
}

void tangents(benchmark::State& state, const BenchSurface& formula, unsigned threads) {
  const Surface surface = compile_surface(formula);
  run_tape(state, surface.tangents, formula.domain, threads);
}

/// Positions, and normals from central differences: what a program without derivatives does.
void muparser_differences(benchmark::State& state, const BenchSurface& formula) {
  constexpr double kStep = 1e-5;
  constexpr std::size_t kPoints = 20000;
  std::array<mu::Parser, 3> parsers;
  double u = 0;
  double v = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    parsers[k].DefineVar("u", &u);
    parsers[k].DefineVar("v", &v);
    parsers[k].DefineConst("pi", kPi);
    parsers[k].SetExpr(std::array{formula.x, formula.y, formula.z}[k]);
  }
  const auto at = [&](double a, double b) {
    u = a;
    v = b;
    return dvec3(parsers[0].Eval(), parsers[1].Eval(), parsers[2].Eval());
  };
  const Domain& d = formula.domain;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double a = d.u0 + (d.u1 - d.u0) * static_cast<double>(i) / kPoints;
      const double b = d.v0 + (d.v1 - d.v0) * static_cast<double>(i * 7 % kPoints) / kPoints;
      benchmark::DoNotOptimize(at(a, b));
      const dvec3 by_u = at(a + kStep, b) - at(a - kStep, b);
      const dvec3 by_v = at(a, b + kStep) - at(a, b - kStep);
      benchmark::DoNotOptimize(glm::normalize(glm::cross(by_u, by_v)));
    }
  }
  state.counters["per vertex"] = benchmark::Counter(
      kPoints, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Text to tapes, derivatives included.
void compile_formula(benchmark::State& state, const BenchSurface& formula) {
  for (auto _ : state) benchmark::DoNotOptimize(compile_surface(formula));
}

/// The torus as an expert writes it: sines once per column and row, positions and normals as
/// floats.
void torus_by_hand(benchmark::State& state) {
  const Domain& d = kBenchSurfaces[0].domain;
  const std::vector<double> us = steps(d.u0, d.u1, kSide);
  const std::vector<double> vs = steps(d.v0, d.v1, kSide);
  std::vector<float> out(6 * kSide * kSide);
  std::vector<double> cos_u(kSide);
  std::vector<double> sin_u(kSide);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kSide; ++i) {
      cos_u[i] = std::cos(us[i]);
      sin_u[i] = std::sin(us[i]);
    }
    float* to = out.data();
    for (const double v : vs) {
      const double cos_v = std::cos(v);
      const double sin_v = std::sin(v);
      const double radius = 2 + cos_v;
      for (std::size_t i = 0; i < kSide; ++i, to += 6) {
        to[0] = static_cast<float>(radius * cos_u[i]);
        to[1] = static_cast<float>(radius * sin_u[i]);
        to[2] = static_cast<float>(sin_v);
        to[3] = static_cast<float>(cos_v * cos_u[i]);
        to[4] = static_cast<float>(cos_v * sin_u[i]);
        to[5] = static_cast<float>(sin_v);
      }
    }
    benchmark::ClobberMemory();
  }
  per_vertex(state);
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const BenchSurface& formula : kBenchSurfaces) {
    const std::string name = formula.name;
    const auto add = [&name](const std::string& what, auto function, auto... arguments) {
      benchmark::RegisterBenchmark((name + "/" + what).c_str(), function, arguments...)
          ->UseRealTime();
    };
    add("positions", positions, formula, 1U);
    add("tangents", tangents, formula, 1U);
    add("tangents, 2 threads", tangents, formula, 2U);
    add("muparser, central differences", muparser_differences, formula);
    add("compile", compile_formula, formula);
  }
  benchmark::RegisterBenchmark("torus/by hand, floats", torus_by_hand)->UseRealTime();
  return true;
}();

}  // namespace
}  // namespace saddle
