// The point of a surface under a pixel.
#pragma once

#include <optional>

#include "mesh/model/mesh.h"
#include "surface/surface.h"
#include "view/model/controls.h"
#include "view/model/triangle_boxes.h"

namespace saddle {

/// Where a line of sight meets a mesh first.
struct Hit {
  double distance = 0;  ///< along the line, from its origin
  dvec2 uv;             ///< linear in the triangle
};

/// The nearest hit, if any; from either side of the triangles. `boxes`: around those of the mesh.
/// Source: T. Moeller, B. Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
std::optional<Hit> first_hit(const Mesh& mesh, const TriangleBoxes& boxes, const Ray& ray);

/// A point of the surface itself, not of its mesh.
struct SurfacePlace {
  dvec2 uv;
  dvec3 position;
  std::optional<dvec3> normal;  ///< nothing at a singular point
  Curvature curvature;          ///< for a surface of second order
};

/// Where the line of sight meets the surface, near a hit of its mesh: Newton's method in u and v.
/// If that leads away from the hit, the surface at the hit's u and v.
SurfacePlace place_on_surface(const Surface& surface, const Ray& ray, const Hit& hit);

/// The surface at the user's u and v; nothing outside its domain and where it is undefined.
std::optional<SurfacePlace> place_at(const Surface& surface, const dvec2& uv);

}  // namespace saddle
