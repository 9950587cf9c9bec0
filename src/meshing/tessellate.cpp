// The mesh that suits what it is for, with a uniform grid for --samples and for what has no other.
#include "meshing/tessellate.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "mesh/color/color_mesh.h"
#include "mesh/features/robust_box.h"
#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/mesher/choose.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/mesher/sampled_mesh.h"
#include "mesh/model/clip.h"
#include "mesh/model/tidy.h"
#include "mesh/model/topology.h"
#include "mesh/sizing/effort.h"
#include "meshing/clip_box.h"
#include "meshing/warnings.h"
#include "surface/defined_share.h"

namespace saddle {
namespace {

/// Without --samples a cell is about this large in the picture to begin with: for most surfaces of
/// the gallery that is within kPictureTolerance, and the grid is halved until it is.
constexpr int kPixelsPerCell = 8;
/// The error of a smooth surface falls to a quarter when cells are halved; where it does not fall
/// to this share, at a kink or the edge of a hole, finer cells do not help.
constexpr double kWorthHalving = 0.5;
/// A coarse grid may miss most of a wave, and so of its own error: one halving proves nothing.
constexpr int kHalvingsInVain = 2;
/// At most this many cells each way: two million triangles.
constexpr int kMaxDefaultCells = 1000;

/// Triangles at most; and where no tolerance is asked for, unless the picture has more pixels. Each
/// takes 3 to 7 microseconds and 1 kB.
constexpr std::size_t kMostTriangles = 4'000'000;
constexpr std::size_t kEnoughTriangles = 1'000'000;
/// A first mesh, which finds poles or the faces of the box that they need, leaves the next mesh at
/// least this share of the triangles that are allowed.
constexpr double kLeastShare = 0.25;
/// Boxes that a surface with poles is clipped to before its poles show all the faces that it needs.
constexpr int kMostBoxes = 3;
/// AdaptiveOptions::until_far: poles alone.
constexpr double kAnywhere = std::numeric_limits<double>::infinity();

/// Cells in one direction: a multiple of the intervals between grid lines, so that grid lines are
/// mesh lines, unless there are more of them than cells. An even one, so that the middle of the
/// range is a mesh line too: there symmetric surfaces have their apexes, cusps and kinks.
int default_cells(int larger_side, int lines) {
  const int wanted =
      std::min((larger_side + kPixelsPerCell - 1) / kPixelsPerCell, kMaxDefaultCells);
  const int intervals = std::lcm(std::max(lines - 1, 1), 2);
  const int rounded = (wanted + intervals - 1) / intervals * intervals;
  return rounded <= kMaxDefaultCells ? rounded : wanted;
}

GridOptions first_grid(const Scene& scene, const SurfaceSpec& spec, unsigned threads) {
  const int larger_side = std::max(scene.picture.width, scene.picture.height);
  GridOptions options;
  options.lines_u = spec.grid_u;
  options.lines_v = spec.grid_v;
  options.cells_u =
      scene.mesh.samples ? scene.mesh.samples->u : default_cells(larger_side, spec.grid_u);
  options.cells_v =
      scene.mesh.samples ? scene.mesh.samples->v : default_cells(larger_side, spec.grid_v);
  options.threads = threads;
  return options;
}

/// The grid that --samples asks for, or the coarsest of the defaults that keeps the tolerance.
MeshResult mesh_uniformly(const Scene& scene, const SurfaceSpec& spec, const Surface& surface,
                          double tolerance, unsigned threads) {
  GridOptions options = first_grid(scene, spec, threads);
  MeshResult result = mesh_on_grid(surface, options);
  int stagnation = 0;  // halvings in a row
  while (!scene.mesh.samples && stagnation < kHalvingsInVain &&
         result.report.max_error > tolerance * result.mesh.bounds.diagonal() &&
         2 * std::max(options.cells_u, options.cells_v) <= kMaxDefaultCells) {
    options.cells_u *= 2;
    options.cells_v *= 2;
    MeshResult finer = mesh_on_grid(surface, options);
    finer.report.evaluations += result.report.evaluations;
    const bool helped = finer.report.max_error <= kWorthHalving * result.report.max_error;
    result = std::move(finer);
    stagnation = helped ? 0 : stagnation + 1;
  }
  return result;
}

/// The box, open at the faces that the surface does not go through on its way to its poles, or to
/// a place nearby, as exp(1/u) does on one side of its own.
Bounds open_where_it_stays(Bounds box, const Bounds& beside_poles) {
  constexpr double kNearby = 0.25;  // of the box: even ln goes twice as far as one on its way
  const dvec3 near = kNearby * box.size();
  for (int k = 0; k < 3; ++k) {
    if (!(beside_poles.low[k] < box.low[k] - near[k])) box.low[k] = -kNoFace;
    if (!(beside_poles.high[k] > box.high[k] + near[k])) box.high[k] = kNoFace;
  }
  return box;
}

/// A picture's mesh is the one that costs least; a file's has the fewest triangles, and what is
/// told of a surface is told of that.
std::optional<MeshResult> mesh_for(const Scene& scene, const Purpose& purpose,
                                   const Surface& surface, const AdaptiveOptions& options) {
  if (const auto& samples = scene.mesh.samples) {
    return mesh_of_samples(surface, options, static_cast<std::size_t>(samples->u),
                           static_cast<std::size_t>(samples->v));
  }
  const auto times = static_cast<double>(std::max<std::size_t>(purpose.moments.size(), 1));
  if (!purpose.mesh) return mesh_at_least_cost(surface, options, times);
  auto mesh = mesh_within_tolerance(surface, options);
  if (mesh) mesh->report.choice = MeshChoice();
  return mesh;
}

/// Deducts what a mesh took from the triangles that the next mesh of the run may have. A number
/// that the user gave stays.
void deduct_triangles(const Scene& scene, const std::optional<MeshResult>& made,
                      AdaptiveOptions& options) {
  if (!made || scene.mesh.max_triangles) return;
  const auto least =
      static_cast<std::size_t>(kLeastShare * static_cast<double>(most_triangles(scene)));
  const std::size_t taken = made->report.effort / kPlacesPerTriangle;
  options.max_triangles = std::max(options.max_triangles, least + taken) - taken;
}

/// The mesh of a surface that goes to infinity, clipped, if there is any. `known`: what is known of
/// its poles; `options.clip`: the box that everything else is in.
std::optional<MeshResult> mesh_clipped(const MeshReport& known, const Scene& scene,
                                       const Purpose& purpose, const Surface& surface,
                                       AdaptiveOptions options) {
  // Only where its poles are tells that it needs the box, and in which coordinates.
  const Bounds box = *options.clip;
  Bounds beside_poles = known.beside_poles;
  std::optional<MeshResult> mesh;
  for (int k = 0; k < kMostBoxes; ++k) {
    options.clip = open_where_it_stays(box, beside_poles);
    mesh = mesh_for(scene, purpose, surface, options);
    if (!mesh) return std::nullopt;
    mesh->report.clip = options.clip;
    beside_poles.add(mesh->report.beside_poles);
    if (open_where_it_stays(box, beside_poles) == *options.clip) break;
    deduct_triangles(scene, mesh, options);
  }
  // Cells outside of the box are not looked at any more.
  if (known.pole_count > mesh->report.pole_count) {
    mesh->report.poles = known.poles;
    mesh->report.pole_count = known.pole_count;
  }
  return mesh;
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

/// Where a surface is, by samples that are spread over it.
struct Whereabouts {
  Bounds around;
  std::vector<dvec3> positions;
};

/// The mesh of a surface, if there is one, without the parts that go to infinity or are out of
/// proportion. `options.tolerance` fills in `known` as long as `options.clip` is not set.
std::optional<MeshResult> mesh_in_proportion(const Scene& scene, const Purpose& purpose,
                                             const Surface& surface, const Whereabouts& known,
                                             AdaptiveOptions& options) {
  if (!scene.mesh.samples) options.until_far = kNeedle;
  auto mesh = mesh_for(scene, purpose, surface, options);
  deduct_triangles(scene, mesh, options);
  Bounds whole = known.around;  // what a mesh follows between the samples may go much farther
  if (mesh) {
    whole.add(mesh->mesh.bounds);
    whole.add(mesh->report.beside_poles);
  }
  const std::optional<Bounds> readable = readable_box(whole, known.positions);
  const auto has_poles = [&mesh] { return mesh && mesh->report.pole_count > 0; };
  if (mesh && mesh->mesh.triangles.empty() && !has_poles()) {
    // The surface is out of proportion as far as it was sampled, or has a peak that no sample met.
    options.clip = readable;
    options.until_far = readable ? std::nullopt : std::optional(kAnywhere);
    mesh = mesh_for(scene, purpose, surface, options);
    deduct_triangles(scene, mesh, options);
  } else if (!has_poles() && readable) {
    options.clip = readable;
    options.until_far = std::nullopt;
    if (auto clipped = mesh_for(scene, purpose, surface, options)) mesh = std::move(clipped);
  }
  if (mesh) mesh->report.clip = options.clip;
  if (!has_poles()) return mesh;

  options.until_far = std::nullopt;
  MeshReport report = std::move(mesh->report);
  const std::vector<dvec3> balanced = balanced_positions(surface, options.threads);
  // The probe has more samples of a small part of a surface.
  const bool knows_more = balanced.size() > known.positions.size();
  options.clip = clip_box(known.around, knows_more ? balanced : known.positions);
  report.beside_poles.add(far_from(*options.clip, whole));
  mesh = mesh_clipped(report, scene, purpose, surface, options);
  if (mesh) return mesh;
  options.clip = std::nullopt;
  return mesh_for(scene, purpose, surface, options);
}

/// The mesh that --samples asks for, or the best one that keeps the tolerance.
MeshResult mesh_as_asked(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                         const Surface& surface, unsigned threads) {
  AdaptiveOptions options;
  options.clip = scene.clip.box;
  Whereabouts known;
  options.tolerance = [&](const Probe& probe) {
    const std::optional<Bounds>& clip = options.clip;
    if (!clip) known = {probe.bounds(), probe.positions()};
    return tolerance_of(scene, spec, purpose, probe, clip);
  };
  options.normal_tolerance = scene.mesh.normal_tolerance;
  options.max_triangles = most_triangles(scene);
  options.lines_u = spec.grid_u;
  options.lines_v = spec.grid_v;
  options.threads = threads;
  auto mesh = scene.clip.automatic ? mesh_in_proportion(scene, purpose, surface, known, options)
                                   : mesh_for(scene, purpose, surface, options);
  if (mesh) return std::move(*mesh);
  const double share = tolerance_share(scene, purpose);
  MeshResult grid = mesh_uniformly(scene, spec, surface, share, threads);
  if (scene.clip.box) {
    clip_mesh(*scene.clip.box, grid.mesh);
    grid.report.is_clipped = true;
    keep_used_corners(grid.mesh);
  }
  if (!scene.mesh.samples) grid.report.tolerance = share * grid.mesh.bounds.diagonal();
  return grid;
}

/// Without a tolerance, as of a uniform grid, edges of this share of the diagonal are short enough
/// for colours: a pixel or less of a picture.
constexpr double kLeastEdge = 1.0 / 2048;
/// Curvatures are the same if they differ by less than this share of the curvature of a sphere
/// around the surface.
constexpr double kFlat = 1e-9;

ColorReport color_as_asked(const Scene& scene, const SurfaceSpec& spec, const Surface& surface,
                           MeshResult& mesh, unsigned threads) {
  const double diagonal = mesh.mesh.bounds.diagonal();
  ColorOptions options;
  options.least_edge = mesh.report.tolerance.value_or(kLeastEdge * diagonal);
  if (spec.color == "mean") options.rounding = kFlat / diagonal;
  if (spec.color == "gauss") options.rounding = kFlat / (diagonal * diagonal);
  options.range = spec.color_range;
  options.clip = scene.clip.box ? scene.clip.box : mesh.report.clip;
  options.max_triangles = most_triangles(scene);
  options.threads = threads;
  const ColorReport report = color_mesh(surface, options, mesh.mesh);
  mesh.report.evaluations += report.evaluations;
  return report;
}

/// Puts the user's (u, v) in place of the surface's parameters wherever a place is named. Returns
/// the domain in them; the box around the mesh's where v depends on u.
Domain name_parameters(const Surface& surface, MeshResult& mesh) {
  if (surface.v.outputs.empty()) return surface.domain;
  MeshReport& report = mesh.report;
  take_user_parameters(surface, mesh.mesh.uv);
  take_user_parameters(surface, report.poles);
  take_user_parameters(surface, report.jumps);
  take_user_parameters(surface, report.without_limit);
  for (ProofGap& place : report.proof_gaps) {
    std::array<dvec2, 4> corners = {
        place.low, {place.high.x, place.low.y}, place.high, {place.low.x, place.high.y}};
    take_user_parameters(surface, corners);
    place.low = place.high = corners[0];
    for (const dvec2& corner : corners) {
      place.low = glm::min(place.low, corner);
      place.high = glm::max(place.high, corner);
    }
  }
  for (auto* const place : {&report.coarse_normals, &report.worst_place, &report.oscillates}) {
    if (*place) take_user_parameters(surface, std::span(&**place, 1));
  }
  for (SingularPoint& point : report.singular_points) {
    take_user_parameters(surface, std::span(&point.uv, 1));
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const dvec2& uv : mesh.mesh.uv) {
    low = std::min(low, uv.y);
    high = std::max(high, uv.y);
  }
  return {surface.domain.u0, surface.domain.u1, low, high};
}

}  // namespace

std::size_t most_triangles(const Scene& scene) {
  if (scene.mesh.max_triangles) return static_cast<std::size_t>(*scene.mesh.max_triangles);
  if (scene.mesh.tolerance || scene.mesh.samples) return kMostTriangles;
  const auto pixels = static_cast<std::size_t>(scene.picture.width) *
                      static_cast<std::size_t>(scene.picture.height);
  return std::clamp(pixels, kEnoughTriangles, kMostTriangles);
}

MeshedSurface mesh_surface(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                           unsigned threads) {
  MeshedSurface result;
  result.prepared = prepare_surface(scene, spec, Order::Second);
  const Surface& surface = result.prepared.surface;
  const auto begin = std::chrono::steady_clock::now();
  result.mesh = mesh_as_asked(scene, spec, purpose, surface, threads);
  Mesh& mesh = result.mesh.mesh;
  MeshReport& report = result.mesh.report;
  report.orientable = is_orientable(mesh, report);
  if (report.undefined_fraction > 0) report.exceeds_doubles = exceeds_doubles(surface, threads);
  if (!report.certified && report.proof_gaps.empty()) {
    const Domain& d = surface.domain;
    report.proof_gaps.push_back({GapReason::NotTried, {d.u0, d.v0}, {d.u1, d.v1}});
  }
  if (!spec.color.empty()) {
    result.color = color_as_asked(scene, spec, surface, result.mesh, threads);
  }
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
  result.tessellate_ms = passed.count();
  result.is_clipped = scene.clip.box || report.clip;
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
  result.domain = name_parameters(meshed.prepared.surface, mesh);
  result.warnings = mesh_warnings(spec.name, mesh, result.domain);
  if (meshed.color) {
    for (std::string& warning : color_warnings(spec.name, mesh.mesh, *meshed.color)) {
      result.warnings.push_back(std::move(warning));
    }
  }
  result.report = std::move(mesh.report);
  result.mesh = std::move(mesh.mesh);
  return result;
}

Tessellation tessellate(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                        unsigned threads) {
  return tessellation_of(spec, mesh_surface(scene, spec, purpose, threads));
}

}  // namespace saddle
