#include "mesh/mesher/grid_within.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "mesh/distance/measure_boxes.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/error/check_cells.h"
#include "mesh/grid/cut_grid.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/proof/certify.h"
#include "mesh/proof/report_proof.h"
#include "mesh/sizing/effort.h"

namespace saddle {
namespace {

/// Indices of the grid's lines that are drawn.
std::vector<std::size_t> indices_of(std::span<const double> drawn, std::span<const double> lines) {
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (std::ranges::find(drawn, lines[k]) != drawn.end()) indices.push_back(k);
  }
  return indices;
}

std::vector<std::uint8_t> marks(std::span<const std::size_t> indices, std::size_t count) {
  std::vector<std::uint8_t> marks(count, 0);
  for (const std::size_t k : indices) marks[k] = 1;
  return marks;
}

/// Whether the edges of the grid join as the probe's do, and fold at vertices only.
bool is_joined_alike(const Seams& seams, const MeshReport& report, const Grid& grid) {
  const auto turns_at_vertex = [](const std::array<bool, 2>& folded, std::size_t cells) {
    return !(folded[0] || folded[1]) || cells % 2 == 0;
  };
  return report.closed_u.empty() != seams.u.closed && report.closed_v.empty() != seams.v.closed &&
         report.folded_u == seams.folded_u && report.folded_v == seams.folded_v &&
         turns_at_vertex(seams.folded_u, grid.cells_v) &&
         turns_at_vertex(seams.folded_v, grid.cells_u);
}

/// Whether every opened cell has a side that is a single point.
bool has_poles_only(const Grid& grid, std::span<const std::size_t> opened) {
  const auto& point = grid.mesh.point;
  return std::ranges::all_of(opened, [&](std::size_t cell) {
    const auto vertices = grid.vertices(cell);
    for (std::size_t k = 0; k < 4; ++k) {
      if (point[vertices[k]] == point[vertices[(k + 1) % 4]]) return true;
    }
    return false;
  });
}

/// Whether the surface may be undefined or jump in a gap; no triangle may lie across.
bool may_be_broken(const ProofGap& place) {
  return place.why == GapReason::Undefined || place.why == GapReason::Discontinuous;
}

std::vector<Patch> cells_as_patches(const Grid& grid, double allowed) {
  std::vector<Patch> patches;
  patches.reserve(grid.cell_count());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto vertices = grid.vertices(cell);
    patches.push_back({{grid.uv(vertices[0]), grid.uv(vertices[2])}, allowed, cell, {}});
    patches.back().is_measured = grid.triangle_count(cell) != 2;
  }
  return patches;
}

std::vector<Triangle> all_triangles(const Grid& grid) {
  std::vector<Triangle> all;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto triangles = grid.triangles(cell);
    all.insert(all.end(), triangles.begin(), triangles.end());
  }
  return all;
}

/// Whether interval bounds refute the mesh: it may be broken, or an unproved box is farther away
/// than allowed. Fills in the report's proof gaps.
bool exceeds_tolerance(const Surface& surface, const Tolerance& aim, unsigned threads,
                       std::size_t samples, Grid& grid, MeshReport& report) {
  const std::vector<Patch> patches = cells_as_patches(grid, aim(grid.mesh.bounds.centre()));
  ProofBudget budget(surface.bounds);
  Effort effort(surface);
  effort.add_samples(samples);
  budget.allow_for(effort.total());
  BoxMeasure measure(surface, grid, patches,
                     {[&](std::size_t cell) { return grid.triangles(cell); },
                      [&] { return NearestTriangles(grid, all_triangles(grid)); }},
                     std::nullopt, threads);
  Certification proof =
      certify(surface, {grid.u, grid.v}, patches, std::nullopt, std::ref(measure), budget);
  report.work.boxes = budget.boxes();
  // A jump along the surface, as within a plane, shows in no distance.
  if (!measure.found().empty() || std::ranges::any_of(proof.proof_gaps, may_be_broken)) return true;
  std::vector<dvec2> uv;
  for (const UnprovedBox& box : proof.unproved_boxes) uv.push_back(box.middle);
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t cell = proof.unproved_boxes[k].patch;
    const double distance = distance_from(grid, grid.triangles(cell), uv[k], points[k].position);
    if (!(distance <= patches[cell].allowed)) return true;
    report.max_error = std::max(report.max_error, distance);
  }
  KnownHulls hulls(surface);
  report_proof(surface, proved_cells(patches, surface.domain), threads, hulls, proof, report);
  return false;
}

}  // namespace

GridTrial try_grid(const Surface& surface, const MeshRequest& request, const MeshPlan& plan,
                   FixedLines lines) {
  GridTrial trial;
  MeshResult result{{}, report_of(plan)};
  MeshReport& report = result.report;
  const std::vector<std::size_t> columns = indices_of(plan.drawn.u, lines.u);
  const std::vector<std::size_t> rows = indices_of(plan.drawn.v, lines.v);
  Grid grid = sample_grid(surface, std::move(lines.u), std::move(lines.v), request.threads);
  trial.work.grid_samples = grid.vertex_count();
  if (grid.left_out_count > 0) return trial;
  const std::vector<std::size_t> opened = cut_grid(surface, request.threads, grid, report);
  if (!is_joined_alike(plan.probe.seams(), report, grid) || !has_poles_only(grid, opened))
    return trial;

  const SeenLines seen{marks(columns, grid.u.size()), marks(rows, grid.v.size())};
  const MeasuredError error = check_cells(surface, grid, seen, request.threads);
  trial.work.grid_samples += error.evaluations;
  report.max_error = std::max(report.rounding.value_or(0), error.distance);
  report.max_normal_error = error.normal_degrees;
  const double turn = error.normal_degrees / request.normal_tolerance;
  const double excess = std::max(error.distance / plan.aim(grid.mesh.bounds.centre()), turn * turn);
  if (!(excess <= 1)) {
    trial.excess = excess;
    return trial;
  }
  const bool is_refuted =
      request.certify &&
      exceeds_tolerance(surface, plan.aim, request.threads, trial.work.grid_samples, grid, report);
  trial.work.boxes = report.work.boxes;
  if (is_refuted) return trial;
  name_singular(plan.singular, surface.domain, report);
  report.cells = grid.cell_count();
  report.work = trial.work;
  const auto none = std::vector<std::size_t>();
  result.mesh = finish_grid(std::move(grid), opened.empty(), request.lines_u > 1 ? columns : none,
                            request.lines_v > 1 ? rows : none);
  trial.mesh = std::move(result);
  return trial;
}

}  // namespace saddle
