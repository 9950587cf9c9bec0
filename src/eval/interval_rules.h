// Shared parts of the rules for functions of one argument: monotone pieces, domains, error bounds.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "eval/interval_bounds.h"

namespace saddle::rounding {

// The bounds come from the C library, the evaluator's numbers from SLEEF or the C library, so both
// errors count, and half an ULP for the subtraction. The library's are those measured for glibc on
// x86-64 ("Errors in math functions", The GNU C Library manual, 2.36); SLEEF's are 1 ULP.
/// Functions that are within 1 ULP.
inline constexpr double kLibrary = 3 * kRoundoff;
/// Functions that are within 2 ULP: sinh, cosh, tanh, their inverses, log10.
inline constexpr double kLooseLibrary = 6 * kRoundoff;
/// cbrt, within 4 ULP.
inline constexpr double kCbrtLibrary = 9 * kRoundoff;

/// f over a box where it only rises. It is 0 only where that is exact.
template <class Function>
Interval rising(const Interval& a, Function f, double error) {
  if (a.defined == Defined::No) return kUndefined;
  return {down(f(a.low), error), up(f(a.high), error), a.defined, a.continuous};
}

/// The same, for one of the overloads of std::exp and the like.
inline Interval rising(const Interval& a, double (*f)(double), double error) {
  return rising<double (*)(double)>(a, f, error);
}

inline Interval falling(const Interval& a, double (*f)(double), double error) {
  if (a.defined == Defined::No) return kUndefined;
  return {down(f(a.high), error), up(f(a.low), error), a.defined, a.continuous};
}

/// The part of a box of arguments that lies in [low, high], kUndefined if there is none.
inline Interval restricted(const Interval& a, double low, double high) {
  if (a.defined == Defined::No || a.high < low || a.low > high) return kUndefined;
  Interval r = a;
  if (a.low < low || a.high > high) r.defined = Defined::Maybe;
  r.low = std::max(a.low, low);
  r.high = std::min(a.high, high);
  return r;
}

/// The values of a function that never leaves [low, high].
inline Interval clamped(const Interval& a, double low, double high) {
  if (a.defined == Defined::No) return kUndefined;
  return {std::max(a.low, low), std::min(a.high, high), a.defined, a.continuous};
}

/// The least and the largest distance from 0.
inline double least_size(const Interval& a) {
  return contains(a, 0) ? 0 : std::min(std::fabs(a.low), std::fabs(a.high));
}
inline double largest_size(const Interval& a) {
  return std::max(std::fabs(a.low), std::fabs(a.high));
}

}  // namespace saddle::rounding
