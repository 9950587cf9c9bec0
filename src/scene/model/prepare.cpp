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
#include "scene/model/bind_stroke.h"
#include "surface/forms.h"

namespace saddle {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
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

/// A formula of u, v, x, y, z and the curvatures; `name` stands for it in messages.
NodeId parse_number_formula(Graph& graph, Scope& scope, const std::string& name,
                            const std::string& text, bool flip) {
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
  return scope.parse_with(curvatures, name, text);
}

/// Levels and the ends of colours are the mesh's, too: where they use t, another time has another.
bool levels_move(Scope& scope, const SurfaceSpec& spec, double t) {
  std::vector<const Number*> numbers;
  if (spec.color_ends) numbers = {&spec.color_ends->low, &spec.color_ends->high};
  for (const ContourSpec& contour : spec.contours) {
    for (const Number& level : contour.levels) numbers.push_back(&level);
  }
  for (const Number* number : numbers) {
    if (!number->text.empty()) scope.constant("contours", number->text, {}, t);
  }
  return scope.has_used_time();
}

void check_height(const SurfaceSpec& spec) {
  if (has_height(spec)) return;
  const auto& [u, v] = spec.parameters;
  throw Error(Status::Input, "z has no formula", {},
              "x and y default to " + u + " and " + v + ", z has no default: for example z='sin(" +
                  u + ")*cos(" + v + ")'");
}

}  // namespace

NodeId between(Graph& graph, const std::array<NodeId, 2>& ends) {
  const Expression s{&graph, graph.variable(kSymbolV)};
  const Expression a{&graph, ends[0]};
  const Expression b{&graph, ends[1]};
  const Expression in_order = a <= b;
  return ((1 - s) * select(in_order, a, b) + s * select(in_order, b, a)).id;
}

BoundSurface bind_surface(const Scene& scene, const SurfaceSpec& spec) {
  if (spec.curve) return bind_as_surface(scene, scene.curves[*spec.curve]);
  if (spec.point) return bind_point(scene, scene.points[*spec.point]);
  check_height(spec);
  const auto& [name_u, name_v] = spec.parameters;
  BoundSurface result;
  Graph& graph = result.graph;
  Scope scope(graph, surface_definitions(scene, spec), surface_view(scene, spec));
  const RangeText range_u(name_u, spec.u);
  const RangeText range_v(name_v, spec.v);
  const std::array<NodeId, 2> ends_u = parse_ends(scope, range_u);
  check_dependence(graph, range_u, ends_u, spec.parameters);
  const std::array<NodeId, 2> ends = parse_ends(scope, range_v);
  check_dependence(graph, range_v, ends, spec.parameters);
  const RangeEnds u = constant_ends(scope, range_u, ends_u, scene.t);
  const bool leans = depends(graph, ends[0], kDependsU) || depends(graph, ends[1], kDependsU);
  if (leans && ends[0] == ends[1]) {
    throw Error(Status::Input, "the range of " + name_v + " is empty", range_v.place(),
                "both ends are the same; they must differ, for example " + name_v + "=0:sin(" +
                    name_u + ")");
  }
  const RangeEnds v = leans ? RangeEnds{0, 1} : constant_ends(scope, range_v, ends, scene.t);
  result.domain = {u.min, u.max, v.min, v.max, spec.parameters};
  result.flip = spec.flip != runs_backwards(result.domain);
  const std::array<NodeId, 3> restricted = restricted_position(graph, scope, spec);
  std::vector<NodeId> roots(restricted.begin(), restricted.end());
  if (!spec.color.empty())
    roots.push_back(parse_number_formula(graph, scope, "color", spec.color, result.flip));
  for (const ContourSpec& contour : spec.contours) {
    roots.push_back(
        parse_number_formula(graph, scope, "contours", contour.expression, result.flip));
  }
  if (!spec.where.empty()) {
    roots.push_back(parse_condition(graph, scope, spec.where));
    std::ranges::copy(position(scope), std::back_inserter(roots));
  }
  const auto depends_on_t = [&](NodeId node) { return depends(graph, node, kDependsT); };
  result.moves = std::ranges::any_of(roots, depends_on_t) ||
                 std::ranges::any_of(ends_u, depends_on_t) ||
                 std::ranges::any_of(ends, depends_on_t) || levels_move(scope, spec, scene.t);
  std::vector<NodeId> r = scope.bind(roots, scene.t);
  const std::vector<NodeId> bound_u = scope.bind(ends_u, scene.t);
  const std::vector<NodeId> bound_v = scope.bind(ends, scene.t);
  result.ends = {bound_u[0], bound_u[1], bound_v[0], bound_v[1]};
  if (leans) {
    result.v = between(graph, {bound_v[0], bound_v[1]});
    r = substitute(graph, r, {{kSymbolV, *result.v}});
    result.ends[2] = graph.constant(0);
    result.ends[3] = graph.constant(1);
  }
  result.r = {r[0], r[1], r[2]};
  auto next = r.begin() + 3;
  if (!spec.color.empty()) result.color = *next++;
  const auto contours_end = next + static_cast<std::ptrdiff_t>(spec.contours.size());
  result.contours.assign(next, contours_end);
  if (!spec.where.empty()) result.region.assign(contours_end, r.end());
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
  if (!bound.region.empty()) result.surface.region = compile(bound.graph, bound.region);
  for (const NodeId contour : bound.contours) {
    Tape& tape = result.contours.emplace_back(compile(bound.graph, std::array{contour}));
    tape.count = result.surface.tangents.count;
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
  return spec == nullptr || !has_height(*spec) ? nullptr : spec;
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
