#include "mesh/mesher/sampled_mesh.h"

#include <algorithm>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/model/tolerances.h"
#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Larger grids of smooth surfaces are not validated cell by cell: that takes 20 times as long as
/// to make them.
constexpr std::size_t kMostValidated = 65'536;
/// The budget of boxes for the proof that a surface is smooth; most take a few.
constexpr std::size_t kBoxes = 1024;

/// Whether interval bounds prove position and tangents to be defined and continuous.
bool is_smooth(const Surface& surface) {
  SurfaceEnclosure enclosure(surface, Bounded::Tangents);
  const auto search =
      subdivide(box_of(surface.domain), {.boxes = kBoxes}, [&](const ParameterBox& box) {
        return are_continuous(enclosure.enclose(box)) ? ProofOutcome::Proved : ProofOutcome::Open;
      });
  return search.open().empty();
}

}  // namespace

std::optional<MeshResult> mesh_of_samples(const Surface& surface, const MeshRequest& request) {
  const auto [cells_u, cells_v] = request.samples.value();
  std::optional<MeshPlan> plan = plan_mesh(surface, request);
  if (!plan || std::max(cells_u, cells_v) > kMostCellsEachWay) return std::nullopt;
  if (cells_u * cells_v > kMostValidated && !request.clip && is_smooth(surface)) {
    MeshResult mesh = mesh_on_grid(surface, {static_cast<int>(cells_u), static_cast<int>(cells_v),
                                             request.lines_u, request.lines_v, request.threads});
    name_singular(plan->singular, surface.domain, mesh.report);
    return mesh;
  }
  const Domain& d = surface.domain;
  plan->lines = {even_lines(d.u0, d.u1, cells_u), even_lines(d.v0, d.v1, cells_v)};
  std::optional<MeshResult> mesh = mesh_within_tolerance(surface, request, std::move(*plan));
  if (mesh) {
    mesh->report.tolerance.reset();
    mesh->report.least_triangles = 0;
    mesh->report.coarse_normals.reset();
  }
  return mesh;
}

}  // namespace saddle
