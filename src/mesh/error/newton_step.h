// Where a surface is highest above a triangle, foreseen from one point of it: its height and slope
// there are known, and how slopes change from the normals at the triangle's corners. For loops that
// are compiled once for each CPU level, as mesh/grid/loop_vectors.h says, and for single points.
#pragma once

#include <math.h>

#include "mesh/grid/loop_vectors.h"

namespace saddle {

/// The shape of the surface above a triangle in the coordinates of its plane that are 0 at the
/// first corner and 1 at the second, or third: slopes at a point, and how they change.
struct StepShape {
  double slope_b, slope_c;
  double bend_bb, bend_bc, bend_cc;
};

struct NewtonStep {
  double height;      ///< that is foreseen; the point's own, where it goes no higher
  double to_b, to_c;  ///< how far away in the plane's coordinates that is
};

/// The sides from the first corner to the others, how much the unit normal at the first one turns
/// on the way, and the unit normal at the point.
static inline StepShape step_shape(LoopVector to_second, LoopVector to_third, LoopVector turn_b,
                                   LoopVector turn_c, LoopVector at_point) {
  return {-dot(at_point, to_second), -dot(at_point, to_third), -dot(turn_b, to_second),
          -0.5 * (dot(turn_b, to_third) + dot(turn_c, to_second)), -dot(turn_c, to_third)};
}

/// From a point of some height, on the side that normals are on, above a point of the triangle with
/// these weights of the second and the third corner. A step of Newton's method, damped so that it
/// leads uphill along a cylinder, and shortened so that it stays in the triangle.
static inline NewtonStep newton_step_from(StepShape shape, double height, double weight_b,
                                          double weight_c) {
  const double up = height < 0 ? -1.0 : 1.0;
  const double b = up * shape.slope_b, c = up * shape.slope_c;
  const double bb = up * shape.bend_bb, bc = up * shape.bend_bc, cc = up * shape.bend_cc;
  const double damping = 0.25 * (fabs(bb) + fabs(cc));
  const double x = damping - bb, y = damping - cc;
  const double determinant = x * y - bc * bc;
  const double way_b = (y * b + bc * c) / determinant;
  const double way_c = (bc * b + x * c) / determinant;
  const double way_a = -way_b - way_c;
  const double slope = b * way_b + c * way_c;
  const double bend = bb * way_b * way_b + 2 * bc * way_b * way_c + cc * way_c * way_c;
  // Until a weight is 0, or the slope.
  const double weight_a = 1 - weight_b - weight_c;
  const double room_b = way_b < 0 ? -weight_b / way_b : 1e9;
  const double room_c = way_c < 0 ? -weight_c / way_c : 1e9;
  const double room_a = way_a < 0 ? -weight_a / way_a : 1e9;
  const double step = smaller_of(-slope / bend, smaller_of(room_a, smaller_of(room_b, room_c)));
  const double rise = step * (slope + 0.5 * step * bend);
  const double is_uphill = smaller_of(smaller_of(x, determinant), smaller_of(-bend, rise));
  const double taken = is_uphill > 0 ? step : 0.0;
  return {fabs(height) + (is_uphill > 0 ? rise : 0.0), taken * way_b, taken * way_c};
}

}  // namespace saddle
