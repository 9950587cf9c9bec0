#include "render/gl/model_frame.h"

#include <algorithm>

namespace saddle {
namespace {

/// A side that is less than this part of a mesh has its own unit: 16 of a float's 24 bits are left
/// for it in the common one, a quarter of a pixel where it fills the largest picture.
constexpr double kSlender = 1.0 / 256;

}  // namespace

ModelFrame model_frame(const Bounds& bounds) {
  if (bounds.empty()) return {};
  const dvec3 half = 0.5 * bounds.size();
  const double length = std::hypot(half.x, half.y, half.z);
  const double size = length > 0 ? length : 1;
  ModelFrame frame{bounds.centre(), size, dvec3(size)};
  for (int k = 0; k < 3; ++k) {
    if (std::isnormal(1 / half[k]) && half[k] < kSlender * size) frame.sides[k] = half[k];
  }
  return frame;
}

}  // namespace saddle
