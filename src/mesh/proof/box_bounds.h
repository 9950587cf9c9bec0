// Bounds of a surface over a box of parameters as lengths of vectors, and the distances that follow
// from them.
// Source: D. Filip, R. Magedson, R. Markot, "Surface algorithms using bounds on derivatives", 1986.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "base/bounds.h"
#include "eval/interval.h"
#include "mesh/model/proof_gap.h"
#include "surface/parameter_box.h"

namespace saddle {

struct BoxBounds {
  /// From the bounds of r, r_u, r_v, r_uu, r_uv, r_vv.
  explicit BoxBounds(std::span<const Interval> bounds);

  /// Bounds of the distance of the surface over a rectangle of this size from a triangle with
  /// corners in it that are points of the surface.
  double arc(const dvec2& size) const;
  /// Bounds of the distance of the surface over a box of this size from the convex hulls of points
  /// of it: of the corners of equal rectangles, `cells` along u and v. 0 cells along an axis: the
  /// points lie in the middle of its range.
  double reach(const dvec2& size, const std::array<std::uint32_t, 2>& cells) const;
  /// The fewest cells of a box whose corners are within `allowed` of the surface; nothing if too
  /// many.
  std::optional<std::array<std::uint32_t, 2>> cells_within(const dvec2& size, double allowed) const;
  /// How much of the reach a range along u and v adds.
  dvec2 contributions(const dvec2& size) const;
  /// The longest distance between points of the surface.
  double extent() const { return glm::length(hull.high - hull.low); }
  /// A bound of the distance of the surface from a position.
  double farthest(const dvec3& position) const {
    return glm::length(glm::max(glm::abs(hull.low - position), glm::abs(hull.high - position)));
  }

  bool is_undefined = false;  ///< proved: the surface is defined nowhere
  /// Why it is not proved that the surface is defined and continuous.
  std::optional<GapReason> broken;
  bool is_smooth = false;   ///< tangents are continuous, second derivatives exist
  bool may_crease = false;  ///< tangents exist, and may jump
  /// |r_uu|, |r_uv|, |r_vv|; infinite where they may not exist.
  dvec3 bend{std::numeric_limits<double>::infinity()};
  /// |r_u|, |r_v|; infinite where they may not exist.
  dvec2 slope{std::numeric_limits<double>::infinity()};
  Bounds hull;  ///< around r
};

/// A part of a box, with its bounds.
struct BoundedPart {
  ParameterBox box;
  BoxBounds bounds;
};

/// Halves a box again and again, and goes on with the half whose bounds are farther from the corner
/// of the first box, until they are as narrow as the tolerance or the surface is undefined there.
BoundedPart farthest_part(const ParameterBox& whole, double tolerance,
                          const std::function<BoxBounds(const ParameterBox&)>& bounds_over);

}  // namespace saddle
