// Quotients, comparisons, choices, steps and kinks of intervals.
#include "eval/interval.h"

#include <algorithm>
#include <cmath>

#include "eval/interval_rules.h"

#include "formula/special.h"

namespace saddle {

using namespace rounding;

namespace {

constexpr Interval kTrue = {1, 1, Defined::Yes, true};
constexpr Interval kFalse = {0, 0, Defined::Yes, true};
constexpr Interval kEither = {0, 1, Defined::Yes, false};

bool is_zero(const Interval& a) {
  return a.low == 0 && a.high == 0;
}

}  // namespace

Interval constant_interval(double value) {
  if (std::isnan(value)) return kUndefined;
  if (value == kInfinity) return {kMax, kInfinity, Defined::Maybe, false};
  if (value == -kInfinity) return {-kInfinity, -kMax, Defined::Maybe, false};
  return {value, value, Defined::Yes, true};
}

Interval hull(const Interval& a, const Interval& b) {
  const Defined defined = a.defined == b.defined ? a.defined : Defined::Maybe;
  return {std::min(a.low, b.low), std::max(a.high, b.high), defined, a.continuous && b.continuous};
}

Interval narrow(const Interval& natural, const Interval& by_mean_value, const Interval& function) {
  constexpr double kRounding = 100 * rounding::kRoundoff;
  const bool is_proved = by_mean_value.defined == Defined::Yes && is_continuous(function);
  if (!is_proved) return natural;
  const double size = std::max(std::fabs(function.low), std::fabs(function.high));
  const double error = 2 * kRounding * size;
  const double low = std::max(natural.low, rounding::sum_down(by_mean_value.low, -error));
  const double high = std::min(natural.high, rounding::sum_up(by_mean_value.high, error));
  if (!(low <= high)) return natural;
  return {low, high, Defined::Yes, true};
}

namespace rounding {

Interval careful_product(const Interval& a, const Interval& b) {
  Interval r = with_decorations_of(a, b);
  if (is_zero(a) || is_zero(b)) return r;
  // Infinity stands for numbers of any size, so 0 times it is 0.
  const auto product = [](double x, double y) { return x == 0 || y == 0 ? 0 : x * y; };
  const double p = product(a.low, b.low);
  const double q = product(a.low, b.high);
  const double s = product(a.high, b.low);
  const double t = product(a.high, b.high);
  const double low = std::min(std::min(p, q), std::min(s, t));
  const double high = std::max(std::max(p, q), std::max(s, t));
  // The signs of the factors decide where the product underflows and its sign may be lost.
  const bool positive = (a.low >= 0 && b.low >= 0) || (a.high <= 0 && b.high <= 0);
  const bool negative = (a.low >= 0 && b.high <= 0) || (a.high <= 0 && b.low >= 0);
  const double error = product_error(a, b);
  const bool tiny_low = std::fabs(low) < kUnderflow;
  const bool tiny_high = std::fabs(high) < kUnderflow;
  r.low = !tiny_low ? down(low, error) : positive ? 0 : -kUnderflow;
  r.high = !tiny_high ? up(high, error) : negative ? 0 : kUnderflow;
  return r;
}

}  // namespace rounding

Interval sqr(const Interval& a) {
  if (a.defined == Defined::No) return kUndefined;
  const double least = least_size(a);
  const double most = largest_size(a);
  const double error = product_error(a, a);
  Interval r = a;
  r.low = down(least * least, error);
  r.high = most == 0 ? 0 : std::max(up(most * most, error), kUnderflow);
  return r;
}

namespace {

/// The error of a quotient: none where 53 bits hold its product with the divisor, and that is the
/// dividend. A jump of floor(u/2) at u = 2 is nowhere else.
double quotient_error(double quotient, double dividend, double divisor) {
  const bool is_exact =
      trailing_zeros(quotient, quotient) + trailing_zeros(divisor, divisor) >= 53 &&
      quotient * divisor == dividend;
  return is_exact ? 0 : kRoundoff;
}

/// a / b for b > 0, or for b >= 0 with b.high > 0: where b is 0 it is left out.
Interval quotient_by_positive(const Interval& a, const Interval& b) {
  Interval r = with_decorations_of(a, b);
  if (is_zero(a)) return r;
  // Only an end of a with the sign that b = 0 makes endless is divided by b.low.
  const double below = a.low < 0 ? b.low : b.high;
  const double above = a.high > 0 ? b.low : b.high;
  const double low = a.low / below;
  const double high = a.high / above;
  const bool tiny_low = std::fabs(low) < kUnderflow;
  const bool tiny_high = std::fabs(high) < kUnderflow;
  r.low = !tiny_low ? down(low, quotient_error(low, a.low, below)) : a.low >= 0 ? 0 : -kUnderflow;
  r.high = !tiny_high    ? up(high, quotient_error(high, a.high, above))
           : a.high <= 0 ? 0
                         : kUnderflow;
  return r;
}

/// a / b where b holds 0: a pole, or 0/0. An infinity is no value, but min(u/0, 1) may be one.
Interval quotient_with_pole(const Interval& a, const Interval& b) {
  if (is_zero(a) && is_zero(b)) return kUndefined;
  Interval r = {-kInfinity, kInfinity, Defined::Maybe, false};
  if (is_zero(b)) return r;
  const Interval positive = {0, std::max(b.high, -b.low)};
  if (is_zero(a)) {
    r.low = r.high = 0;
  } else if (b.low == 0 || b.high == 0) {
    const Interval numerator = b.low == 0 ? a : -a;
    // 0 / 0 of an end is the limit of 0 / b, which is 0.
    if (numerator.low >= 0) r.low = quotient_by_positive({numerator.low, kMax}, positive).low;
    if (numerator.high <= 0) r.high = quotient_by_positive({-kMax, numerator.high}, positive).high;
  }
  return r;
}

}  // namespace

Interval operator/(const Interval& a, const Interval& b) {
  if (std::min(a.defined, b.defined) == Defined::No) return kUndefined;
  if (b.low > 0) return quotient_by_positive(a, b);
  if (b.high < 0) return quotient_by_positive(-a, -b);
  return quotient_with_pole(a, b);
}

namespace {

/// Undefined values compare as false in doubles, or as infinities do.
bool comparable(const Interval& a, const Interval& b) {
  return std::min(a.defined, b.defined) == Defined::Yes;
}

/// A condition: kTrue where it is not 0. NaN is true, and infinities may have come back from NaN's
/// place, so nothing is said about what may be undefined.
Interval truth(const Interval& a) {
  if (a.defined != Defined::Yes) return kEither;
  if (!contains(a, 0)) return kTrue;
  return is_zero(a) ? kFalse : kEither;
}

Interval negated(const Interval& truth) {
  return {1 - truth.high, 1 - truth.low, Defined::Yes, truth.continuous};
}

}  // namespace

Interval operator<(const Interval& a, const Interval& b) {
  if (!comparable(a, b)) return kEither;
  if (a.high < b.low) return kTrue;
  return a.low >= b.high ? kFalse : kEither;
}

Interval operator<=(const Interval& a, const Interval& b) {
  if (!comparable(a, b)) return kEither;
  if (a.high <= b.low) return kTrue;
  return a.low > b.high ? kFalse : kEither;
}

Interval operator==(const Interval& a, const Interval& b) {
  if (!comparable(a, b)) return kEither;
  if (a.high < b.low || b.high < a.low) return kFalse;
  return is_point(a) && is_point(b) ? kTrue : kEither;
}

Interval operator!=(const Interval& a, const Interval& b) {
  return negated(a == b);
}

Interval both(const Interval& a, const Interval& b) {
  const Interval x = truth(a);
  const Interval y = truth(b);
  if (x.high == 0 || y.high == 0) return kFalse;
  return x.low == 1 && y.low == 1 ? kTrue : kEither;
}

Interval either(const Interval& a, const Interval& b) {
  return negated(both(negated(truth(a)), negated(truth(b))));
}

Interval select(const Interval& a, const Interval& b, const Interval& c) {
  const Interval condition = truth(a);
  if (condition.low == 1) return b;
  if (condition.high == 0) return c;
  Interval r = hull(b, c);
  // Equal bounds are not equal values, unless there is only one.
  r.continuous = r.continuous && is_point(r) && r.defined == Defined::Yes;
  return r;
}

Interval abs(const Interval& a) {
  if (a.low >= 0 || a.defined == Defined::No) return a;
  if (a.high <= 0) return -a;
  return {0, std::max(-a.low, a.high), a.defined, a.continuous};
}

namespace {

/// A function that is constant but for upward jumps, and its own bound at the ends.
Interval stepped(const Interval& a, double (*step)(double)) {
  if (a.defined == Defined::No) return kUndefined;
  const double low = step(a.low);
  const double high = step(a.high);
  // Where it is constant it is continuous whatever the argument is.
  return {low, high, a.defined, low == high};
}

}  // namespace

Interval sign(const Interval& a) {
  return stepped(a, saddle::sign);
}
Interval floor(const Interval& a) {
  return stepped(a, std::floor);
}
Interval ceil(const Interval& a) {
  return stepped(a, std::ceil);
}
Interval round(const Interval& a) {
  return stepped(a, std::round);
}
Interval rint(const Interval& a) {
  // The evaluator rounds a + 1/2, up to a whole number where a is just below a half.
  return floor(a + Interval{0.5, 0.5});
}
Interval trunc(const Interval& a) {
  return stepped(a, std::trunc);
}

Interval mod(const Interval& a, const Interval& b) {
  const Interval steps = floor(a / b);
  if (is_zero(b) || steps.defined == Defined::No) return kUndefined;
  const Interval multiple = b * steps;
  Interval r = a - multiple;
  if (std::isinf(multiple.low) || std::isinf(multiple.high)) return r;  // what overflows stays lost
  // With the sign of b and smaller, but for the evaluator's roundings: a/b and b*floor may be off
  // by an ULP, which is a matter of kRoundoff |a| after the subtraction; where a/b underflows to 0
  // the result is a.
  const double size = largest_size(a);
  const double tiny = std::min(size, kUnderflow * largest_size(b));
  const double slack = 4 * kRoundoff * size + tiny + kUnderflow;
  r.low = std::max(r.low, sum_down(std::min(b.low, 0.0), -slack));
  r.high = std::min(r.high, sum_up(std::max(b.high, 0.0), slack));
  return r;
}

Interval min(const Interval& a, const Interval& b) {
  Interval r = with_decorations_of(a, b);
  if (r.defined == Defined::No) return kUndefined;
  r.low = std::min(a.low, b.low);
  r.high = std::min(a.high, b.high);
  return r;
}

Interval max(const Interval& a, const Interval& b) {
  return -min(-a, -b);
}

}  // namespace saddle
