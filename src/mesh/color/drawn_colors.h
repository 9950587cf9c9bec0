// From which to which number the colours of a mesh run.
#pragma once

#include <optional>

#include "base/bounds.h"
#include "mesh/model/color_range.h"

namespace saddle {

struct Mesh;
struct Surface;

struct DrawnColors {
  ColorRange range;
  bool is_clamped = false;  ///< the numbers go to infinity
};

/// The range of the numbers on what is drawn of a surface: from the best of its mesh's corners a
/// search goes on to the lowest and the highest one. Toward an end at which they go to infinity the
/// range stops where nine tenths of the area are inside. Where nine tenths of the area differ by no
/// more than `rounding`, or all of it by no more than doubles do, it is a single number. `clip`:
/// the box that the mesh was cut along. Nothing if no number is finite.
std::optional<DrawnColors> drawn_colors(const Surface& surface, const Mesh& mesh, double rounding,
                                        const std::optional<Bounds>& clip = {});

}  // namespace saddle
