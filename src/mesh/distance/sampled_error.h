// The error of triangles at one point of the surface: its distance from them, the angle between
// normals, and where the distance is predicted to be larger.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/numbers.h"
#include "mesh/grid/grid.h"

namespace saddle {

/// The error of triangles at a point of their surface.
struct SampledError {
  double distance = 0;     ///< in units of length; 0 if the surface is undefined
  double degrees = 0;      ///< between the exact and the interpolated normal; 0 without one
  bool on_crease = false;  ///< measured from a crease's chord
  /// Whether a boundary or a jump is farther than the tolerance from the chord in its place.
  bool is_off_chord = false;
  std::uint32_t place = kNoIndex;  ///< of `distance`: its number in ErrorPlaces
};
/// The error at `point`, which is at (u, v). The distance is that from the triangle around (u, v)
/// if the point is straight above it, else from the nearest triangle. The distance of the
/// triangle's point at (u, v) from the surface counts if it is larger, as at an edge that sticks
/// out. The normal is compared within the triangle around (u, v): near a cusp the other sheet may
/// be as near. `known`: the error found so far. If the first triangle is within it, others are not
/// searched. The triangles do not overlap in (u, v).
SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const SurfacePoint& point, bool flip, double known = 0);
/// The same for a position and its unit normal, if it has one.
SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const dvec3& position, const std::optional<dvec3>& normal,
                           double known = 0);

/// A triangle, and the weights of its corners at a place in (u, v).
struct Below {
  const Triangle* triangle;
  dvec3 weights;
};

/// The triangle around (u, v), or else the one that (u, v) is least outside of, with a negative
/// weight. `triangles` is not empty.
Below triangle_below(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv);
/// A place above which the surface may be farther from its triangle.
struct Predicted {
  double distance = 0;  ///< by mesh/distance/newton_step.h
  dvec2 uv{0};
};
/// Predicts from the point at (u, v), above the triangle that it is straight above, or else the
/// nearest one. The distance is 0 if the point has no regular normal.
Predicted predict(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                  const SurfacePoint& point, bool flip);
/// The same for a position and its unit normal; there is a triangle.
Predicted predict(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                  const dvec3& position, const dvec3& normal);

/// Whether the surface at (u, v), which is at `position`, and the triangles there are within the
/// clip box. Without triangles, none are.
struct Seen {
  bool surface = true;
  bool triangles = true;
};
Seen seen_at(const std::optional<Bounds>& clip, const Grid& grid,
             std::span<const Triangle> triangles, const dvec2& uv, const dvec3& position);

/// The distance alone of a position from the triangles. `known`: if the first triangle is within
/// it, others are not searched.
double distance_from(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                     const dvec3& position, double known = 0);
/// The distance of a position from one triangle, and the weights of the triangle's corners at the
/// nearest point; infinite if the position is not finite.
struct WeightedDistance {
  double distance;
  dvec3 weights;
};
WeightedDistance nearest_weights(const Grid& grid, const Triangle& triangle, const dvec3& position);
inline double distance_from_triangle(const Grid& grid, const Triangle& triangle,
                                     const dvec3& position) {
  return nearest_weights(grid, triangle, position).distance;
}

using Chord = std::array<std::uint32_t, 2>;  ///< from corner to corner

/// The distance of a position, in local units, from the line through two corners: along the chord
/// is none. Not a number if they are at one place.
double distance_from_line(const Grid& grid, const Chord& chord, const dvec3& p);
/// The same in units of length; 0 if they are at one place or `position` is not finite.
double distance_from_chord(const Grid& grid, const Chord& chord, const dvec3& position);

/// The angle, 0 to 180 degrees, between unit vectors whose difference has this length; the inverse.
double degrees_of_chord(double chord);
double chord_of_degrees(double degrees);

}  // namespace saddle
