// One parametric surface, ready to be evaluated: position and first derivatives as tapes.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "eval/tape.h"
#include "formula/graph.h"

namespace saddle {

/// The rectangle of parameters [u0, u1] x [v0, v1], all finite. u0 > u1 is a range run backwards.
struct Domain {
  double u0 = -1, u1 = 1;
  double v0 = -1, v1 = 1;
};

/// One of the two ranges runs backwards, which turns the rectangle over.
inline bool runs_backwards(const Domain& domain) {
  return (domain.u0 > domain.u1) != (domain.v0 > domain.v1);
}

struct Surface {
  Domain domain;
  bool flip = false;  ///< front and back are swapped: the normal is r_v x r_u
  Tape position;      ///< outputs x, y, z
  Tape first_order;   ///< outputs x, y, z, x_u, y_u, z_u, x_v, y_v, z_v
};

/// x, y, z: nodes that depend on u and v alone. The derivatives come from the formulas.
Surface make_surface(Graph& graph, NodeId x, NodeId y, NodeId z, const Domain& domain, bool flip);

/// A point of a surface with its tangents; components are NaN or infinite where undefined.
struct SurfacePoint {
  dvec3 position;
  dvec3 r_u;
  dvec3 r_v;
};

/// Positions and tangents at arbitrary parameters, (u[i], v[i]).
std::vector<SurfacePoint> evaluate(const Surface& surface, std::span<const dvec2> uv,
                                   unsigned threads = 0);

/// Positions and tangents on the grid u x v, v outer: result[j * u.size() + i] is at (u[i], v[j]).
std::vector<SurfacePoint> evaluate_on_grid(const Surface& surface, std::span<const double> u,
                                           std::span<const double> v, unsigned threads = 0);

}  // namespace saddle
