// Unit normals: exact at regular points, one-sided limits at singular ones.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "surface/surface.h"

namespace saddle {

/// |r_u x r_v| at most this times the local scale of |r_u| |r_v| counts as zero: below it the
/// direction has lost about half of a double's digits to cancellation.
inline constexpr double kDegenerateCross = 1e-7;

/// The unit vector along r_u x r_v (along r_v x r_u for a flipped surface), or nothing where the
/// tangents are not finite or their cross product is at most kDegenerateCross * scale_u * scale_v,
/// the scales being the largest |r_u| and |r_v| around the point (a cell and its neighbours).
std::optional<dvec3> unit_normal(const SurfacePoint& point, double scale_u, double scale_v,
                                 bool flip);

/// A point of columns: its normal is a unit vector toward the front if it is regular.
struct ColumnPoint {
  dvec3 position;
  dvec3 normal;
  bool is_regular;  ///< |r_u x r_v| is more than kDegenerateCross |r_u| |r_v|, and all is finite
};
ColumnPoint column_point(const NormalColumns& columns, std::size_t i, bool flip);

/// The largest terms of which the components of r_u x r_v are differences, as a vector's length: to
/// rounding of it |r_u x r_v| is known, whatever the units of the axes. 1e9 u v has long tangents
/// that are nearly parallel, of which r_u x r_v has all digits.
double cross_terms(const SurfacePoint& point);

/// The unit vector along r_u x r_v (along r_v x r_u for a flipped surface), if it is more than
/// kDegenerateCross of its terms. Rounding errors in the tangents themselves are not considered.
std::optional<dvec3> known_normal(const SurfacePoint& point, bool flip);

/// The direction of r_u x r_v, however short it is; nothing where it has none.
std::optional<dvec3> normal_direction(const SurfacePoint& point);

/// Whether products of four such numbers, as in |r_u x r_v|^2, neither overflow nor vanish.
inline bool is_moderate(double x) {
  return x > 1e-70 && x < 1e70;
}

/// safe_length() by way of the largest component.
double scaled_length(const dvec3& a);

/// |a|, also where its square would overflow or vanish; infinite where `a` is not finite.
inline double safe_length(const dvec3& a) {
  const double plain = glm::length(a);
  return is_moderate(plain) ? plain : scaled_length(a);
}

/// A limit found by extrapolation.
struct NormalLimit {
  std::optional<dvec3> normal;  ///< nothing: no limit exists, or none was found
};

/// The limit of the unit normal when `corner` is approached along the straight line from `inside`
/// (the centre of the cell that the corner belongs to). It is the cell's own, one-sided limit: at
/// a cusp edge or a cone's apex the cells around the point get different ones, and its sign is
/// that of the normals inside the cell.
/// Method: unit normals N_i at corner + d tau_i^2, tau_i = 0.2 * 2^-i, d = inside - corner (the
/// square makes square-root limits analytic), extrapolated to tau = 0 as polynomials in tau.
/// Source: L. F. Richardson, "The deferred approach to the limit", 1927.
NormalLimit limit_normal(const Surface& surface, dvec2 corner, dvec2 inside);

/// Where a limit is wanted, and from which side: the arguments of limit_normal().
struct Approach {
  dvec2 corner;
  dvec2 inside;
};

/// limit_normal() for each approach, with the points of many evaluated in one batch.
std::vector<NormalLimit> limit_normals(const Surface& surface, std::span<const Approach> approaches,
                                       unsigned threads = 0);

/// The limits of the unit normal at a place of the domain, on ways from within it, each once: one
/// at a regular point, one for each side that has a limit at a singular one.
std::vector<dvec3> normals_around(const Surface& surface, const dvec2& uv);

}  // namespace saddle
