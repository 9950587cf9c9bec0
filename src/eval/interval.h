// Interval arithmetic: for each row of formula/ops.def a function that encloses its values over a
// box of arguments, together with what is known about them there: defined? continuous?
// Sources: J. Tupper, "Reliable two-dimensional graphing methods for mathematical formulae with
// two free variables", 2001; IEEE 1788-2015, "Standard for interval arithmetic".
#pragma once

#include <algorithm>
#include <cmath>

#include "eval/interval_bounds.h"

namespace saddle {

/// A number. Infinity becomes a number too large for doubles that is perhaps none: min(u, inf) is
/// a use of it. NaN is kUndefined.
Interval constant_interval(double value);

/// All values of either.
Interval hull(const Interval& a, const Interval& b);

/// The difference of a function at two places: `natural` by its two values, `by_mean_value` by the
/// mean value theorem, which holds if `function`, all values between the places, is defined and
/// continuous. The function's values are taken to have the rounding errors of a hundred steps that
/// do not cancel.
Interval narrow(const Interval& natural, const Interval& by_mean_value, const Interval& function);

namespace rounding {

/// Products with bounds that are infinite, tiny or too large.
Interval careful_product(const Interval& a, const Interval& b);

}  // namespace rounding

// The operations of the table, each by its function column. Comparisons and logic are always
// defined, 1 or 0 or [0, 1]: what is undefined may compare as either. A choice is b where its
// condition a is not 0, else c; both where a may be either. An order is a point.
#define SADDLE_INTERVALS_1 const Interval& a
#define SADDLE_INTERVALS_2 const Interval &a, const Interval &b
#define SADDLE_INTERVALS_3 const Interval &a, const Interval &b, const Interval &c
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, function, ...) \
  Interval function(SADDLE_INTERVALS_##arity);
#include "formula/ops.def"
#undef SADDLE_INTERVALS_1
#undef SADDLE_INTERVALS_2
#undef SADDLE_INTERVALS_3

/// a * a for one and the same a.
Interval sqr(const Interval& a);

inline Interval operator-(const Interval& a) {
  return {-a.high, -a.low, a.defined, a.continuous};
}

inline Interval operator+(const Interval& a, const Interval& b) {
  Interval r = rounding::with_decorations_of(a, b);
  if (r.defined == Defined::No) return kUndefined;
  using rounding::Ends;
  const Ends ends = rounding::sums(Ends{a.low, a.high}, Ends{b.low, b.high});
  r.low = ends[0];
  r.high = ends[1];
  return r;
}

inline Interval operator-(const Interval& a, const Interval& b) {
  return a + -b;
}

inline Interval operator*(const Interval& a, const Interval& b) {
  Interval r = rounding::with_decorations_of(a, b);
  if (r.defined == Defined::No) return kUndefined;
  const double p = a.low * b.low;
  const double q = a.low * b.high;
  const double s = a.high * b.low;
  const double t = a.high * b.high;
  r.low = std::min(std::min(p, q), std::min(s, t));
  r.high = std::max(std::max(p, q), std::max(s, t));
  const double sizes = std::fabs(p) + std::fabs(q) + std::fabs(s) + std::fabs(t);
  const double least = std::min(std::fabs(r.low), std::fabs(r.high));
  const bool plain = sizes <= rounding::kMax && least >= rounding::kUnderflow;  // false for NaN
  if (!plain) return rounding::careful_product(a, b);
  const double error = rounding::product_error(a, b);
  r.low -= std::fabs(r.low) * error;
  r.high += std::fabs(r.high) * error;
  return r;
}

inline Interval operator>(const Interval& a, const Interval& b) {
  return b < a;
}
inline Interval operator>=(const Interval& a, const Interval& b) {
  return b <= a;
}

}  // namespace saddle
