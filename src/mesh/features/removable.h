// Removable singularities: places at which a formula is 0/0, or rounding, and the surface around
// has a limit.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "surface/surface.h"

namespace saddle {

/// The surface beside a place.
struct Beside {
  bool is_defined = false;     ///< at one of the looks at least
  bool is_alone = false;       ///< the position is known at all looks
  bool is_within = false;      ///< it is on both sides along both axes
  std::optional<dvec3> limit;  ///< the position on which all looks agree
};

/// Evaluates the surface 1e-6 ranges from each place, on all sides. `diagonal`: of a box around the
/// surface. Adds to `count` the number of points evaluated.
std::vector<Beside> look_beside(const Surface& surface, std::span<const dvec2> places,
                                double diagonal, unsigned threads, std::size_t& count);

/// How far the last digit of the parameters moves a point, by its tangents, or by their lengths.
double moved_by_last_digit(const SurfacePoint& point, const dvec2& uv);
double moved_by_last_digit(const dvec2& lengths, const dvec2& uv);

/// Whether that is a finite distance of more than `most`. Then a place that is `most` away from a
/// mesh is no error of the mesh.
bool moves_by_last_digit(const SurfacePoint& point, const dvec2& uv, double most);
bool moves_by_last_digit(const Surface& surface, const dvec2& uv, double most);

/// Whether a position is rounding: the last digit of the parameters moves it by more than
/// kLimitsAgree. (u^3 - v^3) / (u - v) is rounding where u and v are neighbouring doubles. Tangents
/// that are not finite tell nothing: the apex of 1 - hypot(u, v) has none.
bool is_rounding(const SurfacePoint& point, const dvec2& uv, double diagonal);

/// The diagonal of the box around those points of a sampled surface that are not rounding: the
/// others may be far away. `diagonal`: of the box around all. Infinite where too many are rounding,
/// which is the surface then, as of sin(1e15 u).
double diagonal_without_rounding(std::span<const SurfacePoint> points, std::span<const dvec2> uv,
                                 double diagonal);

/// The most by which rounding of the parameters moves a point, along each axis; 0 where the
/// tangents are not finite. At the ends of sqrt(sin(u)) over 0:pi, sin(pi) = 1e-16 gives 1e-8.
dvec3 rounding_by_parameters(const SurfacePoint& point, const dvec2& uv, const Domain& domain);

}  // namespace saddle
