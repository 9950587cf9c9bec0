#include "mesh/mesher/mesh_plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include <glm/common.hpp>

#include "mesh/features/nonsmooth_points.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"
#include "mesh/sizing/aliasing_forecast.h"
#include "mesh/sizing/grid_sizing.h"
#include "surface/parameter_box.h"

namespace saddle {
namespace {

/// Meshing aims at 0.98 of the tolerance: samples miss part of the largest distance.
constexpr double kAim = 0.98;
/// A root grid has at most 0.28 lines each way over the tolerance as a share of the diagonal: its
/// narrowest cells are about as wide as the narrow leaves of an Oscillation.
constexpr double kMostRootLines = 0.28;

/// Too many lines become fewer in steps: the tolerance that they are placed for grows by 1.25; by
/// 4, which halves their number, while lines or cells are more than twice too many. A surface like
/// sin(1e15*u) would take 1e15 lines.
constexpr double kCoarser = 1.25;
constexpr double kMuchCoarser = 4;

FixedLines drawn_lines(const Domain& domain, const LineCounts& counts) {
  const auto lines = [](double first, double last, int count) {
    return even_lines(first, last, static_cast<std::size_t>(std::max(count, 2) - 1));
  };
  return {lines(domain.u0, domain.u1, counts.u), lines(domain.v0, domain.v1, counts.v)};
}

std::size_t cells(const FixedLines& lines) {
  return (lines.u.size() - 1) * (lines.v.size() - 1);
}

/// Lines and more lines within their range, sorted, each once.
std::vector<double> merged_lines(std::vector<double> lines, std::span<const double> more) {
  const bool backwards = lines.front() > lines.back();
  lines.insert(lines.end(), more.begin(), more.end());
  if (backwards) {
    std::ranges::sort(lines, std::greater());
  } else {
    std::ranges::sort(lines);
  }
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

/// Places the lines of the root grid, as close as the tolerance asks or the limit of triangles
/// allows.
void place_root_lines(const MeshRequest& request, MeshPlan& plan) {
  plan.sizing = sizing_field(plan.probe, plan.fixed, tolerance_within(request.clip, plan.aim));
  // Places lines for the tolerance times a factor.
  const auto place = [&plan](double factor) {
    plan.lines = place_lines(plan.probe, plan.fixed, plan.sizing, 1 / std::sqrt(factor));
  };
  place(1);
  const double most =
      std::max(kMostRootLines / plan.tolerance.share_of_diagonal(plan.probe.bounds()),
               static_cast<double>(plan.fixed.u.size() + plan.fixed.v.size()));
  // Places the lines for ever larger tolerances while there are too many by this factor. Returns
  // by how much the tolerance grew.
  const auto place_fewer = [&](double factor, const auto& excess) {
    const double first = factor;
    for (double times; (times = excess()) > 1 && std::isfinite(factor); place(factor))
      factor *= times > 2 ? kMuchCoarser : kCoarser;
    return factor / first;
  };
  const double coarser = place_fewer(1, [&] {
    return static_cast<double>(std::max(plan.lines.u.size(), plan.lines.v.size())) / most;
  });
  const double for_limit = place_fewer(coarser, [&] {
    if (cells(plan.lines) <= cells(plan.fixed)) return 0.0;
    return 2 * static_cast<double>(cells(plan.lines)) / static_cast<double>(request.max_triangles);
  });
  // The grid of a diagonal ridge has many more cells than the mesh needs.
  const double least = plan.probe.least_triangles(plan.tolerance);
  if (least > static_cast<double>(request.max_triangles) && !request.samples) {
    plan.coarser = kCoarser * for_limit;
    plan.aim = plan.aim.times(plan.coarser);
  }
  if (const auto& component = plan.probe.component()) {
    const auto [low, high] = component->where;
    plan.lines.u =
        merged_lines(std::move(plan.lines.u), even_lines(low.x, high.x, kMostAddedLines));
    plan.lines.v =
        merged_lines(std::move(plan.lines.v), even_lines(low.y, high.y, kMostAddedLines));
  }
}

/// Singular points and lines: by descents from the probe's samples, and by interval bounds.
SingularSet singular_set(const Surface& surface, const MeshRequest& request, const MeshPlan& plan) {
  const Domain& d = surface.domain;
  const auto even = [](std::vector<double> lines, double first, double last) {
    lines.push_back(0);
    lines.push_back(0.5 * first + 0.5 * last);
    return lines;
  };
  SingularSet set = find_singular(surface, plan.probe.dips(), even(plan.drawn.u, d.u0, d.u1),
                                  even(plan.drawn.v, d.v0, d.v1), request.threads);
  NonsmoothPoints nonsmooth =
      find_nonsmooth_points(surface, plan.probe.bounds().diagonal(), request.threads);
  set.points.insert(set.points.end(), nonsmooth.conical.begin(), nonsmooth.conical.end());
  set.without_limit = std::move(nonsmooth.without_limit);
  return set;
}

bool is_usable(const Bounds& bounds, const Tolerance& tolerance) {
  const double diagonal = bounds.diagonal();
  // The error indicator squares lengths, and multiplies areas by lengths.
  const double square = diagonal * diagonal;
  if (!std::isnormal(square) || !std::isfinite(square * diagonal)) return false;
  const double eps = tolerance(bounds.centre());
  return eps > 0 && std::isfinite(eps);
}

double rounding_of_positions(const Bounds& bounds) {
  const dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
  return kRounding * std::max({farthest.x, farthest.y, farthest.z});
}

}  // namespace

Tolerance tolerance_within(const std::optional<Bounds>& clip, const Tolerance& tolerance) {
  if (!clip) return tolerance;
  return [box = *clip, tolerance](const dvec3& place, double reach) {
    const bool is_clipped = is_beyond(box, std::span(&place, 1));
    return is_clipped ? std::numeric_limits<double>::infinity() : tolerance(place, reach);
  };
}

std::optional<MeshPlan> plan_mesh(const Surface& surface, const MeshRequest& request) {
  Probe probe(surface, request.threads);
  if (request.clip) probe.keep_within(*request.clip);
  Tolerance tolerance = request.tolerance(probe);
  if (!is_usable(probe.bounds(), tolerance)) return std::nullopt;
  const double rounding = rounding_of_positions(probe.bounds());
  const LineCounts lines = request.lines_for ? request.lines_for(probe, tolerance) : request.lines;
  // No mesh keeps the tolerance where waves are too short. Elsewhere it need not be finer than the
  // leaves that show them.
  if (request.is_coarse_with_waves && !request.clip && foresees_aliasing(probe, tolerance))
    tolerance = tolerance.times(kPredictedWidth * kNarrow);
  MeshPlan plan{std::move(probe),
                tolerance,
                tolerance.times(kAim).at_least(rounding),
                lines,
                drawn_lines(surface.domain, lines),
                {},
                {},
                {},
                {}};
  plan.singular = singular_set(surface, request, plan);
  plan.fixed = fixed_lines(plan.probe, plan.drawn, plan.singular);
  place_root_lines(request, plan);
  if (std::max(plan.lines.u.size(), plan.lines.v.size()) > kMostCellsEachWay) return std::nullopt;
  return plan;
}

MeshReport report_of(const MeshPlan& plan) {
  MeshReport report;
  const Bounds& bounds = plan.probe.bounds();
  report.reached_limit = plan.coarser > 1;
  report.tolerance = plan.tolerance(bounds.centre(), bounds.diagonal());
  const double rounding = rounding_of_positions(bounds);
  if (rounding > *report.tolerance) {
    report.rounding = rounding;
    report.max_error = rounding;
  }
  report.least_triangles = plan.probe.least_triangles(plan.tolerance);
  return report;
}

}  // namespace saddle
