// Text to graph (Scope), graph to surface (derivatives and tapes), with both timed apart.
#include "scene/model/prepare.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
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

/// The ends of the first range depend on nothing, those of the second on the first at the most.
/// `names`: of both.
void check_dependence(const Graph& graph, const RangeText& range, const std::array<NodeId, 2>& ends,
                      const ParameterNames& names) {
  const auto& [u, v] = names;
  const bool is_first = range.name == u;
  for (std::size_t k = 0; k < 2; ++k) {
    const Place place = range.place(range.ends[k]);
    if (is_first && depends(graph, ends[k], kDependsV)) {
      throw Error(Status::Input, "the range of " + u + " cannot depend on " + v, place,
                  "the ends of " + v + " may depend on " + u + ": swap the two parameters");
    }
    if (depends(graph, ends[k], is_first ? kDependsU : kDependsV)) {
      throw Error(Status::Input, "the range of " + range.name + " depends on itself", place,
                  is_first
                      ? "both ends are constant expressions, for example " + u + "=0:2*pi"
                      : "its ends may depend on " + u + ", for example " + v + "=0:sin(" + u + ")");
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

/// It is 1 or 0, as comparisons are.
bool is_condition(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  switch (node.op) {
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual:
    case Op::Equal:
    case Op::NotEqual:
    case Op::And:
    case Op::Or:
      return true;
    case Op::Select:
      return is_condition(graph, node.args[1]) && is_condition(graph, node.args[2]);
    case Op::Constant:
      return node.value == 0 || node.value == 1;
    default:
      return false;
  }
}

NodeId parse_condition(const Graph& graph, Scope& scope, const std::string& text) {
  const NodeId condition = scope.parse("where", text);
  if (is_condition(graph, condition)) return condition;
  throw Error(Status::Input, "this is a number, not a condition", {"where", text, {0, text.size()}},
              "compare it: " + text + " < 1");
}

std::array<NodeId, 3> position(const Scope& scope) {
  return {scope.node("x"), scope.node("y"), scope.node("z")};
}

}  // namespace

std::array<NodeId, 3> restricted_position(Graph& graph, Scope& scope, const SurfaceSpec& spec) {
  std::array<NodeId, 3> r = position(scope);
  if (spec.where.empty()) return r;
  const Expression condition{&graph, parse_condition(graph, scope, spec.where)};
  // It has derivatives by u and v, which are undefined, too: those of a constant are 0.
  const Expression either =
      Expression{&graph, graph.variable(kSymbolU)} + Expression{&graph, graph.variable(kSymbolV)};
  const Expression nowhere =
      Expression{&graph, graph.constant(std::numeric_limits<double>::quiet_NaN())} * either;
  for (NodeId& coordinate : r) {
    coordinate = select(condition, Expression{&graph, coordinate}, nowhere).id;
  }
  return r;
}

std::string coordinate_formula(const SurfaceSpec& spec, std::size_t axis) {
  if (is_parameter(spec, std::string(1, "xyz"[axis]))) return "";
  const auto& [u, v] = spec.parameters;
  if (axis == 0 && spec.x == SurfaceSpec{}.x) return u == "y" ? v : u;
  if (axis == 1 && spec.y == SurfaceSpec{}.y) return v == "x" ? u : v;
  return std::array{spec.x, spec.y, spec.z}[axis];
}

bool is_parameter(const SurfaceSpec& spec, const std::string& name) {
  return std::ranges::find(spec.parameters, name) != spec.parameters.end();
}

bool has_height(const SurfaceSpec& spec) {
  return !spec.z.empty() || is_parameter(spec, "z");
}

std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec) {
  std::vector<Definition> names = scene.definitions;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    if (!is_parameter(spec, name)) names.push_back({name, coordinate_formula(spec, axis)});
  }
  for (Definition own : spec.definitions) {
    own.own = true;
    names.push_back(std::move(own));
  }
  return names;
}

Scope::View surface_view(const Scene& scene, const SurfaceSpec& spec) {
  const auto has_other_names = [&](const SurfaceSpec& other) {
    return other.parameters != spec.parameters;
  };
  return {spec.parameters, std::ranges::any_of(scene.surfaces, has_other_names)};
}

NodeId between(Graph& graph, const std::array<NodeId, 2>& ends) {
  const Expression s{&graph, graph.variable(kSymbolV)};
  const Expression a{&graph, ends[0]};
  const Expression b{&graph, ends[1]};
  const Expression in_order = a <= b;
  return ((1 - s) * select(in_order, a, b) + s * select(in_order, b, a)).id;
}

BoundSurface bind_surface(const Scene& scene, const SurfaceSpec& spec) {
  const auto& [name_u, name_v] = spec.parameters;
  if (!has_height(spec)) {
    throw Error(Status::Input, "z has no formula", {},
                "x and y default to " + name_u + " and " + name_v +
                    ", z has no default: for example z='sin(" + name_u + ")*cos(" + name_v + ")'");
  }
  BoundSurface result;
  Graph& graph = result.graph;
  Scope scope(graph, surface_definitions(scene, spec), surface_view(scene, spec));
  const RangeText range_u(name_u, spec.u);
  const RangeText range_v(name_v, spec.v);
  const std::array<NodeId, 2> ends_u = parse_ends(scope, range_u);
  check_dependence(graph, range_u, ends_u, spec.parameters);
  const std::array<NodeId, 2> ends = parse_ends(scope, range_v);
  check_dependence(graph, range_v, ends, spec.parameters);
  const Ends u = constant_ends(scope, range_u, scene.t);
  const bool leans = depends(graph, ends[0], kDependsU) || depends(graph, ends[1], kDependsU);
  if (leans && ends[0] == ends[1]) {
    throw Error(Status::Input, "the range of " + name_v + " is empty", range_v.place(),
                "its ends must differ");
  }
  const Ends v = leans ? Ends{0, 1} : constant_ends(scope, range_v, scene.t);
  result.domain = {u.min, u.max, v.min, v.max, spec.parameters};
  result.flip = spec.flip != runs_backwards(result.domain);
  const std::array<NodeId, 3> restricted = restricted_position(graph, scope, spec);
  std::vector<NodeId> roots(restricted.begin(), restricted.end());
  if (!spec.color.empty())
    roots.push_back(parse_color_formula(graph, scope, spec.color, result.flip));
  if (!spec.where.empty()) {
    roots.push_back(parse_condition(graph, scope, spec.where));
    std::ranges::copy(position(scope), std::back_inserter(roots));
  }
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
  if (!spec.where.empty()) result.region.assign(r.end() - kRegionOutputs, r.end());
  return result;
}

PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec, Order order) {
  const auto start = Clock::now();
  BoundSurface bound = bind_surface(scene, spec);
  const auto parsed = Clock::now();
  PreparedSurface result;
  result.surface = make_surface(bound.graph, bound.r, bound.domain, bound.flip, order);
  result.moves = bound.moves;
  if (bound.color) {
    result.surface.color = compile(bound.graph, std::array{*bound.color});
    result.surface.color.count = result.surface.tangents.count;
  }
  if (!bound.region.empty()) result.surface.region = compile(bound.graph, bound.region);
  if (bound.v) result.surface.v = compile(bound.graph, std::array{*bound.v});
  result.parse_ms = milliseconds(start, parsed);
  result.compile_ms = milliseconds(parsed, Clock::now());
  return result;
}

namespace {

/// The surface whose x, y and z constant expressions see; nullptr if none has formulas.
const SurfaceSpec* seen_surface(const Scene& scene, const SurfaceSpec* spec) {
  if (spec == nullptr && !scene.surfaces.empty()) spec = &scene.surfaces.back();
  return spec == nullptr || !has_height(*spec) ? nullptr : spec;
}

}  // namespace

std::vector<Definition> constant_names(const Scene& scene, const SurfaceSpec* spec) {
  const SurfaceSpec* const seen = seen_surface(scene, spec);
  return seen == nullptr ? scene.definitions : surface_definitions(scene, *seen);
}

Scope::View constant_view(const Scene& scene, const SurfaceSpec* spec) {
  const SurfaceSpec* const seen = seen_surface(scene, spec);
  Scope::View view = seen == nullptr ? Scope::View{} : surface_view(scene, *seen);
  view.of_surface = spec != nullptr;
  return view;
}

double finite_constant(const Scene& scene, const std::string& name, const std::string& text) {
  Graph graph;
  Scope scope(graph, constant_names(scene), constant_view(scene));
  const double value = scope.constant(name, text);
  if (!std::isfinite(value)) {
    throw Error(Status::Input, "not a finite number", {name, text, {0, text.size()}});
  }
  return value;
}

}  // namespace saddle
