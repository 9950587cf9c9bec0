// The colours of exported meshes that several formats share.
#pragma once

#include <cstddef>
#include <span>

#include "base/image.h"
#include "base/vec.h"
#include "scene/model/color_scale.h"

namespace saddle {

/// The colour of what has no number.
inline constexpr double kUndefinedGrey = 0.5;

/// Red, green and blue alone.
dvec3 rgb_of(const Color& color);

/// One band of 256 colours for each scale, the first one on top. Bands are several pixels high, so
/// that a colour does not mix with the next band's.
Image colormap_image(std::span<const ColorScale> scales);

/// Where a place on a scale, 0 to 1, is in that picture, from its upper left corner, 0 to 1: in the
/// middle of the band, between the middles of its first and last pixel. `row`: of the scale, one of
/// `rows`.
dvec2 place_in_image(double place, std::size_t row, std::size_t rows);

}  // namespace saddle
