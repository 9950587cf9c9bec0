// Triangulation of simple polygons by ear clipping.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

struct Grid;

/// A corner of the mesh, and its place in units of the cell tree.
struct PolygonCorner {
  std::uint32_t corner;
  dvec2 place;
};

using Polygon = std::vector<PolygonCorner>;

/// Bound on the distance of a feature's place from its side, in units of the cell tree. The place
/// is an interpolation between the ends of the side, which are exact.
inline double rounding_of_place(const dvec2& place) {
  return 4 * std::numeric_limits<double>::epsilon() *
         std::max(std::fabs(place.x), std::fabs(place.y));
}

/// Twice the signed area of a triangle in the plane. Exact for dyadic points, which are less than
/// 2^17 units apart within a root cell.
inline double doubled_area(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Where the ray from `from`, inside of the unit square, along `way` meets the square's border.
dvec2 border_of_square(const dvec2& from, const dvec2& way);

/// Twice the signed area of a polygon in the plane.
double doubled_area_of(std::span<const PolygonCorner> polygon);
/// Whether a polygon has an area, and not one of rounding alone.
bool has_area(std::span<const PolygonCorner> polygon);

/// Cuts a polygon where it touches itself, as sectors do that meet at a corner of a leaf: where two
/// of its corners are within the distance `same` in the plane, and both parts have an area. Appends
/// the parts that are cut off to `others`.
void cut_off_pinched(double same, Polygon& polygon, std::vector<Polygon>& others);

/// Polygons between two rows of segments, which are on two sides of a polygon. A row has two
/// corners for each segment, on the way around. Where one has more segments, triangles take them
/// up.
std::vector<Polygon> strips_between(std::span<const PolygonCorner> a,
                                    std::span<const PolygonCorner> b);

/// Triangulates a simple polygon, counter-clockwise in (u, v); several corners may lie on one
/// straight side. Cuts off ears of positive area in (u, v), the ear with the lowest arc first.
/// Appends to `triangles`, counter-clockwise seen from the front, without triangles that have no
/// area in space.
void triangulate_polygon(const Grid& grid, Polygon polygon, Array<Triangle>& triangles);

}  // namespace saddle
