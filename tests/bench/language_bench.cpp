// Formulas of complex numbers and vectors against the same in real numbers, written by hand: what
// the language costs. `./dev bench --benchmark_filter=^language/` shows them in pairs.
#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

#include "bench_surfaces.h"
#include "eval/batch.h"

namespace saddle {
namespace {

struct LanguagePair {
  const char* name;
  std::vector<Definition> typed;
  std::vector<Definition> by_hand;
};

const std::array<LanguagePair, 3>& language_pairs() {
  static const std::array<LanguagePair, 3> kPairs = {{
      {"re((u+i*v)^3)",
       {{"x", "u"}, {"y", "v"}, {"z", "re((u+i*v)^3)"}},
       {{"x", "u"}, {"y", "v"}, {"z", "u^3-3*u*v^2"}}},
      {"tangents of a helix",
       {{"x", "p.x"},
        {"y", "p.y"},
        {"z", "p.z"},
        {"p", "c(u)+v*diff(c(u),u)"},
        {"c", "(cos(s),sin(s),s/4)", {"s"}, true}},
       {{"x", "cos(u)-v*sin(u)"}, {"y", "sin(u)+v*cos(u)"}, {"z", "u/4+v/4"}}},
      {"offset of a paraboloid",
       {{"x", "q.x"},
        {"y", "q.y"},
        {"z", "q.z"},
        {"p", "(u,v,u^2+v^2)"},
        {"q", "p+0.1*unit(cross(diff(p,u),diff(p,v)))"}},
       {{"x", "u-0.1*(2*u/n)"},
        {"y", "v-0.1*(2*v/n)"},
        {"z", "u^2+v^2+0.1*(1/n)"},
        {"n", "sqrt((2*u)^2+(2*v)^2+1)"}}},
  }};
  return kPairs;
}

void evaluate_definitions(benchmark::State& state, const std::vector<Definition>& definitions) {
  constexpr std::size_t kPoints = 1001;
  Graph graph;
  Scope scope(graph, definitions);
  const std::vector<NodeId> r =
      scope.bind(std::array{scope.node("x"), scope.node("y"), scope.node("z")}, 0);
  const Tape tape = compile(graph, r);
  const std::vector<double> at = steps(-1, 1, kPoints);
  std::array<std::vector<double>, 3> columns;
  std::vector<double*> outputs;
  for (auto& column : columns) {
    column.resize(kPoints * kPoints);
    outputs.push_back(column.data());
  }
  for (auto _ : state) evaluate_grid(tape, at, at, outputs, 1);
}

[[maybe_unused]] const bool kLanguageRegistered = [] {
  for (const LanguagePair& pair : language_pairs()) {
    const std::string name = std::string("language/") + pair.name;
    benchmark::RegisterBenchmark((name + "/typed").c_str(), evaluate_definitions, pair.typed);
    benchmark::RegisterBenchmark((name + "/by hand").c_str(), evaluate_definitions, pair.by_hand);
  }
  return true;
}();

}  // namespace
}  // namespace saddle
