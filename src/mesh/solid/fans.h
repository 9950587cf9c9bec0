// Fans: the triangles around a point that are joined, one after the other. A point at which sheets
// touch, the apex of a double cone, has several. Each fan is a disc or a half disc, so that front
// and back can be told apart on it, also on one-sided surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/solid/joined_sides.h"

namespace saddle {

struct Fans {
  // One entry per corner of a triangle: 3 t + k.
  Array<std::uint32_t> of;     ///< its fan
  Array<std::uint8_t> turned;  ///< the triangle's front is the fan's back
  // One entry per fan.
  Array<std::uint32_t> point;
  /// From the point to where the front goes for each unit of thickness: the front's normal where
  /// the surface is smooth, the mitre at creases, the axis at tips; no longer than kLongestMitre.
  Array<dvec3> direction;
  bool one_sided = false;  ///< some triangle's front is the back of a fan
};

/// A mitre is no longer, in units of the thickness: that of an edge of 29 degrees.
inline constexpr double kLongestMitre = 4;

Fans fans_of(const Mesh& mesh, const JoinedSides& joined);

}  // namespace saddle
