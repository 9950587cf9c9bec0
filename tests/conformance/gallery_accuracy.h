// How far the gallery's positions and normals are from the truth: the formulas as they are typed,
// with the real pi, in 50 digits.
#pragma once

#include <cstdint>
#include <string>

#include "scene/model/gallery.h"

namespace saddle::testing {

/// The largest errors at random interior points of a surface.
struct GalleryAccuracy {
  std::string name;
  int points = 0;              ///< those where the truth is finite
  double box_ulps = 0;         ///< of positions, in last places of the surface's largest coordinate
  double point_ulps = 0;       ///< of positions, in last places of the point's largest coordinate
  double rounding = 0;         ///< of positions, as a share of what rounding may do (RoundingBound)
  int normals = 0;             ///< points that have one
  double degrees = 0;          ///< of normals
  double normal_rounding = 0;  ///< of normals, as a share of what rounding of tangents may do
};

GalleryAccuracy measure_accuracy(const GalleryEntry& entry, int points, std::uint64_t seed);

}  // namespace saddle::testing
