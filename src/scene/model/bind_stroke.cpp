#include "scene/model/bind_stroke.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/nearest.h"
#include "formula/expression.h"
#include "formula/graph.h"
#include "formula/scope.h"
#include "surface/forms.h"

namespace saddle {

const SurfaceSpec& surface_under(const Scene& scene, const StrokeSpec& spec) {
  std::vector<const SurfaceSpec*> surfaces;
  std::vector<std::string> names;
  for (const SurfaceSpec& surface : scene.surfaces) {
    if (surface.is_stroke()) continue;
    surfaces.push_back(&surface);
    names.push_back(surface.name);
  }
  const auto found = std::ranges::find(names, spec.on);
  if (found != names.end()) return *surfaces[static_cast<std::size_t>(found - names.begin())];
  if (spec.on.empty() && surfaces.size() == 1) return *surfaces[0];
  if (surfaces.empty()) {
    throw Error(Status::Input, "there is no surface for u and v", {"u", spec.u, {0, spec.u.size()}},
                "a surface stands before what is on it; without one x, y and z say the place");
  }
  std::string known = "known surfaces:";
  for (const std::string& name : names) known += " '" + name + "'";
  if (spec.on.empty()) {
    throw Error(Status::Input, "'on' must say which surface u and v are of",
                {"u", spec.u, {0, spec.u.size()}}, known);
  }
  if (const auto nearest = nearest_name(spec.on, names)) {
    known += "; did you mean '" + *nearest + "'?";
  }
  throw Error(Status::Input, "no surface is called '" + spec.on + "'",
              {"on", spec.on, {0, spec.on.size()}}, known);
}

namespace {

constexpr const char* kExampleOfCurve = "x='cos(s)' y='sin(s)' z='s/5' s=0:tau";

/// The formulas of a curve or point while they are parsed.
class StrokeParser {
 public:
  /// `parameter`: the name of the variable, "s" or none.
  StrokeParser(Graph& graph, const Scene& scene, const std::string& parameter,
               const std::vector<Definition>& definitions)
      : graph_(graph),
        scene_(scene),
        scope_(graph, definitions,
               {.parameters = {parameter, ""}, .lazy = true, .keeps_time = scene.keeps_time}) {}

  Scope& scope() { return scope_; }
  bool moves() const { return moves_; }

  /// A formula; empty: 0.
  NodeId parse(const std::string& name, const std::string& text) {
    roots_.push_back(text.empty() ? graph_.constant(0) : scope_.parse(name, text));
    return roots_.back();
  }

  NodeId number(const std::string& name, const Number& number) {
    return number.text.empty() ? graph_.constant(number.value) : parse(name, number.text);
  }

  /// These nodes; or with u and v on a surface, its x, y and z there. In u in place of s.
  Coordinates place(const StrokeSpec& spec, const Coordinates& r) {
    std::vector<NodeId> result(r.begin(), r.end());
    if (!spec.u.empty() || !spec.v.empty()) {
      const SurfaceSpec& surface = surface_under(scene_, spec);
      const NodeId u = parse("u", spec.u);
      const NodeId v = parse("v", spec.v);
      Scope of_surface(graph_, surface_definitions(scene_, surface), surface_view(scene_, surface));
      const std::array<NodeId, 3> there = restricted_position(graph_, of_surface, surface);
      result.assign(there.begin(), there.end());
      roots_.insert(roots_.end(), result.begin(), result.end());
      result = of_surface.bind(result, scene_.t);
      result = substitute(graph_, result, {{kSymbolU, u}, {kSymbolV, v}});
    }
    moves_ = std::ranges::any_of(roots_, [&](NodeId n) { return depends(graph_, n, kDependsT); });
    result = scope_.bind(result, scene_.t);
    return {result[0], result[1], result[2]};
  }

 private:
  Graph& graph_;
  const Scene& scene_;
  Scope scope_;
  std::vector<NodeId> roots_;
  bool moves_ = false;
};

/// The formulas of x, y and z, by their names; those of xyz are its components.
std::array<std::pair<std::string, std::string>, 3> coordinate_formulas(const CurveSpec& spec) {
  if (spec.xyz.empty()) return {{{"x", spec.x}, {"y", spec.y}, {"z", spec.z}}};
  for (const auto& [name, text] : {std::pair{"x", spec.x}, {"y", spec.y}, {"z", spec.z}}) {
    if (text.empty()) continue;
    throw Error(Status::Input, std::string("xyz gives ") + name + ", too",
                {"xyz", spec.xyz, {0, spec.xyz.size()}},
                std::string("leave xyz or ") + name + " out");
  }
  return {{{"x", "xyz.x"}, {"y", "xyz.y"}, {"z", "xyz.z"}}};
}

/// The names that a curve's formulas see.
std::vector<Definition> curve_definitions(const Scene& scene, const CurveSpec& spec) {
  std::vector<Definition> names = scene.definitions;
  if (!spec.xyz.empty()) names.push_back({"xyz", spec.xyz});
  return names;
}

/// ", here p and q" on a surface whose parameters have names of their own.
std::string own_names(const Scene& scene, const StrokeSpec& spec) {
  const ParameterNames& names = surface_under(scene, spec).parameters;
  return names == kUsualParameters ? "" : ", here " + names[0] + " and " + names[1];
}

/// Either a place in space or both u and v on a surface.
void check_place(const Scene& scene, const StrokeSpec& spec, bool is_in_space,
                 const std::string& what, const std::string& example) {
  const bool is_on_surface = !spec.u.empty() || !spec.v.empty();
  if (!is_in_space && !is_on_surface) {
    throw Error(Status::Input, "the " + what + " has no place", {}, "for example " + example);
  }
  const std::string& given = spec.u.empty() ? spec.v : spec.u;
  const char* const name = spec.u.empty() ? "v" : "u";
  if (is_in_space && is_on_surface) {
    throw Error(Status::Input, "the " + what + " has two places, one in space and one on a surface",
                {name, given, {0, given.size()}}, "leave one of them out");
  }
  if (is_on_surface && (spec.u.empty() || spec.v.empty())) {
    throw Error(Status::Input, std::string(spec.u.empty() ? "u" : "v") + " is missing",
                {name, given, {0, given.size()}},
                "a place on a surface has u and v" + own_names(scene, spec));
  }
}

}  // namespace

BoundSurface bind_point(const Scene& scene, const PointSpec& spec) {
  check_place(scene, spec, spec.at.has_value(), "point", "point 1,2,3");
  BoundSurface result;
  Graph& graph = result.graph;
  StrokeParser parser(graph, scene, "", scene.definitions);
  Coordinates at{};
  if (spec.at) {
    at = {parser.number("at", spec.at->x), parser.number("at", spec.at->y),
          parser.number("at", spec.at->z)};
  }
  const Number radius = spec.radius.value_or(0);
  parser.number("radius", radius);
  at = parser.place(spec, at);
  const Expression r{&graph, graph.constant(radius.value)};
  const auto of = [&](Op op, Symbol symbol) {
    return make(op, Expression{&graph, graph.variable(symbol)});
  };
  const Expression across = r * of(Op::Cos, kSymbolV);
  const std::array<Expression, 3> out = {across * of(Op::Cos, kSymbolU),
                                         across * of(Op::Sin, kSymbolU), r * of(Op::Sin, kSymbolV)};
  for (std::size_t k = 0; k < 3; ++k) result.r[k] = (Expression{&graph, at[k]} + out[k]).id;
  result.domain = {0, 2 * std::numbers::pi, -std::numbers::pi / 2, std::numbers::pi / 2};
  result.ends = {graph.constant(result.domain.u0), graph.constant(result.domain.u1),
                 graph.constant(result.domain.v0), graph.constant(result.domain.v1)};
  result.moves = parser.moves();
  return result;
}

BoundCurve bind_curve(const Scene& scene, const CurveSpec& spec) {
  const auto formulas = coordinate_formulas(spec);
  check_place(scene, spec,
              std::ranges::any_of(formulas, [](const auto& f) { return !f.second.empty(); }),
              "curve", kExampleOfCurve);
  BoundCurve result;
  Graph& graph = result.graph;
  StrokeParser parser(graph, scene, "s", curve_definitions(scene, spec));
  const RangeText range("s", spec.s);
  const std::array<NodeId, 2> ends = parse_ends(parser.scope(), range);
  const RangeEnds s = constant_ends(parser.scope(), range, ends, scene.t);
  result.from = s.min;
  result.to = s.max;
  Coordinates r{};
  for (std::size_t k = 0; k < 3; ++k) r[k] = parser.parse(formulas[k].first, formulas[k].second);
  if (spec.radius) parser.number("radius", *spec.radius);
  result.r = parser.place(spec, r);
  const std::vector<NodeId> bound = parser.scope().bind(ends, scene.t);
  result.ends = {bound[0], bound[1]};
  result.moves = parser.moves() || std::ranges::any_of(ends, [&](NodeId end) {
                   return depends(graph, end, kDependsT);
                 });
  const auto uses_s = [&](NodeId node) { return depends(graph, node, kDependsU); };
  if (!std::ranges::any_of(result.r, uses_s)) {
    throw Error(Status::Input, "the curve does not depend on s", {},
                std::string("s is a curve's parameter, t is time: for example ") + kExampleOfCurve);
  }
  return result;
}

BoundSurface bind_as_surface(const Scene& scene, const CurveSpec& spec) {
  BoundCurve curve = bind_curve(scene, spec);
  BoundSurface result;
  result.graph = std::move(curve.graph);
  result.r = curve.r;
  result.domain = {curve.from, curve.to, 0, 1};
  result.ends = {curve.ends[0], curve.ends[1], result.graph.constant(0), result.graph.constant(1)};
  result.moves = curve.moves;
  return result;
}

}  // namespace saddle
