// Roots, exponentials, logarithms and trigonometry of intervals: ends of monotone pieces, and the
// turning points and poles between them.
#include "eval/interval.h"

#include <algorithm>
#include <cmath>

#include "eval/interval_rules.h"

namespace saddle {

using namespace rounding;

namespace {

constexpr double kPi = 3.141592653589793238462643;
constexpr double kTwoOverPi = 0.6366197723675813430755351;

/// Above pi: the double kPi is below it.
constexpr double kPiUp = kPi * (1 + kLibrary);

/// Beyond this angle a box is not placed within a turn: the guard below would be a thousandth of a
/// quarter there, and surfaces do not go that far.
constexpr double kLargestAngle = 0x1p40;

}  // namespace

Interval sqrt(const Interval& a) {
  const Interval inside = restricted(a, 0, kInfinity);
  return rising(inside, std::sqrt, kRoundoff);
}

Interval cbrt(const Interval& a) {
  return rising(a, std::cbrt, kCbrtLibrary);
}

Interval hypot(const Interval& a, const Interval& b) {
  Interval r = with_decorations_of(a, b);
  if (r.defined == Defined::No) return kUndefined;
  r.low = down(std::hypot(least_size(a), least_size(b)), kLibrary);
  const double high = std::hypot(largest_size(a), largest_size(b));
  r.high = up(high, kLibrary);
  return r;
}

Interval exp(const Interval& a) {
  Interval r = rising(a, std::exp, kLibrary);
  if (r.defined != Defined::No) r.high = std::max(r.high, kUnderflow);  // never 0
  return r;
}

namespace {

/// A logarithm: falls to -inf at 0, where it is undefined.
Interval logarithm(const Interval& a, double (*f)(double), double error) {
  if (a.high <= 0) return kUndefined;
  Interval inside = restricted(a, 0, kInfinity);
  if (inside.low == 0) inside.defined = std::min(inside.defined, Defined::Maybe);
  return rising(inside, f, error);
}

}  // namespace

Interval log(const Interval& a) {
  return logarithm(a, std::log, kLibrary);
}
Interval log2(const Interval& a) {
  return logarithm(a, std::log2, kLibrary);
}
Interval log10(const Interval& a) {
  return logarithm(a, std::log10, kLooseLibrary);
}

namespace {

/// A box of angles in quarter turns, widened by the error of the quotient.
struct Quarters {
  double low;
  double high;

  explicit Quarters(const Interval& a)
      // Relative errors of 2/pi, of the product and of the operations after it: 2^-53 each.
      : low(a.low * kTwoOverPi - 4 * kRoundoff * std::fabs(a.low)),
        high(a.high * kTwoOverPi + 4 * kRoundoff * std::fabs(a.high)) {}

  /// May hold first + k * period quarters for a whole k.
  bool hold(double first, double period) const {
    return std::floor((high - first) / period) * period + first >= low;
  }
};

bool is_placeable(const Interval& a) {
  return a.low >= -kLargestAngle && a.high <= kLargestAngle;
}

/// A wave that is 1 at `crest` quarters and -1 two quarters on.
Interval wave(const Interval& a, double (*f)(double), double crest) {
  if (a.defined == Defined::No) return kUndefined;
  Interval r = {-1, 1, a.defined, a.continuous};
  if (!is_placeable(a)) return r;
  const Quarters quarters(a);
  if (quarters.high - quarters.low >= 4) return r;
  const bool top = quarters.hold(crest, 4);
  const bool bottom = quarters.hold(crest + 2, 4);
  if (top && bottom) return r;
  const double x = f(a.low);
  const double y = f(a.high);
  if (!bottom) r.low = std::max(-1.0, down(std::min(x, y), kLibrary));
  if (!top) r.high = std::min(1.0, up(std::max(x, y), kLibrary));
  return r;
}

}  // namespace

Interval sin(const Interval& a) {
  return wave(a, std::sin, 1);
}
Interval cos(const Interval& a) {
  return wave(a, std::cos, 0);
}

Interval tan(const Interval& a) {
  if (a.defined == Defined::No) return kUndefined;
  if (!is_placeable(a) || Quarters(a).hold(1, 2)) {
    return {-kInfinity, kInfinity, Defined::Maybe, false};
  }
  return rising(a, std::tan, kLibrary);
}

Interval asin(const Interval& a) {
  return rising(restricted(a, -1, 1), std::asin, kLibrary);
}
Interval acos(const Interval& a) {
  return falling(restricted(a, -1, 1), std::acos, kLibrary);
}
Interval atan(const Interval& a) {
  return rising(a, std::atan, kLibrary);
}

namespace {

/// The angles of a box that lies in x >= 0 and does not hold the origin.
Interval angle_right(const Interval& y, const Interval& x) {
  Interval r;
  r.low = std::atan2(y.low, y.low >= 0 ? x.high : x.low);
  r.high = std::atan2(y.high, y.high >= 0 ? x.low : x.high);
  return r;
}

/// The angles of a box that lies in y > 0.
Interval angle_above(const Interval& y, const Interval& x) {
  Interval r;
  r.low = std::atan2(x.high >= 0 ? y.low : y.high, x.high);
  r.high = std::atan2(x.low >= 0 ? y.high : y.low, x.low);
  return r;
}

}  // namespace

Interval atan2(const Interval& a, const Interval& b) {
  Interval r = with_decorations_of(a, b);
  if (r.defined == Defined::No) return kUndefined;
  if (b.low <= 0 && contains(a, 0)) {
    // The cut, from either side: the sign of a zero decides in doubles. At the origin it is 0.
    return {-kPiUp, kPiUp, r.defined, false};
  }
  const Interval angle = b.low >= 0  ? angle_right(a, b)
                         : a.low > 0 ? angle_above(a, b)
                                     : -angle_above(-a, b);
  r.low = down(angle.low, kLibrary);
  r.high = up(angle.high, kLibrary);
  // Where a/b underflows the computed angle is 0.
  if (a.low < 0) r.low = std::min(r.low, -kUnderflow);
  if (a.high > 0) r.high = std::max(r.high, kUnderflow);
  return r;
}

Interval sinh(const Interval& a) {
  return rising(a, std::sinh, kLooseLibrary);
}

Interval cosh(const Interval& a) {
  if (a.defined == Defined::No) return kUndefined;
  const Interval sizes = {least_size(a), largest_size(a), a.defined, a.continuous};
  const Interval r = rising(sizes, std::cosh, kLooseLibrary);
  return clamped(r, 1, kInfinity);
}

Interval tanh(const Interval& a) {
  return clamped(rising(a, std::tanh, kLooseLibrary), -1, 1);
}

Interval asinh(const Interval& a) {
  return rising(a, std::asinh, kLooseLibrary);
}

Interval acosh(const Interval& a) {
  const Interval inside = restricted(a, 1, kInfinity);
  return rising(inside, std::acosh, kLooseLibrary);
}

Interval atanh(const Interval& a) {
  if (a.high <= -1 || a.low >= 1) return kUndefined;
  Interval inside = restricted(a, -1, 1);
  if (inside.low == -1 || inside.high == 1) {
    inside.defined = std::min(inside.defined, Defined::Maybe);
  }
  return rising(inside, std::atanh, kLooseLibrary);
}

}  // namespace saddle
