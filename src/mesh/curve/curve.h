// A parametric curve r(s), ready to be evaluated.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "eval/tape.h"
#include "surface/forms.h"

namespace saddle {

struct ParametricCurve {
  double from = 0, to = 1;  ///< the range of s; from > to is a range run backwards
  Tape tape;                ///< x, y, z and their derivatives by s, which is the tape's u
  Tape bounds;              ///< the same for enclosures
};

/// r: nodes that depend on u alone, which stands for s. The derivatives come from the formulas.
ParametricCurve make_curve(Graph& graph, const Coordinates& r, double from, double to);

/// A point of a curve; components are NaN or infinite where undefined.
struct CurvePoint {
  double s = 0;
  dvec3 position{0, 0, 0};
  dvec3 tangent{0, 0, 0};  ///< r'(s)
};

std::vector<CurvePoint> evaluate(const ParametricCurve& curve, std::span<const double> s);

}  // namespace saddle
