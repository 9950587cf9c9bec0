// Nanoseconds per box for positions with first and second derivatives: 18 enclosures, over the
// boxes of a 32 x 32 grid.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench_surfaces.h"
#include "eval/enclose.h"

namespace saddle {
namespace {

constexpr int kSide = 32;

std::vector<Interval> cells(double from, double to) {
  std::vector<Interval> result;
  for (int i = 0; i < kSide; ++i) {
    result.push_back({from + (to - from) * i / kSide, from + (to - from) * (i + 1) / kSide});
  }
  return result;
}

void enclose_grid(benchmark::State& state, const BenchSurface& formula) {
  const Tape tape = compile_surface(formula, Order::Second).bounds;
  Enclosure enclosure(tape);
  const std::vector<Interval> u = cells(formula.domain.u0, formula.domain.u1);
  const std::vector<Interval> v = cells(formula.domain.v0, formula.domain.v1);
  std::vector<Interval> outputs(tape.outputs.size());
  for (auto _ : state) {
    for (const Interval& row : v) {
      for (const Interval& column : u) {
        enclosure(column, row, outputs);
        benchmark::DoNotOptimize(outputs.data());
        benchmark::ClobberMemory();
      }
    }
  }
  state.counters["per box"] = benchmark::Counter(
      kSide * kSide, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["instructions"] =
      static_cast<double>(tape.of_u.size() + tape.of_v.size() + tape.of_both.size());
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const BenchSurface& formula : kBenchSurfaces) {
    const std::string name = std::string(formula.name) + "/enclose to second order";
    benchmark::RegisterBenchmark(name.c_str(), enclose_grid, formula);
  }
  return true;
}();

}  // namespace
}  // namespace saddle
