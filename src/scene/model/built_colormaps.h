// Colormaps that are computed in the colour space CIELAB: evenly spaced to the eye. White is that
// of sRGB, D65.
#pragma once

#include <array>
#include <cstddef>

#include "base/vec.h"

namespace saddle {

/// Colours of a computed map, evenly spaced, the middle one among them.
inline constexpr std::size_t kBuiltColors = 257;
using BuiltColormap = std::array<dvec3, kBuiltColors>;  ///< red, green, blue, each 0 to 1

/// Lightness 0 to 100, and the two coordinates of hue, of a colour in sRGB. Source: CIE 15:2004;
/// IEC 61966-2-1:1999.
dvec3 lab_of(const dvec3& srgb);

/// The reverse. Colours that sRGB does not have are clamped.
dvec3 srgb_of(const dvec3& lab);

/// Diverging: blue, light grey, red. Lightness grows to the middle and falls again. Source: K.
/// Moreland, "Diverging color maps for scientific visualization", 2009.
BuiltColormap built_coolwarm();

/// Cyclic: light grey, blue, dark purple in the middle, rose, and the first colour again, in equal
/// steps of lightness, alike on both sides. Source: P. Kovesi, "Good colour maps: how to design
/// them", 2015, section on cyclic maps.
BuiltColormap built_twilight();

}  // namespace saddle
