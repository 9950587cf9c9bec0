// The range of the numbers that a surface is coloured by.
#pragma once

#include <optional>

#include "base/bounds.h"
#include "mesh/model/color_range.h"

namespace saddle {

/// Sides are first halved until none is longer than 1/24 of the ranges of u and v: samples on them
/// are then close enough for most formulas. Searches for the ends of the colours' range begin with
/// steps of this length.
inline constexpr double kFirstSide = 1.0 / 24;

struct Mesh;
struct Surface;

struct DrawnColors {
  ColorRange range;
  ColorRange all;           ///< the same with infinite ends where the numbers go to infinity
  bool is_clamped = false;  ///< the numbers go to infinity
};

/// The range of the numbers on the drawn surface, by a compass search from the mesh's corners with
/// the least and the largest number. At an end where numbers go to infinity, the range leaves out 5
/// % of the area. It is a single number if numbers differ by at most `rounding` over 90 % of the
/// area, or by rounding of doubles over all of it. `clip`: the box that the mesh was cut along.
/// Nothing if no number is finite.
std::optional<DrawnColors> drawn_colors(const Surface& surface, const Mesh& mesh, double rounding,
                                        const std::optional<Bounds>& clip = {});

}  // namespace saddle
