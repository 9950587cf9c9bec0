// How far a mesh is from the surface it stands for, measured on fresh points.
#pragma once

#include <cstddef>
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

/// The angle between unit vectors whose ends are so far apart, 0 to 180 degrees, and the other way.
double degrees_of_chord(double chord);
double chord_of_degrees(double degrees);

struct MeasuredError {
  double distance = 0;        ///< largest, from a point of the surface to the triangles of its cell
  double normal_degrees = 0;  ///< largest angle of exact and interpolated normal at such a point
  std::size_t evaluations = 0;
};

/// Evaluates the surface inside and on two edges of cells: of all cells if they are few, else of
/// those whose triangles look worst and of as many spread over the domain. The points are off the
/// cells' middles by up to a tenth of a cell, at random: a surface that oscillates in step with the
/// grid is found out. `opened`: the cells that were not plain.
MeasuredError measure_error(const Surface& surface, const Grid& grid,
                            std::span<const std::size_t> opened, unsigned threads);

}  // namespace saddle
