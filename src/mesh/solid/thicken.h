// A surface as a solid: two copies of it at a distance, joined by walls along its borders. Closed,
// oriented outward and two-manifold by its making, whatever the surface is. Copies may cross where
// the surface bends more sharply than it is thick: they are left as they are.
#pragma once

#include "mesh/model/mesh.h"

namespace saddle {

/// How far a solid goes from its surface, in the surface's units; not negative, one of them more.
struct Thickening {
  double front = 0;
  double back = 0;

  double total() const { return front + back; }
};

/// The solid of a mesh. Its triangles are those of the front, in their order; those of the back, in
/// the same order with their winding reversed; two for each side on a border: Mesh::solid counts
/// them. Corners keep u, v and colour. The front's have their normals, the back's the opposite
/// ones, walls their own. Lines and contours are on both sides.
/// Throws Error (Input) for a one-sided surface unless both distances are the same: it has no
/// front that all of its thickness could be on.
Mesh thicken(const Mesh& sheet, const Thickening& thickening);

}  // namespace saddle
