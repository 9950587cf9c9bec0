// One parametric surface, ready to be evaluated: positions, tangents and normals as tapes.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/array.h"
#include "base/vec.h"
#include "eval/tape.h"
#include "formula/graph.h"

namespace saddle {

/// The rectangle of parameters [u0, u1] x [v0, v1], all finite. u0 > u1 is a range run backwards.
struct Domain {
  double u0 = -1, u1 = 1;
  double v0 = -1, v1 = 1;
  std::array<std::string, 2> names = {"u", "v"};  ///< what the user calls the two parameters

  /// The parameters that are these parts of the ranges away from their first ends.
  dvec2 at(const dvec2& part) const { return dvec2(u0, v0) * (1.0 - part) + dvec2(u1, v1) * part; }
};

/// One of the two ranges runs backwards, which turns the rectangle over.
inline bool runs_backwards(const Domain& domain) {
  return (domain.u0 > domain.u1) != (domain.v0 > domain.v1);
}

/// The outputs of a surface's region: its condition, 1 or 0, then x, y and z as they are without
/// it.
inline constexpr int kRegionOutputs = 4;

/// The derivatives that a surface is compiled for.
enum class Order { First, Second };

struct Surface {
  /// The range of u and v. Where the ends of v depend on u, the second parameter is s, 0 to 1: the
  /// share of the way from the lower end to the upper one. It takes the place of v everywhere.
  Domain domain;
  bool flip = false;  ///< front and back are swapped: the normal is r_v x r_u
  Tape tangents;      ///< tangent_outputs() of surface/forms.h
  Tape positions;     ///< the first three outputs of `tangents`, with the same bits
  Tape normals;       ///< normal_outputs(); see evaluate_normals()
  Tape curvatures;    ///< curvature_outputs(); without outputs unless compiled for second order
  Tape bounds;        ///< r, r_u, r_v, r_uu, r_uv, r_vv for enclosures; the same holds
  Tape v;             ///< v at (u, s); without outputs where v is its own
  Tape color;         ///< the number it is coloured by; without outputs where it is not
  Tape region;        ///< see kRegionOutputs; without outputs where the surface is all of itself

  /// The points at which tangents, normals, curvatures or colours were computed so far, for this
  /// surface and its copies.
  std::size_t evaluations() const { return tangents.count ? tangents.count->total() : 0; }
  /// Whether work that can stop early may go on: points are left, and time. Asked where no threads
  /// compute, so that the answer does not depend on their number.
  bool may_go_on() const;
};

/// x, y, z: nodes that depend on u and v alone. The derivatives come from the formulas.
Surface make_surface(Graph& graph, const std::array<NodeId, 3>& r, const Domain& domain, bool flip,
                     Order order = Order::First);

/// The user's (u, v) in place of the surface's own parameters, (u, s).
void take_user_parameters(const Surface& surface, std::span<dvec2> uv);

/// The reverse.
void take_own_parameters(const Surface& surface, std::span<dvec2> uv);

/// A point of a surface with its tangents; components are NaN or infinite where undefined.
struct SurfacePoint {
  dvec3 position;
  dvec3 r_u;
  dvec3 r_v;
};

/// Positions and tangents at arbitrary parameters, (u[i], v[i]).
std::vector<SurfacePoint> evaluate(const Surface& surface, std::span<const dvec2> uv,
                                   unsigned threads = 0);

/// The positions alone, with the same bits.
std::vector<dvec3> evaluate_positions(const Surface& surface, std::span<const dvec2> uv,
                                      unsigned threads = 0);

/// Positions and tangents on the grid u x v, v outer: result[j * u.size() + i] is at (u[i], v[j]).
std::vector<SurfacePoint> evaluate_on_grid(const Surface& surface, std::span<const double> u,
                                           std::span<const double> v, unsigned threads = 0);

/// Columns of evaluate_normals(): x, y, z; the unit normal along r_u x r_v; |r_u|^2; |r_v|^2;
/// |r_u x r_v|. The normal is NaN or has no meaning where |r_u x r_v| is 0 next to |r_u| |r_v|, or
/// overflows.
using NormalColumns = std::array<Array<double>, 9>;
enum : std::size_t { kNormalColumn = 3, kSquareUColumn = 6, kSquareVColumn = 7, kAreaColumn = 8 };

/// At arbitrary parameters, (u[i], v[i]).
NormalColumns evaluate_normals(const Surface& surface, std::span<const double> u,
                               std::span<const double> v, unsigned threads = 0);

/// On the grid u x v, v outer.
NormalColumns evaluate_normals_on_grid(const Surface& surface, std::span<const double> u,
                                       std::span<const double> v, unsigned threads = 0);

/// Second derivatives and curvatures at a point. Curvatures are in 1/length, positive where the
/// surface bends toward its front, the side of the normal; NaN or infinite where there is none.
struct Curvature {
  dvec3 r_uu, r_uv, r_vv;
  double gauss;
  double mean;
  double largest;  ///< principal curvatures: largest >= smallest
  double smallest;
};

/// For a surface of second order.
std::vector<Curvature> evaluate_curvature(const Surface& surface, std::span<const dvec2> uv,
                                          unsigned threads = 0);

/// Shares of the domain of a surface with a region.
struct RegionShare {
  double outside = 0;    ///< the condition is false
  double undefined = 0;  ///< it holds, and the surface is not finite
};

/// By samples that are spread over the domain. For a surface with a region.
RegionShare region_share(const Surface& surface, unsigned threads = 0);

/// The numbers that a coloured surface is coloured by; NaN or infinite where undefined.
std::vector<double> evaluate_color(const Surface& surface, std::span<const dvec2> uv,
                                   unsigned threads = 0);

}  // namespace saddle
