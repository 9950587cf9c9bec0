#include "scene/model/surface_scope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formula/expression.h"
#include "formula/graph.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

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

/// Throws Error (Input) where a coordinate has a formula or a range beside xyz.
void check_whole_position(const SurfaceSpec& spec) {
  const std::array<const std::string*, 3> formulas = {&spec.x, &spec.y, &spec.z};
  const std::array<std::string, 3> usual = {SurfaceSpec{}.x, SurfaceSpec{}.y, SurfaceSpec{}.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const bool is_given = *formulas[axis] != usual[axis];
    if (!is_given && !is_parameter(spec, name)) continue;
    throw Error(Status::Input, "xyz gives " + name + ", too",
                {"xyz", spec.xyz, {0, spec.xyz.size()}},
                is_given ? "leave xyz or " + name + " out" : "give the parameter another name");
  }
}

}  // namespace

NodeId parse_condition(const Graph& graph, Scope& scope, const std::string& text) {
  const NodeId condition = scope.parse("where", text);
  if (is_condition(graph, condition)) return condition;
  throw Error(Status::Input, "this is a number, not a condition", {"where", text, {0, text.size()}},
              "compare it: " + text + " < 1");
}

std::array<NodeId, 3> position(const Scope& scope) {
  return {scope.node("x"), scope.node("y"), scope.node("z")};
}

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
  if (!spec.xyz.empty()) return std::string("xyz.") + "xyz"[axis];
  const auto& [u, v] = spec.parameters;
  if (axis == 0 && spec.x == SurfaceSpec{}.x) return u == "y" ? v : u;
  if (axis == 1 && spec.y == SurfaceSpec{}.y) return v == "x" ? u : v;
  return std::array{spec.x, spec.y, spec.z}[axis];
}

bool is_parameter(const SurfaceSpec& spec, const std::string& name) {
  return std::ranges::find(spec.parameters, name) != spec.parameters.end();
}

bool has_height(const SurfaceSpec& spec) {
  return !spec.z.empty() || !spec.xyz.empty() || is_parameter(spec, "z");
}

std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec) {
  std::vector<Definition> names = scene.definitions;
  if (!spec.xyz.empty()) {
    check_whole_position(spec);
    names.push_back({"xyz", spec.xyz});
  }
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
  // Definitions of a scene with curves may use s.
  const bool is_lazy =
      !scene.curves.empty() || std::ranges::any_of(scene.surfaces, has_other_names);
  return {.parameters = spec.parameters,
          .lazy = is_lazy,
          .ranges = {{{spec.u.min, spec.u.max}, {spec.v.min, spec.v.max}}},
          .keeps_time = scene.keeps_time};
}

RangeText::RangeText(std::string parameter, const Range& range)
    : name(std::move(parameter)), text(range.min + ":" + range.max) {
  const std::size_t colon = range.min.size();
  ends = {Span{0, colon}, Span{colon + 1, text.size()}};
}

std::array<NodeId, 2> parse_ends(Scope& scope, const RangeText& range) {
  return {scope.parse(range.name, range.text, range.ends[0]),
          scope.parse(range.name, range.text, range.ends[1])};
}

bool depends(const Graph& graph, NodeId node, Depends on) {
  return (graph[node].depends & on) != 0;
}

RangeEnds constant_ends(Scope& scope, const RangeText& range, const std::array<NodeId, 2>& ends,
                        double t) {
  std::array<double, 2> values{};
  for (std::size_t k = 0; k < 2; ++k) {
    values[k] = scope.value(ends[k], range.place(range.ends[k]), t);
    if (!std::isfinite(values[k])) {
      throw Error(Status::Input, "this end of the range is not a finite number",
                  range.place(range.ends[k]));
    }
  }
  if (values[0] == values[1]) {
    throw Error(Status::Input, "the range of " + range.name + " is empty", range.place(),
                "both ends are " + format_number(values[0]) + "; they must differ, for example " +
                    range.name + "=0:2*pi");
  }
  if (!std::isfinite(values[1] - values[0])) {
    throw Error(Status::Input,
                "the range of " + range.name + " is too wide for its length to be a number",
                range.place());
  }
  return {values[0], values[1]};
}

}  // namespace saddle
