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

}  // namespace

std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec) {
  std::vector<Definition> names = scene.definitions;
  names.push_back({"x", spec.x});
  names.push_back({"y", spec.y});
  names.push_back({"z", spec.z});
  return names;
}

BoundSurface bind_surface(const Scene& scene, const SurfaceSpec& spec) {
  if (spec.z.empty()) {
    throw Error(Status::Input, "z has no formula", {},
                "x and y default to u and v, z has no default: for example z='sin(u)*cos(v)'");
  }
  BoundSurface result;
  Scope scope(result.graph, surface_definitions(scene, spec));
  const Ends u = range_values(result.graph, scope, "u", spec.u);
  const Ends v = range_values(result.graph, scope, "v", spec.v);
  const std::array<NodeId, 3> coordinates = {scope.node("x"), scope.node("y"), scope.node("z")};
  const std::vector<NodeId> bound = scope.bind(coordinates, scene.t);
  result.r = {bound[0], bound[1], bound[2]};
  result.domain = {u.min, u.max, v.min, v.max};
  result.flip = spec.flip != runs_backwards(result.domain);
  return result;
}

PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec, Order order) {
  const auto start = Clock::now();
  BoundSurface bound = bind_surface(scene, spec);
  const auto parsed = Clock::now();
  PreparedSurface result;
  result.surface = make_surface(bound.graph, bound.r, bound.domain, bound.flip, order);
  result.parse_ms = milliseconds(start, parsed);
  result.compile_ms = milliseconds(parsed, Clock::now());
  return result;
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
