// How far a mesh is from the surface it stands for, measured on fresh points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mesh/grid/grid.h"

namespace saddle {

/// Of a point of the surface from triangles that stand for it.
struct SampledError {
  double distance = 0;     ///< in units of length; 0 where the surface is undefined
  double degrees = 0;      ///< of exact and interpolated normal; 0 where there is none
  bool on_crease = false;  ///< of a point of a crease from its chord
};
/// `point` is at (u, v). Its distance is from the triangle that (u, v) is in, if it is straight
/// above it, else from the nearest one; or that triangle's point at (u, v) from the surface, if
/// that is larger, as at an edge that sticks out. Its normal is compared with that triangle's,
/// since near a cusp the other sheet may be as near. Whoever knows of a larger distance already
/// need not be told a smaller one exactly: nobody looks for a nearer triangle than one within
/// `known`. The triangles do not overlap in (u, v).
SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const SurfacePoint& point, bool flip, double known = 0);
/// The same of a position with its unit normal, if it has one.
SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const dvec3& position, const std::optional<dvec3>& normal,
                           double known = 0);

/// A triangle, and what its corners weigh at a place in (u, v).
struct Below {
  const Triangle* triangle;
  dvec3 weights;
};

/// The triangle that (u, v) is in, or is least outside of: then a weight is negative. There is one
/// triangle at least.
Below triangle_below(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv);
/// A place in a triangle above which the surface may be farther away than it is at another.
struct Predicted {
  double distance = 0;  ///< as mesh/error/newton_step.h foresees it
  dvec2 uv{0};
};
/// From the point at (u, v), above the triangle that it is straight above, or else the nearest one.
/// Nothing if it has no regular normal.
Predicted predict(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                  const SurfacePoint& point, bool flip);

/// Whether a surface, which is at `position` at (u, v), and its triangles are seen there: what is
/// outside of a box is cut away. Of no triangles nothing is.
struct Seen {
  bool surface = true;
  bool triangles = true;
};
Seen seen_at(const std::optional<Bounds>& clip, const Grid& grid,
             std::span<const Triangle> triangles, const dvec2& uv, const dvec3& position);

/// Its distance alone.
double distance_from(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                     const dvec3& position);

using Chord = std::array<std::uint32_t, 2>;  ///< from corner to corner

/// The distance of a position, in local units, from the line through two corners: along the chord
/// is none. Not a number if they are at one place.
double distance_from_line(const Grid& grid, const Chord& chord, const dvec3& p);
/// The same in units of length; 0 if they are at one place or `position` is not finite.
double distance_from_chord(const Grid& grid, const Chord& chord, const dvec3& position);

/// The angle between unit vectors whose ends are so far apart, 0 to 180 degrees, and the other way.
double degrees_of_chord(double chord);
double chord_of_degrees(double degrees);

}  // namespace saddle
