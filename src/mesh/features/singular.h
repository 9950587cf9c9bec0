// Singular points, where r_u x r_v = 0 and the surface has no tangent plane of its own: from dips
// of |r_u x r_v| between samples to its zeros, to double precision, sorted into isolated points,
// lines of constant u or v, and curves.
#pragma once

#include <span>
#include <vector>

#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Zeros of r_u x r_v, in parameters of the domain.
struct SingularSet {
  std::vector<dvec2> points;         ///< isolated ones
  std::vector<dvec2> on_curves;      ///< some of each curve that is no line of these:
  std::vector<double> lines_u;       ///< of constant u, from one end of the range of v to the other
  std::vector<double> lines_v;       ///< of constant v
  std::vector<dvec2> without_limit;  ///< single points at which the surface has no limit

  bool empty() const {
    return points.empty() && on_curves.empty() && lines_u.empty() && lines_v.empty();
  }
};

/// Samples at which |r_u x r_v| has a local minimum along u or along v.
struct Dips {
  std::vector<dvec2> along_u, along_v;
  Bounds bounds;                         ///< of the surface
  std::vector<double> edges_u, edges_v;  ///< ends of the ranges along which it is 0 throughout
};

/// The zeros at which descents from dips end (ZeroFinder), for a surface of second order. A zero
/// within rounding of one of `even_u` or `even_v` that is one there as well is moved there. A place
/// where the surface is not defined is none.
SingularSet find_singular(const Surface& surface, const Dips& dips, std::span<const double> even_u,
                          std::span<const double> even_v, unsigned threads);

/// Whether r_u x r_v is 0 at places, compared with its size around them.
std::vector<bool> are_singular(const Surface& surface, std::span<const dvec2> uv, unsigned threads);

/// Lists in the report the zeros that are no singular vertices of the mesh: isolated points first,
/// marked as such, then some of each line or curve.
void name_singular(const SingularSet& singular, const Domain& domain, MeshReport& report);

}  // namespace saddle
