// A triangle mesh as plain arrays: the result of the mesher, and what everything after it reads.
// Topology and attributes are apart: a corner has its own position, normal, u and v, and a point
// number. Corners that are the same point of the surface (on a seam, a crease, a pole) share it.
// This room holds the mesh, its report, and operations that need no surface.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/array.h"
#include "base/bounds.h"
#include "base/vec.h"
#include "mesh/model/color_range.h"

namespace saddle {

/// Three corners.
using Triangle = std::array<std::uint32_t, 3>;

/// Level lines. Each vertex has two places: the true one, and that of the same parameters on the
/// triangles, which may be above it by the mesh's error.
struct MeshContours {
  std::vector<dvec3> position;
  std::vector<dvec3> on_mesh;
  std::vector<dvec3> normal;                      ///< of the triangles there, unit
  std::vector<std::vector<std::uint32_t>> lines;  ///< chains of vertices
};

/// The triangles of a solid, in their order: the copy of the surface in front of it, with its
/// front outside; that behind it, with its back outside; walls between them.
struct SolidParts {
  std::size_t front = 0;  ///< how many
  std::size_t back = 0;
  std::size_t walls = 0;
};

struct Mesh {
  // One entry per corner.
  Array<dvec3> position;
  Array<dvec3> normal;            ///< unit; front is where it points
  Array<dvec2> uv;                ///< the parameters of this side of the surface
  Array<std::uint32_t> point;     ///< number of the corner's point, below point_count
  std::uint32_t point_count = 0;  ///< corners of one point have bitwise equal positions

  /// Corner indices, counter-clockwise seen from the front.
  Array<Triangle> triangles;

  /// The number at each corner that gives its colour. It is not finite where it is undefined: at
  /// all three corners of a triangle or at none. Empty where the surface is not coloured.
  Array<double> color;
  ColorRange color_range;

  /// The scene's grid lines, each a chain of corners along edges of the mesh.
  std::vector<std::vector<std::uint32_t>> lines;

  MeshContours contours;

  std::optional<SolidParts> solid;  ///< of a surface with a thickness

  Bounds bounds;
  std::optional<dvec3> anchor;  ///< where its label stands, if there is one
};

/// Empty if the mesh is not coloured.
inline std::optional<ColorRange> color_range_of(const Mesh& mesh) {
  if (mesh.color.empty()) return std::nullopt;
  return mesh.color_range;
}

}  // namespace saddle
