// Predicts where a surface is highest above a triangle, from its height and slope at one point and
// the normals at the triangle's corners: a damped step of Newton's method. For loops that are
// compiled once for each CPU level, as mesh/grid/loop_vectors.h says, and for single points.
#pragma once

#include <math.h>

#include "mesh/grid/loop_vectors.h"

namespace saddle {

/// Slopes of the surface above a triangle at a point, and its second derivatives, in coordinates of
/// the triangle's plane: 0 at the first corner and 1 at the second (b) or third (c).
struct StepShape {
  double slope_b, slope_c;
  double bend_bb, bend_bc, bend_cc;
};

struct NewtonStep {
  double height;      ///< predicted; that of the point, if there is no step uphill
  double to_b, to_c;  ///< the step, in the plane's coordinates
};

/// From the sides from the first corner to the others, the differences of unit normals along them,
/// and the unit normal at the point.
static inline StepShape step_shape(LoopVector to_second, LoopVector to_third, LoopVector turn_b,
                                   LoopVector turn_c, LoopVector at_point) {
  return {-dot(at_point, to_second), -dot(at_point, to_third), -dot(turn_b, to_second),
          -0.5 * (dot(turn_b, to_third) + dot(turn_c, to_second)), -dot(turn_c, to_third)};
}

/// A step from a point at a height along the normals, above the triangle's point with these weights
/// of the second and third corner. The step is damped, so that it leads uphill on a cylinder, and
/// shortened to stay within the triangle.
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
