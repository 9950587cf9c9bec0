// Powers of intervals: whole exponents, of any base, and others, of bases that are not negative.
#include "eval/interval.h"

#include <algorithm>
#include <cmath>

#include "eval/interval_rules.h"

namespace saddle {

using namespace rounding;

namespace {

/// Whole exponents up to this size are multiplied out, in the order of eval/tape's products: so the
/// rounded products of the evaluator lie between products that are rounded outward.
constexpr double kMaxProductExponent = 16;

bool is_whole(double x) {
  return std::floor(x) == x && std::fabs(x) < kInfinity;
}

bool is_odd(double n) {
  return std::fmod(n, 2) != 0;
}

/// base^n for base >= 0, n > 0, with every product rounded outward.
Interval product_power(const Interval& base, double n) {
  Interval result = {1, 1};
  Interval square = base;
  for (int rest = static_cast<int>(n);; rest /= 2) {
    if (rest % 2 == 1) result = result * square;
    if (rest == 1) return result;
    square = sqr(square);
  }
}

/// base^n for base >= 0, n > 0.
Interval positive_power(const Interval& base, double n) {
  if (n <= kMaxProductExponent) return product_power(base, n);
  Interval r = rising(
      base, [n](double x) { return std::pow(x, n); }, kLibrary);
  if (base.high > 0) r.high = std::max(r.high, kUnderflow);
  return r;
}

/// a^n for whole n > 0.
Interval rising_whole_power(const Interval& a, double n) {
  if (n == 2) return sqr(a);
  if (a.low >= 0) return positive_power(a, n);
  if (a.high <= 0) return is_odd(n) ? -positive_power(-a, n) : positive_power(-a, n);
  const Interval above = {0, a.high, a.defined, a.continuous};
  const Interval below = {0, -a.low, a.defined, a.continuous};
  const Interval up = positive_power(above, n);
  const Interval down = positive_power(below, n);
  return hull(is_odd(n) ? -down : down, up);
}

Interval whole_power(const Interval& a, double n) {
  const Interval one = {1, 1, a.defined, a.continuous};
  if (n == 0) return one;
  return n > 0 ? rising_whole_power(a, n) : one / rising_whole_power(a, -n);
}

/// a^b for a >= 0: monotone in either argument, so the corners have the extremes.
Interval corner_power(const Interval& a, const Interval& b) {
  Interval r = with_decorations_of(a, b);
  const double p = std::pow(a.low, b.low);
  const double q = is_point(b) ? p : std::pow(a.low, b.high);
  const double s = std::pow(a.high, b.low);
  const double t = is_point(b) ? s : std::pow(a.high, b.high);
  r.low = down(std::min(std::min(p, q), std::min(s, t)), kLibrary);
  r.high = up(std::max(std::max(p, q), std::max(s, t)), kLibrary);
  if (a.high > 0) r.high = std::max(r.high, kUnderflow);
  if (a.low > 0) return r;
  // 0^0 is 1, and near it is every number of [0, 1]. 0 to a negative power is a pole.
  if (b.low <= 0) r.continuous = false;
  if (b.low < 0) r.defined = std::min(r.defined, Defined::Maybe);
  return r;
}

bool has_whole_number(const Interval& b) {
  return std::floor(b.high) >= b.low;
}

Interval general_power(const Interval& a, const Interval& b) {
  const bool only_zero = a.high == 0;
  if (a.high < 0 || (only_zero && b.high < 0)) {
    // Negative numbers have no powers but whole ones, and those of 0 are infinite.
    if (only_zero && a.low == 0) return {0, kInfinity, Defined::Maybe, false};
    if (!has_whole_number(b)) return kUndefined;
  }
  Interval r = kUndefined;
  if (a.high >= 0) r = corner_power({std::max(a.low, 0.0), a.high, a.defined, a.continuous}, b);
  if (a.low >= 0) return r;
  if (has_whole_number(b)) {
    const Interval sizes = {std::max(-a.high, 0.0), -a.low, a.defined, false};
    const Interval size = corner_power(sizes, b);
    r = hull(r, hull(size, -size));
    r.continuous = false;
  }
  r.defined = std::min(r.defined, Defined::Maybe);
  return r;
}

/// 1 to any power and any power 0 are 1 in doubles, of NaN too: the result may be defined.
bool may_be_one_of_nan(const Interval& a, const Interval& b) {
  return (a.defined != Defined::Yes && contains(b, 0)) ||
         (b.defined != Defined::Yes && contains(a, 1));
}

}  // namespace

Interval pow(const Interval& a, const Interval& b) {
  Interval r = kUndefined;
  if (std::min(a.defined, b.defined) != Defined::No) {
    r = is_point(b) && is_whole(b.low) ? whole_power(a, b.low) : general_power(a, b);
    r.defined = std::min(r.defined, b.defined);
    r.continuous = r.continuous && b.continuous;
  }
  if (!may_be_one_of_nan(a, b)) return r;
  r = hull(r, {1, 1});
  r.defined = Defined::Maybe;
  r.continuous = false;
  return r;
}

}  // namespace saddle
