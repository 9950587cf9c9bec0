// Text to graph (Scope), graph to surface (derivatives and tapes), with both timed apart.
#include "scene/model/prepare.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/nearest.h"
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
  for (Definition own : spec.definitions) {
    own.own = true;
    names.push_back(std::move(own));
  }
  return names;
}

/// Definitions of a scene with curves may use s.
Scope::View surface_view(const Scene& scene, const SurfaceSpec&) {
  return {.lazy = !scene.curves.empty()};
}

NodeId between(Graph& graph, const std::array<NodeId, 2>& ends) {
  const Expression s{&graph, graph.variable(kSymbolV)};
  const Expression a{&graph, ends[0]};
  const Expression b{&graph, ends[1]};
  const Expression in_order = a <= b;
  return ((1 - s) * select(in_order, a, b) + s * select(in_order, b, a)).id;
}

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
  StrokeParser(Graph& graph, const Scene& scene, const std::string& parameter)
      : graph_(graph),
        scene_(scene),
        scope_(graph, scene.definitions, {.parameters = {parameter, ""}, .lazy = true}) {}

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
      Scope of_surface(graph_, surface_definitions(scene_, surface),
                       surface_view(scene_, surface));
      result = {of_surface.node("x"), of_surface.node("y"), of_surface.node("z")};
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

/// Where a curve goes, as a surface that is one line.
BoundSurface bind_as_surface(const Scene& scene, const CurveSpec& spec) {
  BoundCurve curve = bind_curve(scene, spec);
  BoundSurface result;
  result.graph = std::move(curve.graph);
  result.r = curve.r;
  result.domain = {curve.from, curve.to, 0, 1};
  result.moves = curve.moves;
  return result;
}

/// Either a place in space or both u and v on a surface.
void check_place(const StrokeSpec& spec, bool is_in_space, const std::string& what,
                 const std::string& example) {
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
                {name, given, {0, given.size()}}, "a place on a surface has u and v");
  }
}

}  // namespace

BoundSurface bind_point(const Scene& scene, const PointSpec& spec) {
  check_place(spec, spec.at.has_value(), "point", "point 1,2,3");
  BoundSurface result;
  Graph& graph = result.graph;
  StrokeParser parser(graph, scene, "");
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
  result.moves = parser.moves();
  return result;
}

BoundCurve bind_curve(const Scene& scene, const CurveSpec& spec) {
  check_place(spec, !(spec.x.empty() && spec.y.empty() && spec.z.empty()), "curve", kExampleOfCurve);
  BoundCurve result;
  Graph& graph = result.graph;
  StrokeParser parser(graph, scene, "s");
  const RangeText range("s", spec.s);
  const std::array<NodeId, 2> ends = parse_ends(parser.scope(), range);
  const Ends s = constant_ends(parser.scope(), range, scene.t);
  result.from = s.min;
  result.to = s.max;
  const Coordinates r = {parser.parse("x", spec.x), parser.parse("y", spec.y),
                         parser.parse("z", spec.z)};
  if (spec.radius) parser.number("radius", *spec.radius);
  result.r = parser.place(spec, r);
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

BoundSurface bind_surface(const Scene& scene, const SurfaceSpec& spec) {
  if (spec.curve) return bind_as_surface(scene, scene.curves[*spec.curve]);
  if (spec.point) return bind_point(scene, scene.points[*spec.point]);
  if (spec.z.empty()) {
    throw Error(Status::Input, "z has no formula", {},
                "x and y default to u and v, z has no default: for example z='sin(u)*cos(v)'");
  }
  BoundSurface result;
  Graph& graph = result.graph;
  Scope scope(graph, surface_definitions(scene, spec), surface_view(scene, spec));
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
  if (bound.v) result.surface.v = compile(bound.graph, std::array{*bound.v});
  result.parse_ms = milliseconds(start, parsed);
  result.compile_ms = milliseconds(parsed, Clock::now());
  return result;
}

namespace {

/// The surface whose x, y and z constant expressions see; nullptr if none has formulas.
const SurfaceSpec* seen_surface(const Scene& scene, const SurfaceSpec* spec) {
  if (spec == nullptr && !scene.surfaces.empty()) spec = &scene.surfaces.back();
  return spec == nullptr || spec->z.empty() ? nullptr : spec;
}

}  // namespace

std::vector<Definition> constant_names(const Scene& scene, const SurfaceSpec* spec) {
  const SurfaceSpec* const seen = seen_surface(scene, spec);
  return seen == nullptr ? scene.definitions : surface_definitions(scene, *seen);
}

Scope::View constant_view(const Scene& scene, const SurfaceSpec* spec) {
  const SurfaceSpec* const seen = seen_surface(scene, spec);
  Scope::View view = surface_view(scene, seen == nullptr ? SurfaceSpec() : *seen);
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
