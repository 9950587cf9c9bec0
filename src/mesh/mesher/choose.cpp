#include "mesh/mesher/choose.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/mesher/grid_within.h"
#include "mesh/sizing/cost_model.h"
#include "mesh/sizing/grid_sizing.h"

namespace saddle {
namespace {

/// By how much a grid may be off by the outlook: it is right to a hundredth where it is right.
constexpr double kPredicted = 1.005;
/// Lines are placed for a tolerance that is smaller by this factor at least: since a whole number
/// of cells is between drawn lines, a little closer is often no closer.
constexpr double kToleranceStep = 1.2;
/// A grid that misses by more tolerances does so because of one place, not of its lines' distance.
constexpr double kWorthCloserLines = 3;
/// Grids that come to nothing may cost so much of what halving cells does.
constexpr double kMostStagnation = 0.5;
constexpr double kTrianglesOfCell = 2;

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

  /// The mesh of a grid, if that is cheaper and keeps the tolerance.
  std::optional<MeshResult> grid() {
    if (!may_be_grid()) return std::nullopt;
    FixedLines lines = plan_.lines;
    double worst = grid_forecast_.worst;  // cell, in tolerances
    for (double safer = 1;;) {
      if (!is_cheaper(cells_of(lines))) return std::nullopt;
      ++choice_.grids;
      if (worst <= kPredicted) {
        GridTrial trial = try_grid(surface_, request_, plan_, lines);
        if (trial.mesh) return std::move(trial.mesh);
        work_.add(trial.work);
        choice_.why = trial.excess > 0 ? Why::GridMisses : Why::NotSmooth;
        choice_.excess = worst = trial.excess;
        if (!(worst > 0 && worst <= kWorthCloserLines)) return std::nullopt;
      }
      safer *= std::max(worst, kToleranceStep);
      // Errors grow with areas. That bounds the search, too: lines need not come closer at once,
      // nor ever, where it is one place that misses.
      if (!is_cheaper(cells_of(plan_.lines) * std::sqrt(safer))) return std::nullopt;
      lines = place_lines(plan_.probe, plan_.fixed, plan_.sizing, std::sqrt(safer));
      worst = forecast_grid(plan_.probe, lines, plan_.aim).worst;
    }
  }

  /// Fills in what was chosen.
  void complete(MeshReport& report) const {
    report.choice = choice_;
    report.work.add(work_);
  }

 private:
  double cost_of(const MeshWork& work, double cells) const {
    return cost(work, operations_) + drawing_cost(kTrianglesOfCell * cells, request_.draws);
  }

  bool may_be_grid() {
    choice_.why = request_.clip || plan_.is_limited       ? Why::Limited
                  : !plan_.tolerance.is_same_everywhere() ? Why::VariesTolerance
                  : !grid_forecast_.is_regular || !plan_.singular.points.empty()
                      ? Why::NotSmooth
                      : Why::GridIsCheaper;
    return choice_.why == Why::GridIsCheaper;
  }

  /// Cells along u and along v.
  static dvec2 cells_of(const FixedLines& lines) {
    return {lines.u.size() - 1, lines.v.size() - 1};
  }

  bool is_cheaper(const dvec2& sides) {
    const double cells = sides.x * sides.y;
    // Not so for NaN.
    const bool is_allowed = kTrianglesOfCell * cells <= static_cast<double>(request_.max_triangles);
    const MeshWork work = is_allowed ? work_of_grid(cells) : MeshWork();
    const double stagnation = cost(work_, operations_);
    if (stagnation > 0 &&
        stagnation + cost(work, operations_) > kMostStagnation * choice_.halving_cost) {
      return false;  // that it missed remains the reason
    }
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
  MeshWork work_;  // of grids that came to nothing
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
