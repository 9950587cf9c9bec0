// The point of a surface that is nearest to a given point, by descent from a guess.
// Source: D. Marquardt, "An algorithm for least-squares estimation of nonlinear parameters", 1963.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "study/subject.h"

namespace saddle {

/// A point of a mesh, and the nearest point of the surface that is known so far.
struct Descent {
  dvec3 from;
  dvec2 uv;                      ///< of the nearest point; at first, the guess
  dvec2 place;                   ///< of `from` in its triangle, as parameters
  std::array<dvec2, 3> corners;  ///< parameters of the triangle's corners
  SurfacePoint at;               ///< the surface at uv
  double distance = std::numeric_limits<double>::infinity();
  /// Levenberg's and Marquardt's, as a share of the normal equations' trace.
  double damping = 1e-6;
};

/// The nearest place of the domain.
dvec2 in_domain(const Domain& domain, const dvec2& uv);

/// Moves each point's `uv` to where the surface is nearer, as far as its tangents lead.
void descend(const Subject& subject, std::vector<Descent>& points);

/// The distances of points that have descended, where other starts lead nearer: the nearest of the
/// points `known` of the surface, which are at `uv`, the corners of the point's triangle, and
/// places beside its own, which may be beyond a rim.
std::vector<double> descend_again(const Subject& subject, const std::vector<Descent>& points,
                                  const std::vector<dvec2>& uv, const std::vector<dvec3>& known);

}  // namespace saddle
