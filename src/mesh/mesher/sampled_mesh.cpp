#include "mesh/mesher/sampled_mesh.h"

#include <algorithm>
#include <array>
#include <vector>

#include "eval/enclose.h"
#include "mesh/grid/grid.h"
#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/model/parameter_box.h"

namespace saddle {

namespace {

/// Boxes that a proof may take: of what is smooth a few are enough.
constexpr std::size_t kBoxes = 1024;
/// More cells than this each way cannot be numbered by a cell tree.
constexpr std::size_t kMostCells = 60000;

/// Whether bounds prove position and tangents to be defined and continuous everywhere.
bool is_smooth(const Surface& surface) {
  constexpr std::size_t kOutputs = 9;  // r, r_u, r_v
  Enclosure enclosure(surface.bounds, kOutputs);
  std::array<Interval, kOutputs> outputs;
  const Domain& d = surface.domain;
  std::vector<ParameterBox> open = {{{d.u0, d.v0}, {d.u1, d.v1}}};
  for (std::size_t box = 0; !open.empty(); ++box) {
    if (box == kBoxes) return false;
    const ParameterBox whole = open.back();
    open.pop_back();
    enclosure(range_between(whole.low.x, whole.high.x), range_between(whole.low.y, whole.high.y),
              outputs);
    const auto is_proved = [](const Interval& a) {
      return a.defined == Defined::Yes && a.continuous;
    };
    if (std::ranges::all_of(outputs, is_proved)) continue;
    const dvec2 part = (whole.high - whole.low) / dvec2(d.u1 - d.u0, d.v1 - d.v0);
    const int axis = part.x >= part.y ? 0 : 1;
    ParameterBox first = whole;
    ParameterBox second = whole;
    first.high[axis] = second.low[axis] = whole.middle()[axis];
    open.push_back(first);
    open.push_back(second);
  }
  return true;
}

}  // namespace

std::optional<MeshResult> mesh_of_samples(const Surface& surface, const MeshRequest& request) {
  const auto [cells_u, cells_v] = request.samples.value();
  std::optional<MeshPlan> plan = plan_mesh(surface, request);
  if (!plan || std::max(cells_u, cells_v) > kMostCells) return std::nullopt;
  if (!request.clip && is_smooth(surface)) {
    MeshResult mesh = mesh_on_grid(surface, {static_cast<int>(cells_u), static_cast<int>(cells_v),
                                             request.lines_u, request.lines_v, request.threads});
    name_singular(plan->singular, surface.domain, mesh.report);
    return mesh;
  }
  const Domain& d = surface.domain;
  plan->lines = {even_lines(d.u0, d.u1, cells_u), even_lines(d.v0, d.v1, cells_v)};
  plan->is_limited = false;
  std::optional<MeshResult> mesh = mesh_within_tolerance(surface, request, std::move(*plan));
  if (mesh) {
    mesh->report.tolerance.reset();
    mesh->report.least_triangles = 0;
    mesh->report.coarse_normals.reset();
  }
  return mesh;
}

}  // namespace saddle
