// The number that a surface is coloured by, over its mesh: exact at the corners, and corners close
// enough that between them the straight line tells it to a step of eight bits.
#pragma once

#include <cstddef>
#include <optional>

#include "mesh/model/mesh.h"
#include "surface/surface.h"

namespace saddle {

/// Numbers are told apart in this many steps from the first to the last colour.
inline constexpr double kColorSteps = 256;

struct ColorOptions {
  double least_edge = 0;  ///< edges no longer than this are not halved: nobody sees their middle
  double rounding = 0;    ///< numbers that differ by no more are the same but for rounding
  std::optional<ColorRange> range = {};  ///< of the colours; default: of the numbers
  std::optional<Bounds> clip = {};       ///< the box that the mesh was cut along
  std::size_t max_triangles = 4'000'000;
  unsigned threads = 0;
};

struct ColorReport {
  bool is_clamped = false;  ///< the numbers go to infinity: most of them have a colour of their own
  bool reached_limit = false;  ///< more triangles were not allowed
  double undefined_share = 0;  ///< of the area
};

/// Gives `mesh`, of a surface that has a colour, its numbers and their range. Triangles are halved
/// where the numbers bend, along straight edges: nothing else about the mesh changes but that lines
/// go through the new corners. Points that have no number get its limit, if there is one; triangles
/// at others have none at all. Infinite numbers are beyond the ends of the range; where there are
/// no others, there is no number.
ColorReport color_mesh(const Surface& surface, const ColorOptions& options, Mesh& mesh);

}  // namespace saddle
