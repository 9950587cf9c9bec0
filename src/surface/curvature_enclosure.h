// Interval bounds of a surface's position and curvatures over boxes of parameters.
// Source: M. P. do Carmo, "Differential geometry of curves and surfaces", 1976, section 3.3.
#pragma once

#include "surface/surface_enclosure.h"

namespace saddle {

/// Bounds over a box. Curvatures are those of the surface's front, at its regular points.
struct CurvatureBounds {
  std::array<Interval, 3> position;
  Interval gauss, mean;
};

/// For a surface of second order. One for each thread.
class CurvatureEnclosure {
 public:
  explicit CurvatureEnclosure(const Surface& surface)
      : enclosure_(surface, Bounded::SecondDerivatives), flip_(surface.flip) {}

  CurvatureBounds enclose(const ParameterBox& box);

 private:
  SurfaceEnclosure enclosure_;
  bool flip_;
};

}  // namespace saddle
