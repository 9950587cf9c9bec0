#include "meshing/thickness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "mesh/model/tolerances.h"
#include "scene/model/values.h"
#include "surface/conditioning.h"
#include "surface/normal.h"

namespace saddle {
SharpestBends sharpest_bends(const Surface& surface, const Mesh& mesh, unsigned threads) {
  SharpestBends bends;
  const std::vector<SurfacePoint> points = evaluate(surface, mesh.uv, threads);
  const double shortest_u = kShortTangent * usual_length(points, &SurfacePoint::r_u);
  const double shortest_v = kShortTangent * usual_length(points, &SurfacePoint::r_v);
  const std::vector<Curvature> curvatures = evaluate_curvature(surface, mesh.uv, threads);
  for (std::size_t i = 0; i < curvatures.size(); ++i) {
    const double size_u = safe_length(points[i].r_u);
    const double size_v = safe_length(points[i].r_v);
    const double across = glm::length(glm::cross(points[i].r_u / size_u, points[i].r_v / size_v));
    if (!(across > kWellConditioned && size_u >= shortest_u && size_v >= shortest_v)) continue;
    const double largest = curvatures[i].largest;
    const double smallest = curvatures[i].smallest;
    if (std::isfinite(largest) && largest > bends.toward_front) {
      bends.toward_front = largest;
      bends.at_front = mesh.uv[i];
    }
    if (std::isfinite(smallest) && -smallest > bends.toward_back) {
      bends.toward_back = -smallest;
      bends.at_back = mesh.uv[i];
    }
  }
  if (surface.v.outputs.empty()) return bends;
  take_user_parameters(surface, std::span(&bends.at_front, 1));
  take_user_parameters(surface, std::span(&bends.at_back, 1));
  return bends;
}

double units_per_millimetre(std::optional<double> print_size,
                            const std::function<double(double)>& longest_side) {
  if (!print_size) return 1;
  const auto excess = [&](double unit) { return longest_side(unit) - *print_size * unit; };
  double last = longest_side(0) / *print_size;
  double last_excess = excess(last);
  if (last_excess == 0)
    return last;  // nothing grows: flat surfaces, thick across their longest side
  double unit = last + last_excess / *print_size;
  // The secant method: the function is piecewise linear, so it ends after a few steps.
  for (int k = 0; k < kAllHalvings; ++k) {
    const double now = excess(unit);
    if (std::abs(now) <= kRoundingOfSums * *print_size * unit) return unit;
    const double slope = (now - last_excess) / (unit - last);
    if (!(slope < 0)) break;  // solids grow as fast as their print
    last = std::exchange(unit, unit - now / slope);
    last_excess = now;
  }
  throw Error(Status::Input, "no print of this size is so thick",
              {"print-size", format_number(*print_size), {}},
              "a smaller --thickness, or a larger --print-size");
}

Thickening thickening_of(const Thickness& thickness, double unit) {
  const double total = thickness.value * (thickness.millimetres ? unit : 1);
  switch (thickness.where) {
    case Thickness::Where::Front:
      return {total, 0};
    case Thickness::Where::Back:
      return {0, total};
    default:
      return {total / 2, total / 2};
  }
}

double reach_of_solid(const Scene& scene, const SurfaceSpec& spec, double longest) {
  const auto thickness = thickness_of(scene, spec);
  if (!thickness) return 0;
  const double unit = scene.mesh.print_size ? longest / *scene.mesh.print_size : 1;
  const Thickening thickening = thickening_of(*thickness, unit);
  return std::max(thickening.front, thickening.back);
}

SolidReport solid_report(const SolidFacts& facts, const Thickening& thickening,
                         const SharpestBends& bends) {
  SolidReport report;
  report.facts = facts;
  report.thickness = thickening.total();
  // A sheet folds at the distance of the radius from its surface.
  const double front = bends.toward_front * thickening.front;
  const double back = bends.toward_back * thickening.back;
  const double sharpest = std::max(front, back);
  report.largest_thickness = sharpest > 0 ? report.thickness / sharpest : kInfinity;
  if (sharpest > 0) report.at = front >= back ? bends.at_front : bends.at_back;
  return report;
}

}  // namespace saddle
