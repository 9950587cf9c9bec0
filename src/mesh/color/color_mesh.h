// Colours on a mesh: evaluates a surface's colour expression at the corners, and halves triangles
// until linear interpolation between corners is right to 1/256 of the colour range. It also finds
// the range, from the least to the largest number drawn (mesh/color/drawn_colors). Edges are
// marked and halved for all triangles beside them, so that the mesh stays conforming.
#pragma once

#include <cstddef>
#include <optional>

#include "mesh/model/mesh.h"
#include "surface/surface.h"

namespace saddle {

/// Steps from the first to the last colour.
inline constexpr double kColorSteps = 256;

struct ColorOptions {
  double least_edge = 0;                 ///< edges no longer than this are not halved
  double rounding = 0;                   ///< numbers that differ by no more are equal
  std::optional<ColorRange> range = {};  ///< of the colours; default: of the numbers
  std::optional<Bounds> clip = {};       ///< the box that the mesh was cut along
  std::size_t max_triangles = 4'000'000;
  unsigned threads = 0;
};

struct ColorReport {
  bool is_clamped = false;     ///< the numbers go to infinity: the range holds most of them
  bool reached_limit = false;  ///< max_triangles was reached
  double undefined_share = 0;  ///< part of the area without a number
};

/// Gives `mesh`, of a surface that has a colour, its numbers and their range. Triangles are halved
/// where the numbers bend, along straight edges: the mesh keeps its shape, and lines go through the
/// new corners. A point without a number takes its limit, if there is one; else its triangles have
/// no numbers. Infinite numbers are beyond the ends of the range. If no number is finite, there is
/// none.
ColorReport color_mesh(const Surface& surface, const ColorOptions& options, Mesh& mesh);

}  // namespace saddle
