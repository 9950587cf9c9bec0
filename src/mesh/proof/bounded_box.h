// A box of parameters whose surface is bounded around points of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/vec.h"
#include "mesh/proof/box_bounds.h"
#include "surface/parameter_box.h"

namespace saddle {

/// A proved surface is within 4 tolerances of its triangles. Points are within one. The rest is for
/// bounds, which also count derivatives along the surface, and for the folds between triangles.
inline constexpr double kProofFactor = 4;

/// A part of a patch, divided into equal rectangles. Over each the surface is within `reach` of the
/// convex hull of its corners. With 0 cells along an axis, these are in the middle of its range.
struct BoundedBox {
  std::size_t patch;
  ParameterBox box;
  std::array<std::uint32_t, 2> cells;  ///< along u and along v
  double reach;
  dvec2 bend;                     ///< bounds of |r_uu| and |r_vv|
  std::optional<dvec3> centre{};  ///< in place of the corners: of a sphere of radius `reach`
  bool may_jump = false;  ///< within the sphere; not set where the surface may be undefined, too

  /// Points of the surface that are measured.
  std::size_t count_points() const;
};

/// The part of a patch in a box whose bounds are narrow enough to measure points of it; nothing if
/// they are too wide.
std::optional<BoundedBox> bounded_box(std::size_t patch, const ParameterBox& box,
                                      const BoxBounds& bounds, double tolerance);

}  // namespace saddle
