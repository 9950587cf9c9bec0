// Scales from numbers to colours. Surfaces with the same formula, colormap and ends
// share a scale.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/color/drawn_colors.h"
#include "scene/model/scene.h"

namespace saddle {

struct ColorScale {
  std::string formula;  ///< what the colours show
  std::string colormap;
  ColorRange range;
  std::optional<ColorEnds> ends = {};  ///< that are asked for
};

/// The scales of a scene in the order of their surfaces; ranges[i] is that of surface i's mesh, if
/// that has one. Without ends that are asked for, a diverging colormap has its middle at 0.
std::vector<ColorScale> color_scales(const Scene& scene,
                                     std::span<const std::optional<ColorRange>> ranges);

/// The one that a coloured surface has.
const ColorScale& scale_of(const SurfaceSpec& spec, std::span<const ColorScale> scales);

/// Where a number is between the ends of a scale, 0 to 1; in the middle of one that has one number.
double place_on(const ColorScale& scale, double number);

/// The colour of a number; grey for NaN, which is undefined.
dvec3 color_of(const ColorScale& scale, double number);

}  // namespace saddle
