#include "meshing/stroke_mesh.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "eval/batch.h"
#include "eval/tape.h"
#include "mesh/curve/tube.h"
#include "mesh/model/tolerances.h"
#include "meshing/clip_box.h"
#include "meshing/place_groups.h"
#include "scene/model/bind_stroke.h"
#include "scene/model/prepare.h"
#include "scene/model/strokes.h"
#include "scene/model/values.h"
#include "surface/parameter_box.h"

namespace saddle {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// The finite positions of evenly spaced points, and a box around them.
struct Extent {
  std::vector<dvec3> positions;
  Bounds bounds;
};

Extent extent_of(const ParametricCurve& curve, const std::optional<Bounds>& clip) {
  Extent extent;
  for (const CurvePoint& p : evaluate(curve, even_lines(curve.from, curve.to, kStandForAll))) {
    if (!is_finite(p.position) || (clip && !clip->contains(p.position))) continue;
    extent.positions.push_back(p.position);
    extent.bounds.add(p.position);
  }
  return extent;
}

std::string places_of(const std::vector<double>& places) {
  std::string text = "s = ";
  for (std::size_t i = 0; i < std::min(places.size(), kToldGroups); ++i) {
    text += (i > 0 ? ", " : "") + format_number(places[i]);
  }
  return text + (places.size() > kToldGroups ? " and others" : "");
}

Finding finding(Finding::Kind kind, std::string text) {
  return {kind, std::move(text), true};
}

/// `clip`: the box that saddle chose.
std::vector<Finding> findings_of(const CurveMesh& mesh, const std::optional<Bounds>& clip) {
  using Kind = Finding::Kind;
  std::vector<Finding> findings;
  const auto add_places = [&](Kind kind, const char* what, const std::vector<double>& places) {
    if (places.empty()) return;
    findings.push_back(finding(kind, what + places_of(places)));
    findings.back().place = {{places.front(), 0}, {places.back(), 0}};
  };
  if (mesh.undefined_fraction > 0) {
    const double percent = std::round(1000 * mesh.undefined_fraction) / 10;
    findings.push_back(finding(Kind::Undefined, "undefined over " + format_number(percent) +
                                                    " % of the range of s, and left out there"));
    findings.back().share = mesh.undefined_fraction;
  }
  if (mesh.reached_limit) {
    findings.push_back(
        finding(Kind::OffTolerance,
                "the limit of points stopped refinement, the curve is off by at least " +
                    format_number(mesh.max_error) + "; a smaller range of s shows more"));
    findings.back().value = mesh.max_error;
    findings.back().unit = "length";
  }
  add_places(Kind::Pole, "the curve goes to infinity and is cut there: ", mesh.poles);
  add_places(Kind::Jump, "the curve jumps and is cut there: ", mesh.jumps);
  if (clip) {
    findings.push_back(
        finding(Kind::Clipped, "clipped to the box that most of it is in; --clip off shows all"));
  }
  return findings;
}

/// The curve within a tolerance, and its tube.
class StrokeMesher {
 public:
  StrokeMesher(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
               const ParametricCurve& curve)
      : scene_(scene),
        spec_(spec),
        purpose_(purpose),
        curve_(curve),
        radius_(stroke_radius(scene, spec)) {}

  void run(MeshedCurve& result) {
    CurveMesh mesh = meshed(scene_.clip.box);
    std::optional<Bounds> chosen;
    if (scene_.clip.automatic) chosen = chosen_box(mesh);
    if (chosen) {
      CurveMesh whole = std::exchange(mesh, meshed(chosen));
      mesh.poles = std::move(whole.poles);
      mesh.undefined_fraction = whole.undefined_fraction;
    }
    if (mesh.chains.empty()) {
      throw Error(Status::Nothing, "there is nothing to draw of '" + spec_.name + "'", {},
                  "it is undefined, or clipped away, in all of its range of s");
    }
    result.mesh = radius_ > 0 ? tube_mesh(mesh, radius_, mesh.tolerance) : line_mesh(mesh);
    result.mesh.anchor = mesh.chains.front().front().position;
    result.findings = findings_of(mesh, chosen);
    mesh.chains.clear();
    result.curve = std::move(mesh);
  }

 private:
  CurveMesh meshed(const std::optional<Bounds>& clip) const {
    const Extent extent = extent_of(curve_, clip);
    CurveRequest request;
    request.clip = clip;
    request.radius = radius_;
    if (!extent.bounds.empty()) {
      Bounds bounds = extent.bounds;
      bounds.low -= dvec3(radius_);
      bounds.high += dvec3(radius_);
      const Tolerance whole = tolerance_of(scene_, spec_, purpose_, bounds, extent.positions);
      // The polygons round a tube take the other half.
      request.tolerance = radius_ > 0 ? whole.times(0.5) : whole;
    }
    return mesh_curve(curve_, request);
  }

  std::optional<Bounds> chosen_box(const CurveMesh& mesh) const {
    const Extent extent = extent_of(curve_, {});
    Bounds all = extent.bounds;
    all.add(mesh.bounds);
    if (extent.positions.empty()) return std::nullopt;
    if (mesh.poles.empty()) return readable_box(all, extent.positions);
    return clip_box(all, all, extent.positions);
  }

  const Scene& scene_;
  const SurfaceSpec& spec_;
  const Purpose& purpose_;
  const ParametricCurve& curve_;
  double radius_;
};

}  // namespace

MeshedCurve mesh_stroke_curve(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose) {
  MeshedCurve result;
  auto begin = Clock::now();
  BoundCurve bound = bind_curve(scene, scene.curves[*spec.curve]);
  result.moves = bound.moves;
  result.parse_ms = milliseconds(begin);
  begin = Clock::now();
  const ParametricCurve curve = make_curve(bound.graph, bound.r, bound.from, bound.to);
  StrokeMesher(scene, spec, purpose, curve).run(result);
  result.tessellate_ms = milliseconds(begin);
  return result;
}

dvec3 place_of_point(const Scene& scene, const SurfaceSpec& spec) {
  PointSpec point = scene.points[*spec.point];
  Scene bare = scene;
  point.radius.reset();  // the middle of a ball
  bare.points = {point};
  SurfaceSpec stand_in = spec;
  stand_in.point = 0;
  const BoundSurface bound = bind_surface(bare, stand_in);
  dvec3 place(0);
  const std::array<double, 1> zero{};
  const std::array<double*, 3> outputs = {&place.x, &place.y, &place.z};
  evaluate_points(compile(bound.graph, bound.r), zero, zero, outputs, 1);
  if (is_finite(place)) return place;
  throw Error(Status::Nothing, "the point '" + spec.name + "' is undefined", {},
              "its x, y and z must be finite numbers");
}

std::optional<dvec3> middle_of(const Surface& surface, const Mesh& mesh, const std::string& label) {
  if (label.empty()) return std::nullopt;
  const Domain& d = surface.domain;
  const dvec2 length(d.u1 - d.u0, d.v1 - d.v0);
  const auto off = [&](const dvec2& uv) { return glm::length((uv - d.at({0.5, 0.5})) / length); };
  const auto nearest = std::ranges::min_element(mesh.uv, {}, off);
  if (nearest == mesh.uv.end()) return std::nullopt;
  return mesh.position[static_cast<std::size_t>(nearest - mesh.uv.begin())];
}

Mesh dot_mesh(const dvec3& place) {
  Mesh mesh;
  mesh.position.push_back(dvec3(place));
  mesh.normal.push_back({0, 0, 1});
  mesh.uv.push_back({0, 0});
  mesh.point.push_back(0);
  mesh.point_count = 1;
  mesh.lines = {{0}};
  mesh.bounds.add(place);
  mesh.anchor = place;
  return mesh;
}

}  // namespace saddle
