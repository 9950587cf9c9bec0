// The formulas of curves and points, in space and on surfaces.
#pragma once

#include <array>

#include "formula/graph.h"
#include "scene/model/scene.h"
#include "scene/model/surface_scope.h"

namespace saddle {

/// The formulas of a curve, with u in place of s.
struct BoundCurve {
  Graph graph;
  std::array<NodeId, 3> r = {};
  double from = 0, to = 1;  ///< the range of s
  std::array<NodeId, 2> ends = {};
  bool moves = false;  ///< it is another one at another time
};

/// Parses a curve at the scene's time. The formulas of one on a surface are that surface's, with
/// u(s) and v(s) put in. Throws Error (Input): anything wrong with a formula or the range, a curve
/// that does not depend on s, a surface that the scene does not have.
BoundCurve bind_curve(const Scene& scene, const CurveSpec& spec);

/// Where a curve goes, as a surface r(u) that is one line.
BoundSurface bind_as_surface(const Scene& scene, const CurveSpec& spec);

/// The same for a point, as the sphere of its radius round it, 0 without one. Throws Error (Input)
/// as bind_curve() does.
BoundSurface bind_point(const Scene& scene, const PointSpec& spec);

/// The surface that a curve or point is on. Throws Error (Input) if there is none of that name, or
/// no name and several.
const SurfaceSpec& surface_under(const Scene& scene, const StrokeSpec& spec);

}  // namespace saddle
