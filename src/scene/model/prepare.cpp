// Text to graph (Scope), graph to surface (derivatives and tapes), with both timed apart.
#include "scene/model/prepare.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "formula/expression.h"
#include "formula/graph.h"
#include "formula/scope.h"
#include "surface/forms.h"

namespace saddle {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// The text of a range, so that carets point into all of it, and its ends.
struct RangeText {
  std::string name;
  std::string text;
  std::array<Span, 2> ends;

  RangeText(std::string parameter, const Range& range)
      : name(std::move(parameter)), text(range.min + ":" + range.max) {
    const std::size_t colon = range.min.size();
    ends = {Span{0, colon}, Span{colon + 1, text.size()}};
  }
  Place place(Span part) const { return {name, text, part}; }
  Place place() const { return place({0, text.size()}); }
};

/// Both ends of a range as nodes.
std::array<NodeId, 2> parse_ends(Scope& scope, const RangeText& range) {
  return {scope.parse(range.name, range.text, range.ends[0]),
          scope.parse(range.name, range.text, range.ends[1])};
}

bool depends(const Graph& graph, NodeId node, Depends on) {
  return (graph[node].depends & on) != 0;
}

/// The ends of the range of u depend on nothing, those of v on u at the most.
void check_dependence(const Graph& graph, const RangeText& range,
                      const std::array<NodeId, 2>& ends) {
  for (std::size_t k = 0; k < 2; ++k) {
    const Place place = range.place(range.ends[k]);
    if (range.name == "u" && depends(graph, ends[k], kDependsV)) {
      throw Error(Status::Input, "the range of u cannot depend on v", place,
                  "the ends of v may depend on u: swap the two parameters");
    }
    if (depends(graph, ends[k], range.name == "u" ? kDependsU : kDependsV)) {
      throw Error(Status::Input, "the range of " + range.name + " depends on itself", place,
                  range.name == "u" ? "both ends are constant expressions, for example u=0:2*pi"
                                    : "its ends may depend on u, for example v=0:sin(u)");
    }
  }
}

struct Ends {
  double min = 0;
  double max = 0;
};

/// They may depend on t.
Ends constant_ends(Scope& scope, const RangeText& range, double t) {
  std::array<double, 2> values{};
  for (std::size_t k = 0; k < 2; ++k) {
    values[k] = scope.constant(range.name, range.text, range.ends[k], t);
    if (!std::isfinite(values[k])) {
      throw Error(Status::Input, "this end of the range is not a finite number",
                  range.place(range.ends[k]));
    }
  }
  if (values[0] == values[1]) {
    throw Error(Status::Input, "the range of " + range.name + " is empty", range.place(),
                "its ends must differ, for example " + range.name + "=0:2*pi");
  }
  if (!std::isfinite(values[1] - values[0])) {
    throw Error(Status::Input,
                "the range of " + range.name + " is too wide for its length to be a number",
                range.place());
  }
  return {values[0], values[1]};
}

/// A formula of u, v, x, y, z and the curvatures.
NodeId parse_color_formula(Graph& graph, Scope& scope, const std::string& text, bool flip) {
  const auto curvature = [&](std::size_t which) {
    const Coordinates r = {scope.node("x"), scope.node("y"), scope.node("z")};
    return curvature_outputs(graph, tangents_of(graph, r))[which];
  };
  // Its sign goes with the front, as that of the normals does.
  const auto mean = [&] {
    return flip ? graph.make(Op::Neg, curvature(kMeanCurvature)) : curvature(kMeanCurvature);
  };
  const Scope::LocalNames curvatures = {{"gauss", [&] { return curvature(kGaussCurvature); }},
                                        {"mean", mean}};
  return scope.parse_with(curvatures, "color", text);
}

}  // namespace

std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec) {
  std::vector<Definition> names = scene.definitions;
  names.push_back({"x", spec.x});
  names.push_back({"y", spec.y});
  names.push_back({"z", spec.z});
  return names;
}

NodeId between(Graph& graph, const std::array<NodeId, 2>& ends) {
  const Expression s{&graph, graph.variable(kSymbolV)};
  const Expression a{&graph, ends[0]};
  const Expression b{&graph, ends[1]};
  const Expression in_order = a <= b;
  return ((1 - s) * select(in_order, a, b) + s * select(in_order, b, a)).id;
}

BoundSurface bind_surface(const Scene& scene, const SurfaceSpec& spec) {
  if (spec.z.empty()) {
    throw Error(Status::Input, "z has no formula", {},
                "x and y default to u and v, z has no default: for example z='sin(u)*cos(v)'");
  }
  BoundSurface result;
  Graph& graph = result.graph;
  Scope scope(graph, surface_definitions(scene, spec));
  const RangeText range_u("u", spec.u);
  const RangeText range_v("v", spec.v);
  const std::array<NodeId, 2> ends_u = parse_ends(scope, range_u);
  check_dependence(graph, range_u, ends_u);
  const std::array<NodeId, 2> ends = parse_ends(scope, range_v);
  check_dependence(graph, range_v, ends);
  const Ends u = constant_ends(scope, range_u, scene.t);
  const bool leans = depends(graph, ends[0], kDependsU) || depends(graph, ends[1], kDependsU);
  if (leans && ends[0] == ends[1]) {
    throw Error(Status::Input, "the range of v is empty", range_v.place(), "its ends must differ");
  }
  const Ends v = leans ? Ends{0, 1} : constant_ends(scope, range_v, scene.t);
  result.domain = {u.min, u.max, v.min, v.max};
  result.flip = spec.flip != runs_backwards(result.domain);
  std::vector<NodeId> roots = {scope.node("x"), scope.node("y"), scope.node("z")};
  if (!spec.color.empty())
    roots.push_back(parse_color_formula(graph, scope, spec.color, result.flip));
  const auto depends_on_t = [&](NodeId node) { return depends(graph, node, kDependsT); };
  result.moves = std::ranges::any_of(roots, depends_on_t) ||
                 std::ranges::any_of(ends_u, depends_on_t) ||
                 std::ranges::any_of(ends, depends_on_t);
  std::vector<NodeId> r = scope.bind(roots, scene.t);
  if (leans) {
    const std::vector<NodeId> bound = scope.bind(ends, scene.t);
    result.v = between(graph, {bound[0], bound[1]});
    r = substitute(graph, r, {{kSymbolV, *result.v}});
  }
  result.r = {r[0], r[1], r[2]};
  if (!spec.color.empty()) result.color = r[3];
  return result;
}

PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec, Order order,
                                const dvec3& stretch) {
  const auto start = Clock::now();
  BoundSurface bound = bind_surface(scene, spec);
  for (int k = 0; k < 3; ++k) {
    if (stretch[k] == 1) continue;
    NodeId& coordinate = bound.r[static_cast<std::size_t>(k)];
    const Expression factor{&bound.graph, bound.graph.constant(stretch[k])};
    coordinate = (factor * Expression{&bound.graph, coordinate}).id;
  }
  const auto parsed = Clock::now();
  PreparedSurface result;
  result.surface = make_surface(bound.graph, bound.r, bound.domain, bound.flip, order);
  result.moves = bound.moves;
  if (bound.color) {
    result.surface.color = compile(bound.graph, std::array{*bound.color});
    result.surface.color.count = result.surface.tangents.count;
  }
  if (bound.v) result.surface.v = compile(bound.graph, std::array{*bound.v});
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
