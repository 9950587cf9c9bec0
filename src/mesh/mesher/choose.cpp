#include "mesh/mesher/choose.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/mesher/grid_within.h"
#include "mesh/sizing/cost_model.h"
#include "mesh/sizing/grid_sizing.h"

namespace saddle {
namespace {

/// Closer lines are placed for a tolerance smaller by a factor of 1.2 at least. The number of cells
/// between drawn lines is whole, so a smaller step often changes nothing.
constexpr double kToleranceStep = 1.2;

using Why = MeshChoice::Why;

class Chooser {
 public:
  Chooser(const Surface& surface, const MeshRequest& request, const MeshPlan& plan)
      : surface_(surface),
        request_(request),
        plan_(plan),
        operations_(count_operations(surface)),
        grid_forecast_(forecast_grid(plan.probe, plan.lines, plan.aim)) {
    choice_.halving_cost = cost_of(work_of_halving(grid_forecast_.cells), grid_forecast_.cells);
  }

  /// The mesh of a grid, if it is cheaper and keeps the tolerance.
  std::optional<MeshResult> grid() {
    if (!may_be_grid()) return std::nullopt;
    FixedLines lines = plan_.lines;
    double worst = grid_forecast_.worst;  // error of a cell, in tolerances
    for (double safer = 1;;) {
      if (!is_cheaper(cells_of(lines))) return std::nullopt;
      ++choice_.grids;
      if (worst <= 1) {
        GridTrial trial = try_grid(surface_, request_, plan_, lines);
        if (trial.mesh) return std::move(trial.mesh);
        work_.add(trial.work);
        choice_.why = trial.excess > 0 ? Why::GridMisses : Why::NotSmooth;
        choice_.excess = worst = trial.excess;
        if (!(worst > 0)) return std::nullopt;
      }
      safer *= std::max(worst, kToleranceStep);
      // Errors grow with the areas of cells. The check also ends the loop where lines do not come
      // closer.
      if (!is_cheaper(cells_of(plan_.lines) * std::sqrt(safer))) return std::nullopt;
      lines = place_lines(plan_.probe, plan_.fixed, plan_.sizing, std::sqrt(safer));
      worst = forecast_grid(plan_.probe, lines, plan_.aim).worst;
    }
  }

  /// Fills in the choice and the work.
  void complete(MeshReport& report) const {
    report.choice = choice_;
    report.work.add(work_);
  }

 private:
  double cost_of(const MeshWork& work, double cells) const {
    return cost(work, operations_) + drawing_cost(2 * cells, request_.draws);
  }

  bool may_be_grid() {
    choice_.why = request_.clip || plan_.is_limited       ? Why::Limited
                  : !plan_.tolerance.is_same_everywhere() ? Why::VariesTolerance
                  : !grid_forecast_.is_regular || !plan_.singular.points.empty() || is_broken()
                      ? Why::NotSmooth
                      : Why::GridIsCheaper;
    return choice_.why == Why::GridIsCheaper;
  }

  /// Whether landmarks show a boundary, or a jump that is higher than the tolerance.
  bool is_broken() const {
    const Landmarks& landmarks = plan_.probe.landmarks();
    const double allowed = plan_.aim(plan_.probe.bounds().centre());
    return landmarks.has_boundary || landmarks.highest_step > allowed;
  }

  /// Cells along u and along v.
  static dvec2 cells_of(const FixedLines& lines) {
    return {lines.u.size() - 1, lines.v.size() - 1};
  }

  bool is_cheaper(const dvec2& sides) {
    const double cells = sides.x * sides.y;
    // False for NaN.
    const bool is_allowed = 2 * cells <= static_cast<double>(request_.max_triangles);
    const MeshWork work = is_allowed ? work_of_grid(cells) : MeshWork();
    if (is_allowed) {
      choice_.cells_u = static_cast<std::size_t>(sides.x);
      choice_.cells_v = static_cast<std::size_t>(sides.y);
      choice_.grid_cost = cost_of(work, cells);
    }
    choice_.why = !is_allowed                                ? Why::Limited
                  : choice_.grid_cost < choice_.halving_cost ? Why::GridIsCheaper
                                                             : Why::HalvingIsCheaper;
    return choice_.why == Why::GridIsCheaper;
  }

  const Surface& surface_;
  const MeshRequest& request_;
  const MeshPlan& plan_;
  Operations operations_;
  GridForecast grid_forecast_;
  MeshChoice choice_;
  MeshWork work_;  // of discarded grids
};

}  // namespace

std::optional<MeshResult> mesh_at_least_cost(const Surface& surface, const MeshRequest& request) {
  std::optional<MeshPlan> plan = plan_mesh(surface, request);
  if (!plan) return std::nullopt;
  Chooser chooser(surface, request, *plan);
  std::optional<MeshResult> mesh = chooser.grid();
  if (!mesh) mesh = mesh_within_tolerance(surface, request, std::move(*plan));
  if (mesh) chooser.complete(mesh->report);
  return mesh;
}

}  // namespace saddle
