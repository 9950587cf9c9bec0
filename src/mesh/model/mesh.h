// A triangle mesh as plain arrays. Topology and attributes are apart: a corner has its own u, v
// and normal; corners that are the same point of the surface share a point number.
#pragma once

#include <array>
#include <cmath>
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

struct Mesh {
  // One entry per corner.
  Array<dvec3> position;
  Array<dvec3> normal;            ///< unit; front is where it points
  Array<dvec2> uv;                ///< the parameters of this side of the surface
  Array<std::uint32_t> point;     ///< which point of the surface the corner is; see point_count
  std::uint32_t point_count = 0;  ///< corners of one point have bitwise equal positions

  /// Corner indices, counter-clockwise seen from the front.
  Array<Triangle> triangles;

  /// The number that the surface is coloured by at each corner, NaN or infinite where undefined:
  /// at all three corners of a triangle or at none. Empty where the surface is not coloured.
  Array<double> color;
  ColorRange color_range;

  /// The scene's grid lines, each a chain of corners along edges of the mesh.
  std::vector<std::vector<std::uint32_t>> lines;

  Bounds bounds;
};

/// Nothing if the mesh is not coloured.
inline std::optional<ColorRange> color_range_of(const Mesh& mesh) {
  if (mesh.color.empty()) return std::nullopt;
  return mesh.color_range;
}

}  // namespace saddle
