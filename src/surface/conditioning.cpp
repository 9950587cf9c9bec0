#include "surface/conditioning.h"

#include <algorithm>
#include <vector>

#include "surface/normal.h"

namespace saddle {

double usual_length(std::span<const SurfacePoint> points, dvec3 SurfacePoint::*tangent) {
  std::vector<double> lengths;
  for (const SurfacePoint& p : points) {
    if (is_finite(p.*tangent)) lengths.push_back(safe_length(p.*tangent));
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + std::ssize(lengths) / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace saddle
