// Nanoseconds per box for positions with first and second derivatives: 18 enclosures, over the
// boxes of a 32 x 32 grid.
#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

#include "eval/enclose.h"
#include "formula/derive.h"
#include "formula/scope.h"

namespace saddle {
namespace {

struct Formula {
  const char* name;
  const char* x;
  const char* y;
  const char* z;
  std::array<double, 4> domain;  // u from, to, v from, to
};

constexpr double kPi = 3.14159265358979323846;
constexpr int kSide = 32;

const std::array<Formula, 5> kFormulas = {{
    {"plane", "u", "v", "u+v", {-1, 1, -1, 1}},
    {"torus", "(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)", {0, 2 * kPi, 0, 2 * kPi}},
    {"enneper", "u-u^3/3+u*v^2", "v-v^3/3+u^2*v", "u^2-v^2", {-2, 2, -2, 2}},
    {"seashell",
     "2*(1-exp(u/(6*pi)))*cos(u)*cos(v/2)^2",
     "2*(exp(u/(6*pi))-1)*sin(u)*cos(v/2)^2",
     "1-exp(u/(3*pi))-sin(v)+exp(u/(6*pi))*sin(v)",
     {0, 6 * kPi, 0, 2 * kPi}},
    {"rough", "u", "v", "sin(5*u)*cos(5*v)/5+exp(-u^2-v^2)", {-3, 3, -3, 3}},
}};

/// Outputs x, y, z, then their derivatives by u, v, uu, uv, vv.
Tape tape_of(const Formula& formula) {
  Graph graph;
  Scope scope(graph, {{"x", formula.x}, {"y", formula.y}, {"z", formula.z}});
  const std::vector<NodeId> position =
      scope.bind(std::array{scope.node("x"), scope.node("y"), scope.node("z")}, 0);
  const std::vector<NodeId> by_u = derive(graph, position, kSymbolU);
  const std::vector<NodeId> by_v = derive(graph, position, kSymbolV);
  std::vector<NodeId> roots = position;
  for (const std::vector<NodeId>& more :
       {by_u, by_v, derive(graph, by_u, kSymbolU), derive(graph, by_u, kSymbolV),
        derive(graph, by_v, kSymbolV)}) {
    roots.insert(roots.end(), more.begin(), more.end());
  }
  return compile(graph, roots, Powers::Whole);
}

std::vector<Interval> cells(double from, double to) {
  std::vector<Interval> result;
  for (int i = 0; i < kSide; ++i) {
    result.push_back({from + (to - from) * i / kSide, from + (to - from) * (i + 1) / kSide});
  }
  return result;
}

void enclose_grid(benchmark::State& state, const Formula& formula) {
  const Tape tape = tape_of(formula);
  Enclosure enclosure(tape);
  const std::vector<Interval> u = cells(formula.domain[0], formula.domain[1]);
  const std::vector<Interval> v = cells(formula.domain[2], formula.domain[3]);
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
  for (const Formula& formula : kFormulas) {
    const std::string name = std::string(formula.name) + "/enclose to second order";
    benchmark::RegisterBenchmark(name.c_str(), enclose_grid, formula);
  }
  return true;
}();

}  // namespace
}  // namespace saddle
