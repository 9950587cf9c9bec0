// The surfaces that benchmarks use, and how they are compiled.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "formula/scope.h"
#include "surface/forms.h"
#include "surface/surface.h"

namespace saddle {

inline constexpr double kPi = 3.14159265358979323846;

struct BenchSurface {
  const char* name;
  const char* x;
  const char* y;
  const char* z;
  Domain domain;
};

inline constexpr std::array<BenchSurface, 4> kBenchSurfaces = {{
    {"torus", "(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)", {0, 2 * kPi, 0, 2 * kPi}},
    {"enneper", "u-u^3/3+u*v^2", "v-v^3/3+u^2*v", "u^2-v^2", {-2, 2, -2, 2}},
    {"seashell",
     "2*(1-exp(u/(6*pi)))*cos(u)*cos(v/2)^2",
     "2*(exp(u/(6*pi))-1)*sin(u)*cos(v/2)^2",
     "1-exp(u/(3*pi))-sin(v)+exp(u/(6*pi))*sin(v)",
     {0, 6 * kPi, 0, 2 * kPi}},
    {"rough", "u", "v", "sin(5*u)*cos(5*v)/5+exp(-u^2-v^2)", {-3, 3, -3, 3}},
}};

inline std::array<NodeId, 3> parse_surface(Graph& graph, const BenchSurface& formula) {
  Scope scope(graph, {{"x", formula.x}, {"y", formula.y}, {"z", formula.z}});
  const std::vector<NodeId> r =
      scope.bind(std::array{scope.node("x"), scope.node("y"), scope.node("z")}, 0);
  return {r[0], r[1], r[2]};
}

/// Text to tapes, derivatives included.
inline Surface compile_surface(const BenchSurface& formula, Order order = Order::First) {
  Graph graph;
  return make_surface(graph, parse_surface(graph, formula), formula.domain, false, order);
}

/// x, y, z alone.
inline Tape compile_positions(const BenchSurface& formula) {
  Graph graph;
  return compile(graph, parse_surface(graph, formula));
}

/// x, y, z and r_u x r_v alone.
inline Tape compile_with_normals(const BenchSurface& formula) {
  Graph graph;
  std::vector<NodeId> outputs =
      normal_outputs(graph, tangents_of(graph, parse_surface(graph, formula)));
  outputs.resize(6);
  return compile(graph, outputs);
}

/// `count` evenly spaced numbers.
inline std::vector<double> steps(double first, double last, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return values;
}

}  // namespace saddle
