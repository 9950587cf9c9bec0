// Text to graph (Scope), graph to surface (derivatives and tapes), with both timed apart.
#include "scene/prepare.h"

#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "formula/graph.h"
#include "formula/scope.h"
#include "surface/forms.h"

namespace saddle {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// One end of a range: `part` of `text`, which is the whole range, so that carets point into it.
double range_end(Graph& graph, Scope& scope, const std::string& name, const std::string& text,
                 Span part) {
  const Place place{name, text, part};
  const NodeId node = scope.parse(name, text, part);
  if ((graph[node].depends & (kDependsU | kDependsV)) != 0) {
    throw Error(Status::Input, "a range that depends on u or v cannot be drawn yet", place,
                "both ends are constant expressions, for example " + name + "=0:2*pi");
  }
  const double value = scope.constant(name, text, part);
  if (!std::isfinite(value)) {
    throw Error(Status::Input, "this end of the range is not a finite number", place);
  }
  return value;
}

struct Ends {
  double min = 0;
  double max = 0;
};

Ends range_values(Graph& graph, Scope& scope, const std::string& name, const Range& range) {
  const std::string text = range.min + ":" + range.max;
  const std::size_t colon = range.min.size();
  const Ends result{range_end(graph, scope, name, text, {0, colon}),
                    range_end(graph, scope, name, text, {colon + 1, text.size()})};
  const Place place{name, text, {0, text.size()}};
  if (result.min == result.max) {
    throw Error(Status::Input, "the range of " + name + " is empty", place,
                "its ends must differ, for example " + name + "=0:2*pi");
  }
  if (!std::isfinite(result.max - result.min)) {
    throw Error(Status::Input,
                "the range of " + name + " is too wide for its length to be a number", place);
  }
  return result;
}

/// The formulas of a surface as nodes of u and v.
struct Formulas {
  Coordinates r;
  Domain domain;
};

Formulas parse_formulas(Graph& graph, const Scene& scene, const SurfaceSpec& spec) {
  if (spec.z.empty()) {
    throw Error(Status::Input, "z has no formula", {},
                "x and y default to u and v, z has no default: for example z='sin(u)*cos(v)'");
  }
  Scope scope(graph, surface_definitions(scene, spec));
  const Ends u = range_values(graph, scope, "u", spec.u);
  const Ends v = range_values(graph, scope, "v", spec.v);
  const std::array<NodeId, 3> coordinates = {scope.node("x"), scope.node("y"), scope.node("z")};
  const std::vector<NodeId> bound = scope.bind(coordinates, scene.t);
  return {{bound[0], bound[1], bound[2]}, {u.min, u.max, v.min, v.max}};
}

}  // namespace

std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec) {
  std::vector<Definition> names = scene.definitions;
  names.push_back({"x", spec.x});
  names.push_back({"y", spec.y});
  names.push_back({"z", spec.z});
  return names;
}

PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec, Order order) {
  const auto start = Clock::now();
  Graph graph;
  const auto [r, domain] = parse_formulas(graph, scene, spec);
  const auto parsed = Clock::now();

  PreparedSurface result;
  const bool flip = spec.flip != runs_backwards(domain);
  result.surface = make_surface(graph, r, domain, flip, order);
  result.parse_ms = milliseconds(start, parsed);
  result.compile_ms = milliseconds(parsed, Clock::now());
  return result;
}

void check_formulas(const Scene& scene, const SurfaceSpec& spec) {
  Graph graph;
  parse_formulas(graph, scene, spec);
}

std::vector<Definition> constant_names(const Scene& scene) {
  const bool has_surface = !scene.surfaces.empty() && !scene.surfaces.back().z.empty();
  return has_surface ? surface_definitions(scene, scene.surfaces.back()) : scene.definitions;
}

double finite_constant(const Scene& scene, const std::string& name, const std::string& text) {
  Graph graph;
  Scope scope(graph, constant_names(scene));
  const double value = scope.constant(name, text);
  if (!std::isfinite(value)) {
    throw Error(Status::Input, "not a finite number", {name, text, {0, text.size()}});
  }
  return value;
}

}  // namespace saddle
