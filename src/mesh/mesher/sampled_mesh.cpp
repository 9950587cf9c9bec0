#include "mesh/mesher/sampled_mesh.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "base/error.h"
#include "base/format.h"
#include "mesh/grid/grid.h"
#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/proof_budget.h"
#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Larger grids of smooth surfaces are not validated cell by cell: that takes 20 times as long as
/// to make them.
constexpr std::size_t kMostValidated = 65'536;

/// Whether interval bounds prove position and tangents to be defined and continuous.
bool is_smooth(const Surface& surface) {
  SurfaceEnclosure enclosure(surface, Bounded::Tangents);
  const std::size_t boxes = ProofBudget(surface.bounds).boxes_of_search();
  const auto search =
      subdivide(box_of(surface.domain), {.boxes = boxes}, [&](const ParameterBox& box) {
        return are_continuous(enclosure.enclose(box)) ? ProofOutcome::Proved : ProofOutcome::Open;
      });
  return search.open().empty();
}

/// A place at which bounds found the surface to be defined.
std::optional<dvec2> defined_place(const Surface& surface, const Probe& probe) {
  const std::vector<Landmark>& places = probe.landmarks().places;
  const auto found = std::ranges::find_if_not(places, &Landmark::is_hole);
  if (found == places.end()) return std::nullopt;
  dvec2 uv = found->uv;
  take_user_parameters(surface, std::span(&uv, 1));
  return uv;
}

}  // namespace

std::optional<MeshResult> mesh_of_samples(const Surface& surface, const MeshRequest& request) {
  const auto [cells_u, cells_v] = request.samples.value();
  std::optional<MeshPlan> plan = plan_mesh(surface, request);
  if (!plan || std::max(cells_u, cells_v) > kMostCellsEachWay) return std::nullopt;
  if (cells_u * cells_v > kMostValidated && !request.clip && is_smooth(surface)) {
    MeshResult mesh =
        mesh_on_grid(surface, {static_cast<int>(cells_u), static_cast<int>(cells_v),
                               plan->line_counts.u, plan->line_counts.v, request.threads});
    name_singular(plan->singular, surface.domain, mesh.report);
    return mesh;
  }
  const Domain& d = surface.domain;
  plan->lines = {even_lines(d.u0, d.u1, cells_u), even_lines(d.v0, d.v1, cells_v)};
  const std::optional<dvec2> defined = defined_place(surface, plan->probe);
  std::optional<MeshResult> mesh = mesh_within_tolerance(surface, request, std::move(*plan));
  if (!mesh && defined) {
    throw Error(Status::Nothing, "the surface is defined only between the samples", {},
                formatted("it is near %s = %.4g, %s = %.4g: --samples takes more, and without it "
                          "cells are as small there as they need to be",
                          d.names[0].c_str(), defined->x, d.names[1].c_str(), defined->y));
  }
  if (mesh) {
    mesh->report.tolerance.reset();
    mesh->report.least_triangles = 0;
    mesh->report.coarse_normals.reset();
  }
  return mesh;
}

}  // namespace saddle
