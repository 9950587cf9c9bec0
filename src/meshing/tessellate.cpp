// The mesh that suits what it is for, with a uniform grid for --samples and for what has no other.
#include "meshing/tessellate.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "mesh/features/robust_box.h"
#include "mesh/features/singular_in_space.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/tolerances.h"
#include "mesh/model/topology.h"
#include "mesh/sizing/effort.h"
#include "meshing/clip_box.h"
#include "meshing/mesh_numbers.h"
#include "meshing/stretch.h"
#include "meshing/stroke_mesh.h"
#include "scene/model/strokes.h"
#include "scene/model/values.h"
#include "surface/defined_share.h"

namespace saddle {
namespace {

/// A first mesh, which finds poles or the faces of the box that they need, leaves the next mesh at
/// least a quarter of the triangles that are allowed.
constexpr std::size_t kLeastPart = 4;
/// Cells in one direction: a multiple of the intervals between grid lines, so that these are mesh
/// lines, unless there are more than cells. It is even, so that the middle of the range is one too:
/// there symmetric surfaces have their apexes, cusps and kinks. Each of kDomainParts has a cell.
int default_cells(int lines) {
  const int wanted = static_cast<int>(kDomainParts);
  const int intervals = std::lcm(std::max(lines - 1, 1), 2);
  const int rounded = (wanted + intervals - 1) / intervals * intervals;
  return rounded <= kMostGridCells ? rounded : wanted;
}

/// The grid of --samples, or the coarsest of the defaults that keeps the tolerance.
UniformRequest uniform_request(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                               unsigned threads) {
  UniformRequest request;
  const auto [u, v] = spec.grid_lines();
  const std::optional<GridSize> samples = samples_of(scene, spec);
  const GridSize cells = samples.value_or(GridSize{default_cells(u), default_cells(v)});
  request.grid = {cells.u, cells.v, u, v, threads};
  request.clip = stretched_clip_box(scene, purpose);
  if (!samples) {
    const double narrowest = least_of(purpose.stretch) / largest_of(purpose.stretch);
    request.share = tolerance_share(scene, purpose) * narrowest;
  }
  return request;
}

/// The box, open at the faces that the surface does not go through on its way to its poles, or to
/// a place nearby, as exp(1/u) does on one side of its own.
Bounds open_where_it_stays(Bounds box, const Bounds& beside_poles) {
  const dvec3 near = kFarApart * box.size();
  for (int k = 0; k < 3; ++k) {
    if (!(beside_poles.low[k] < box.low[k] - near[k])) box.low[k] = -kInfinity;
    if (!(beside_poles.high[k] > box.high[k] + near[k])) box.high[k] = kInfinity;
  }
  return box;
}

/// The tolerance of the part of a surface that is in a box, or of the whole.
auto tolerance_in(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                  const std::optional<Bounds>& box) {
  return [&scene, &spec, &purpose, box](const Probe& probe) {
    return tolerance_of(scene, spec, purpose, probe, box);
  };
}

MeshRequest first_request(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                          std::size_t max_triangles, unsigned threads) {
  MeshRequest request;
  if (const auto samples = samples_of(scene, spec)) {
    request.samples = {static_cast<std::size_t>(samples->u), static_cast<std::size_t>(samples->v)};
  }
  request.clip = stretched_clip_box(scene, purpose);
  request.tolerance = tolerance_in(scene, spec, purpose, request.clip);
  request.is_coarse_with_waves = purpose.picture && !purpose.mesh && !scene.mesh.tolerance;
  request.normal_tolerance = scene.mesh.normal_tolerance;
  if (request.normal_tolerance < kHalfTurn.high) {
    request.normal_tolerance /= rest_of_stretch(scene, purpose);
  }
  request.max_triangles = max_triangles;
  request.least_effort = least_effort(scene);
  request.lines_for = [&](const Probe& probe, const Tolerance& tolerance) {
    return lines_in_picture(scene, spec, purpose, probe, tolerance);
  };
  request.threads = threads;
  return request;
}

/// The sides of a surface's box that go beyond another box so far that they count as poles.
Bounds far_from(const Bounds& box, const Bounds& whole) {
  const double far = kNeedle * box.diagonal();
  Bounds beyond = box;
  for (int k = 0; k < 3; ++k) {
    if (whole.low[k] < box.low[k] - far) beyond.low[k] = whole.low[k];
    if (whole.high[k] > box.high[k] + far) beyond.high[k] = whole.high[k];
  }
  return beyond;
}

/// Meshes a surface until it knows the box that poles and parts out of proportion are clipped to.
class ProportionateMesher {
 public:
  ProportionateMesher(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                      const Surface& surface, std::size_t max_triangles, unsigned threads)
      : scene_(scene),
        spec_(spec),
        purpose_(purpose),
        surface_(surface),
        least_triangles_(max_triangles / kLeastPart),
        request_(first_request(scene, spec, purpose, max_triangles, threads)) {
    request_.tolerance = [this, tolerance = request_.tolerance](const Probe& probe) {
      around_ = probe.bounds();
      positions_.assign(probe.positions().begin(), probe.positions().end());
      return tolerance(probe);
    };
  }

  /// The mesh without what goes to infinity or is out of proportion, if there is any.
  std::optional<MeshResult> run() {
    if (!samples_of(scene_, spec_)) {
      request_.stop = MeshRequest::Stop::AtPolesOrFar;
      request_.far = kNeedle;
    }
    std::optional<MeshResult> mesh = next_mesh(request_);
    Bounds whole = around_;  // what a mesh follows between the samples may go much farther
    if (mesh) {
      whole.add(mesh->mesh.bounds);
      whole.add(mesh->report.beside_poles);
    }
    const std::optional<Bounds> readable = readable_box(whole, positions_);
    const auto has_poles = [&mesh] { return mesh && mesh->report.pole_count > 0; };
    if (mesh && mesh->report.stopped_early && !has_poles()) {
      // Out of proportion as far as was looked; or with a peak that no sample has met.
      if (readable) clip_to(*readable);
      request_.stop = readable ? MeshRequest::Stop::Never : MeshRequest::Stop::AtPoles;
      mesh = next_mesh(request_);
    } else if (!has_poles() && readable) {
      clip_to(*readable);
      request_.stop = MeshRequest::Stop::Never;
      if (auto clipped = try_mesh(surface_, request_)) mesh = std::move(clipped);
    }
    if (mesh) mesh->report.clip = request_.clip;
    if (!has_poles()) return mesh;
    request_.stop = MeshRequest::Stop::Never;
    return without_poles(std::move(mesh->report), whole);
  }

 private:
  /// Clips the next meshes to a box, or not at all. Their tolerance is that of the part in the box.
  void clip_to(const std::optional<Bounds>& box) {
    request_.clip = box;
    request_.tolerance = tolerance_in(scene_, spec_, purpose_, box);
  }

  /// A mesh whose triangles are deducted from those that the next mesh of the request may have. A
  /// number that the user gave stays.
  std::optional<MeshResult> next_mesh(MeshRequest& request) const {
    std::optional<MeshResult> mesh = try_mesh(surface_, request);
    if (mesh && !scene_.mesh.max_triangles) {
      const std::size_t taken = mesh->report.effort / kPlacesPerTriangle;
      request.max_triangles = std::max(request.max_triangles, least_triangles_ + taken) - taken;
    }
    return mesh;
  }

  /// The mesh of a surface that goes to infinity. `known`: the report of a mesh that was not
  /// clipped; `whole`: a box around all that was seen of the surface.
  std::optional<MeshResult> without_poles(MeshReport known, const Bounds& whole) {
    const std::vector<dvec3> balanced = balanced_positions(surface_, request_.threads);
    // The probe knows more about a small part of a surface.
    const auto& more = balanced.size() > positions_.size() ? balanced : positions_;
    // Rounding may leave places on an edge of the domain anywhere beside a pole.
    const Bounds box = clip_box(around_, bounds_of(positions_), more);
    known.beside_poles.add(far_from(box, whole));
    clip_to(box);
    if (auto mesh = mesh_clipped(known, box)) return mesh;
    clip_to(std::nullopt);
    return try_mesh(surface_, request_);
  }

  /// The mesh within the faces of the box that the surface goes through on its way to its poles.
  std::optional<MeshResult> mesh_clipped(const MeshReport& known, const Bounds& box) const {
    Bounds beside_poles = known.beside_poles;
    MeshRequest request = request_;
    std::optional<MeshResult> mesh;
    request.needs_other_box = [&](Bounds seen) {
      seen.add(beside_poles);
      return open_where_it_stays(box, seen) != *request.clip;
    };
    // Poles may need more faces each time, of six in all.
    do {
      request.clip = open_where_it_stays(box, beside_poles);
      mesh = next_mesh(request);
      if (!mesh) return std::nullopt;
      beside_poles.add(mesh->report.beside_poles);
    } while (request.needs_other_box(beside_poles));
    mesh->report.clip = request.clip;
    // Cells outside of the box are not looked at any more.
    if (known.pole_count > mesh->report.pole_count) {
      mesh->report.poles = known.poles;
      mesh->report.pole_count = known.pole_count;
      mesh->report.pole_lines = known.pole_lines;
    }
    return mesh;
  }

  const Scene& scene_;
  const SurfaceSpec& spec_;
  const Purpose& purpose_;
  const Surface& surface_;
  std::size_t least_triangles_;  ///< of the last mesh, whatever the first ones take
  MeshRequest request_;
  // Where the whole surface is, by samples that are spread over it.
  Bounds around_;
  std::vector<dvec3> positions_;
};

/// The mesh that --samples asks for, or the best one that keeps the tolerance.
MeshResult mesh_as_asked(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                         const Surface& surface, unsigned threads) {
  const UniformRequest fallback = uniform_request(scene, spec, purpose, threads);
  const auto [triangles, points] = mesh_allowance(scene, spec, surface);
  if (!samples_of(scene, spec)) surface.tangents.count->allow(points);
  if (!scene.clip.automatic) {
    return make_mesh(surface, first_request(scene, spec, purpose, triangles, threads), fallback);
  }
  auto mesh = ProportionateMesher(scene, spec, purpose, surface, triangles, threads).run();
  return mesh ? std::move(*mesh) : mesh_uniformly(surface, fallback);
}

/// The mesh of a surface that is stretched along its axes while it is meshed.
MeshResult mesh_stretched(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                          unsigned threads) {
  const PreparedSurface prepared = prepare_surface(scene, spec, Order::Second, purpose.stretch);
  MeshResult mesh = mesh_as_asked(scene, spec, purpose, prepared.surface, threads);
  take_back_stretch(purpose.stretch, mesh);
  mesh.report.max_normal_error *= rest_of_stretch(scene, purpose);
  mesh.report.evaluations = prepared.surface.evaluations();
  return mesh;
}

/// Puts the user's (u, v) in place of the surface's parameters wherever a place is named. Returns
/// the domain in them; the box around the mesh's where v depends on u.
Domain name_parameters(const Surface& surface, MeshResult& mesh) {
  if (surface.v.outputs.empty()) return surface.domain;
  MeshReport& report = mesh.report;
  take_user_parameters(surface, mesh.mesh.uv);
  for (auto* const places : {&report.poles, &report.jumps, &report.without_limit})
    take_user_parameters(surface, *places);
  report.pole_lines.v.clear();  // where v was constant it is not any more
  report.jump_lines.v.clear();
  for (ProofGap& place : report.proof_gaps) {
    std::array<dvec2, 4> corners = {
        place.low, {place.high.x, place.low.y}, place.high, {place.low.x, place.high.y}};
    take_user_parameters(surface, corners);
    take_user_parameters(surface, std::span(&place.worst, 1));
    place.low = place.high = corners[0];
    for (const dvec2& corner : corners) {
      place.low = glm::min(place.low, corner);
      place.high = glm::max(place.high, corner);
    }
  }
  for (auto* const place : {&report.coarse_normals, &report.worst_place, &report.oscillates}) {
    if (*place) take_user_parameters(surface, std::span(&**place, 1));
  }
  for (SingularPoint& point : report.singular_points)
    take_user_parameters(surface, std::span(&point.uv, 1));
  for (SingularInSpace& point : report.singular_in_space)
    take_user_parameters(surface, std::span(&point.uv, 1));
  double low = kInfinity;
  double high = -low;
  for (const dvec2& uv : mesh.mesh.uv) {
    low = std::min(low, uv.y);
    high = std::max(high, uv.y);
  }
  return {surface.domain.u0, surface.domain.u1, low, high, surface.domain.names};
}

}  // namespace

MeshedSurface mesh_surface(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                           unsigned threads) {
  MeshedSurface result;
  result.prepared = prepare_surface(scene, spec, Order::Second);
  const Surface& surface = result.prepared.surface;
  const auto begin = std::chrono::steady_clock::now();
  Purpose as_drawn = purpose;
  as_drawn.stretch = mesh_stretch(scene, spec, purpose);
  const bool is_stretched = as_drawn.stretch != dvec3(1);
  try {
    result.mesh = is_stretched ? mesh_stretched(scene, spec, as_drawn, threads)
                               : mesh_as_asked(scene, spec, purpose, surface, threads);
  } catch (const Error& error) {
    const bool is_empty = error.status() == Status::Nothing && !surface.region.outputs.empty() &&
                          region_share(surface, threads).outside == 1;
    if (!is_empty) throw;
    throw Error(Status::Nothing, "no part of the surface is where this holds",
                {"where", spec.where, {0, spec.where.size()}}, "leave it out, or widen the ranges");
  }
  Mesh& mesh = result.mesh.mesh;
  MeshReport& report = result.mesh.report;
  if (report.reached_limit && report.shortage == Shortage::None)
    report.shortage = shortage_of_triangles(scene, spec);
  report.orientable = is_orientable(mesh, report);
  report.singular_in_space = singular_in_space(surface, mesh, report);
  if (!surface.region.outputs.empty()) report.region = region_share(surface, threads);
  if (report.unexpected_fraction() > 0) report.exceeds_doubles = exceeds_doubles(surface, threads);
  const bool is_off = report.tolerance && report.max_error > *report.tolerance;
  if (report.certified && is_off && report.worst_place)
    report.proof_gaps.push_back({{GapReason::Off, *report.worst_place, *report.worst_place}});
  report.certified = report.certified && !is_off;  // the proof allows 4 tolerances
  if (!report.certified && report.proof_gaps.empty()) {
    const Domain& d = surface.domain;
    const GapReason why = is_off ? GapReason::Off : GapReason::NotTried;
    report.proof_gaps.push_back({{why, {d.u0, d.v0}, {d.u1, d.v1}}, 1});
  }
  if (thickness_of(scene, spec)) result.bends = sharpest_bends(surface, mesh, threads);
  if (!spec.color.empty())
    result.color = color_as_asked(scene, spec, purpose, surface, result.mesh, threads);
  result.contours = contour_as_asked(scene, spec, purpose, result.prepared, result.mesh, threads);
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
  report.evaluations = surface.evaluations() + (is_stretched ? report.evaluations : 0);
  result.tessellate_ms = passed.count();
  result.is_clipped = scene.clip.box || report.clip;
  result.shares_limits = shares_limits(scene);
  if (result.is_clipped) report.least_triangles = 0;  // it is of the whole
  return result;
}

Tessellation tessellation_of(const SurfaceSpec& spec, MeshedSurface meshed) {
  MeshResult& mesh = meshed.mesh;
  Tessellation result;
  result.moves = meshed.prepared.moves;
  result.parse_ms = meshed.prepared.parse_ms;
  result.compile_ms = meshed.prepared.compile_ms;
  result.tessellate_ms = meshed.tessellate_ms;
  result.bends = meshed.bends;
  result.domain = name_parameters(meshed.prepared.surface, mesh);
  result.findings = mesh_findings(mesh, result.domain, meshed.shares_limits);
  if (meshed.color) {
    std::ranges::move(color_findings(mesh.mesh, *meshed.color),
                      std::back_inserter(result.findings));
  }
  std::ranges::move(contour_findings(spec, meshed.contours), std::back_inserter(result.findings));
  result.warnings = warnings_of(spec.name, result.findings);
  result.report = std::move(mesh.report);
  result.mesh = std::move(mesh.mesh);
  return result;
}

namespace {

Tessellation tessellate_curve(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose) {
  MeshedCurve meshed = mesh_stroke_curve(scene, spec, purpose);
  Tessellation result;
  result.mesh = std::move(meshed.mesh);
  result.findings = std::move(meshed.findings);
  result.warnings = warnings_of(spec.name, result.findings);
  result.curve = std::move(meshed.curve);
  result.moves = meshed.moves;
  result.parse_ms = meshed.parse_ms;
  result.tessellate_ms = meshed.tessellate_ms;
  return result;
}

Tessellation tessellate_dot(const Scene& scene, const SurfaceSpec& spec) {
  Tessellation result;
  result.place = place_of_point(scene, spec);
  result.mesh = dot_mesh(*result.place);
  result.moves = bind_surface(scene, spec).moves;
  return result;
}

}  // namespace

Tessellation tessellate(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                        unsigned threads) {
  if (spec.curve) return tessellate_curve(scene, spec, purpose);
  if (spec.point && stroke_radius(scene, spec) == 0) return tessellate_dot(scene, spec);
  const auto place = spec.point ? std::optional(place_of_point(scene, spec)) : std::nullopt;
  MeshedSurface meshed = mesh_surface(scene, spec, purpose, threads);
  const std::optional<dvec3> anchor =
      place ? place : middle_of(meshed.prepared.surface, meshed.mesh.mesh, spec.label);
  Tessellation result = tessellation_of(spec, std::move(meshed));
  result.mesh.anchor = anchor;
  result.place = place;
  return result;
}

}  // namespace saddle
