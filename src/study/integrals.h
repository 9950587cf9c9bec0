// Area and volume of a surface as integrals over its parameters, also where derivatives go to
// infinity.
#pragma once

#include <cstddef>

#include "surface/surface.h"

namespace saddle {

/// A number and how far off it may be, as two estimates differ. That is no bound: toward a line at
/// which the integrand goes to infinity the rest is some times the difference.
struct Estimate {
  double value = 0;
  double error = 0;
};

struct Integrals {
  Estimate area;
  Estimate volume;  ///< of the cone over the surface from `centre`; by r_u x r_v, not flipped
  std::size_t evaluations = 0;
};

/// Over what of the domain is defined. Rectangles of parameters, the worst first, are halved across
/// the axis along which halves make the larger difference, until all differences together are
/// rounding or the work is too much: toward a line at which the integrand goes to infinity they
/// become narrower and narrower. Where a part is not defined, integrals along lines between its
/// ends are taken if they are better. `size`: the surface's, by which volumes are compared with
/// areas. `share`: of the points that may be evaluated, less for one of many surfaces. Method:
/// Gauss's rule with 4 x 5 points, adaptive as of P. van Dooren, L. de Ridder, "An adaptive
/// algorithm for numerical integration over an n-dimensional cube", 1976.
Integrals integrate_domain(const Surface& surface, const dvec3& centre, double size,
                           unsigned threads, double share = 1);

}  // namespace saddle
