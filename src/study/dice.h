// A surface cut into triangles of about a pixel, as they are seen.
#pragma once

#include <array>
#include <vector>

#include "study/subject.h"

namespace saddle {

/// From the surface to the picture: pixels from the lower left, and a depth that grows away from
/// the eye.
class Projection {
 public:
  explicit Projection(const Subject& subject);

  /// NaN behind the eye.
  dvec3 operator()(const dvec3& p) const;

  /// Where a point is seen, and how that moves with u and v, in pixels.
  struct Seen {
    dvec2 at, by_u, by_v;
  };
  Seen operator()(const SurfacePoint& p) const;

 private:
  glm::dmat4 to_clip_;
  dvec2 size_;
};

struct DicedTriangle {
  std::array<dvec3, 3> seen;
  std::array<dvec2, 3> uv;
};

/// The visible triangles of the surface. Cells across which it jumps are left out; cells at its
/// boundary end there.
std::vector<DicedTriangle> dice(const Subject& subject, const Projection& projection);

}  // namespace saddle
