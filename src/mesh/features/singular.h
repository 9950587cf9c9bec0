// Where a surface has no tangent plane of its own: r_u x r_v = 0, between the samples as well.
#pragma once

#include <span>
#include <vector>

#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Zeros of r_u x r_v, or where it is not known, in parameters of the domain.
struct SingularSet {
  std::vector<dvec2> points;         ///< those that are by themselves
  std::vector<dvec2> on_curves;      ///< some of each curve that is no line of these:
  std::vector<double> lines_u;       ///< of constant u, from one end of the range of v to the other
  std::vector<double> lines_v;       ///< of constant v
  std::vector<dvec2> without_limit;  ///< single points at which the surface has no limit

  bool empty() const {
    return points.empty() && on_curves.empty() && lines_u.empty() && lines_v.empty();
  }
};

/// Places where |r_u x r_v| is less than before and behind, on lines along u or along v.
struct Dips {
  std::vector<dvec2> along_u, along_v;
  Bounds bounds;                         ///< of the surface
  std::vector<double> edges_u, edges_v;  ///< those ends of the ranges at which it is 0 throughout
};

/// The zeros that descents from dips end at, for a surface of second order: to
/// double precision where r_u x r_v is known so well. A zero within rounding of one of `even_u` or
/// `even_v` that is one there as well is there. A place where the surface is not defined is none.
/// Method: Gauss and Newton's, with exact derivatives, each step taken once or twice, whichever
/// comes nearer: for double zeros, once is half the way.
/// Source: C. F. Gauss, "Theoria motus corporum coelestium", 1809; E. Schroeder, "Ueber unendlich
/// viele Algorithmen zur Aufloesung der Gleichungen", 1870 (multiple zeros).
SingularSet find_singular(const Surface& surface, const Dips& dips, std::span<const double> even_u,
                          std::span<const double> even_v, unsigned threads);

/// Whether r_u x r_v is 0 at places, compared with what it is around them.
std::vector<bool> are_singular(const Surface& surface, std::span<const dvec2> uv, unsigned threads);

/// Lists those zeros that no singular vertex of a mesh tells of, and tells those that are alone,
/// which are the first of the list then, from the others: some of each line or curve.
void name_singular(const SingularSet& singular, const Domain& domain, MeshReport& report);

}  // namespace saddle
