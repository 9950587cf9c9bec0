// Special functions of intervals: ends of monotone pieces, convexity (ln|gamma| and some of its
// derivatives are convex between poles), and Taylor's formula for the oscillating ones.
// Source: M. Abramowitz, I. Stegun, "Handbook of mathematical functions", 1964, chapters 6 and 9.
#include "eval/interval.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eval/interval_rules.h"
#include "formula/special.h"

namespace saddle {

using namespace rounding;

namespace {

/// Our recurrences and series and the library's jn and lgamma_r lose some tens of roundings, 1e-14,
/// relative to the largest number on the way; these are ten times as much.
constexpr double kSeries = 1e-13;

/// gamma, within 10 ULP in the C library, 1 in SLEEF.
constexpr double kGammaLibrary = 24 * kRoundoff;

/// Where gamma is least on x > 0: it falls up to the first of these, and rises from the second on.
constexpr double kTurnLow = 1.461632144968362;
constexpr double kTurnHigh = 1.461632144968363;
constexpr double kLeastGamma = 0.8856031944108886;     // rounded down, gamma(1.46163...)
constexpr double kLeastLgamma = -0.12148629053584962;  // rounded down, its logarithm

bool has_pole(const Interval& x) {
  return x.low <= 0 && std::floor(std::min(x.high, 0.0)) >= x.low;
}

bool is_only_pole(const Interval& x) {
  return is_point(x) && has_pole(x);
}

/// Steps towards the least value of a convex function. Each about quarters what the bound gives
/// away, which is at first a matter of the box's width squared.
constexpr int kConvexSteps = 12;

/// The slopes of a function at the ends of an interval.
using EndSlopes = std::array<double, 2>;

/// A lower bound of a convex function f over x, from its slopes, which are off by slope_error at
/// most. Small boxes take no step: their tangents say enough.
template <class Function, class Slope>
double least_of_convex(const Interval& x, Function f, Slope slope, const EndSlopes& at_ends,
                       double slope_error) {
  if (!(slope_error < kInfinity)) return -kInfinity;  // next to a pole
  double a = x.low;
  double b = x.high;
  double slope_a = at_ends[0] - slope_error;
  double slope_b = at_ends[1] + slope_error;
  if (slope_a >= 0) return f(a);
  if (slope_b <= 0) return f(b);
  for (int step = 0;; ++step) {
    // The tangents at a and b are below the function, and the least is where they meet.
    const double f_a = f(a);
    const double f_b = f(b);
    const double meet = (slope_b * (b - a) - (f_b - f_a)) / (slope_b - slope_a);
    const double middle = a + std::clamp(meet, 0.0, b - a);
    const double slack = kSeries * (slope_b - slope_a) * (b - a);
    const double least = f_a + slope_a * (middle - a) - slack;
    if (std::isnan(least)) return -kInfinity;  // f overflows
    if (step == kConvexSteps || std::min(f_a, f_b) - least <= kSeries * std::fabs(least)) {
      return least;
    }
    const double steepness = slope(middle);
    if (std::fabs(steepness) <= slope_error) return f(middle) - 2 * slope_error * (b - a);
    (steepness > 0 ? b : a) = middle;
    (steepness > 0 ? slope_b : slope_a) = steepness + (steepness > 0 ? slope_error : -slope_error);
  }
}

Interval unbounded_at_pole(double low) {
  return {low, kInfinity, Defined::Maybe, false};
}

double digamma(double x) {
  return saddle::polygamma(0, x);
}

EndSlopes slopes_of_lgamma(const Interval& x) {
  return {digamma(x.low), digamma(x.high)};
}

/// The lower bound of ln|gamma| on a box between two poles, with its slopes there.
double least_lgamma(const Interval& x, const EndSlopes& slopes) {
  const double steepness = 1 + std::fabs(slopes[0]) + std::fabs(slopes[1]);
  return least_of_convex(x, log_gamma, digamma, slopes, kSeries * steepness);
}

/// The lower bound of ln|gamma| on a box without a pole.
double least_lgamma(const Interval& x) {
  if (x.low >= kTurnHigh) return log_gamma(x.low);
  if (x.low > 0) return x.high <= kTurnLow ? log_gamma(x.high) : kLeastLgamma;
  return least_lgamma(x, slopes_of_lgamma(x));
}

}  // namespace

Interval erf(const Interval& a) {
  return clamped(rising(a, std::erf, kLibrary), -1, 1);
}

Interval lgamma(const Interval& a) {
  if (a.defined == Defined::No || is_only_pole(a)) return kUndefined;
  if (has_pole(a)) return unbounded_at_pole(a.low < 0 ? -kInfinity : kLeastLgamma);
  Interval r = a;
  // Near its zeros the error is relative to 1.
  r.low = down(least_lgamma(a), kSeries) - kSeries;
  r.high = up(std::max(log_gamma(a.low), log_gamma(a.high)), kSeries) + kSeries;
  if (a.low > 0) r.low = std::max(r.low, kLeastLgamma);
  return r;
}

Interval gamma(const Interval& a) {
  if (a.defined == Defined::No || is_only_pole(a)) return kUndefined;
  if (has_pole(a)) return unbounded_at_pole(a.low < 0 ? -kInfinity : kLeastGamma);
  // Between poles |gamma| turns where ln|gamma| does; elsewhere its ends are sharper.
  const double x = std::fabs(std::tgamma(a.low));
  const double y = std::fabs(std::tgamma(a.high));
  Interval r = a;
  r.low = down(std::min(x, y), kGammaLibrary);
  r.high = std::max(up(std::max(x, y), kGammaLibrary), kUnderflow);
  if (a.low > 0) {
    if (a.low < kTurnHigh && a.high > kTurnLow) r.low = kLeastGamma;
  } else if (const EndSlopes slopes = slopes_of_lgamma(a);
             slopes[0] < kSeries && slopes[1] > -kSeries) {
    const double logarithm = least_lgamma(a, slopes);
    const double least = std::exp(logarithm);
    r.low = std::min(r.low, down(least, kLibrary + 2 * kSeries * (1 + std::fabs(logarithm))));
  }
  if (a.low > 0) r.low = std::max(r.low, kLeastGamma);
  const bool negative = a.low < 0 && std::fmod(std::floor(a.low), 2) != 0;
  return negative ? -r : r;
}

namespace {

/// A lower bound for odd n: positive and convex between poles, falling on x > 0.
double least_polygamma(double n, const Interval& x) {
  const auto f = [n](double t) { return saddle::polygamma(n, t); };
  if (x.low > 0) return f(x.high);
  const auto slope = [n](double t) { return saddle::polygamma(n + 1, t); };
  const EndSlopes slopes = {slope(x.low), slope(x.high)};
  const double steepness = std::fabs(slopes[0]) + std::fabs(slopes[1]);
  return least_of_convex(x, f, slope, slopes, kSeries * (std::tgamma(n + 2) + steepness));
}

}  // namespace

Interval polygamma(const Interval& order, const Interval& x) {
  if (std::min(order.defined, x.defined) == Defined::No || is_only_pole(x)) return kUndefined;
  Interval r = with_decorations_of(order, x);
  const double n = order.low;
  const bool odd = std::fmod(n, 2) != 0;
  const double unbounded = odd ? 0 : -kInfinity;  // odd orders are positive
  if (has_pole(x) || !is_point(order)) return unbounded_at_pole(unbounded);
  const double value_low = saddle::polygamma(n, x.low);
  const double value_high = saddle::polygamma(n, x.high);
  const bool numbers = !std::isnan(value_low) && !std::isnan(value_high);  // even next to a pole
  if (!numbers) return {unbounded, kInfinity, r.defined, r.continuous};
  // Where signs cancel (n = 0, and the reflection at x < 0) the error is one of the terms': n! or
  // so, besides the result.
  const double term = n == 0 || x.low < 0 ? kSeries * std::tgamma(n + 1) : 0;
  const double error = (n + 1) * kSeries;
  if (odd) {
    r.low = down(least_polygamma(n, x), error) - term;
    r.low = std::max(r.low, 0.0);
    r.high = up(std::max(value_low, value_high), error) + term;
  } else {  // rises between poles
    r.low = down(value_low, error) - term;
    r.high = up(value_high, error) + term;
    if (n > 0 && x.low > 0) r.high = std::min(r.high, 0.0);
  }
  return r;
}

namespace {

/// A smooth function about the middle of a box, by Taylor's formula.
struct Taylor {
  double middle;
  double value, slope, bend;  // f, f', f'' at the middle
  double error;               // of each of these
  double third;               // bound of |f'''|

  double radius(const Interval& x) const {
    return std::max(sum_up(x.high, -middle), sum_up(middle, -x.low));
  }

  Interval over(const Interval& x) const {
    const double h = radius(x);
    const double second = std::fabs(bend) + error + third * h / 3;
    const double reach = h * (std::fabs(slope) + error + second * h / 2) + error;
    const double slack = up(reach, 8 * kRoundoff);
    return {sum_down(value, -slack), sum_up(value, slack)};
  }

  /// Whether f' has one sign on the box. The hundredth is more than all roundings.
  bool is_monotone(const Interval& x) const {
    const double h = radius(x);
    return std::fabs(slope) > error + 1.01 * h * (std::fabs(bend) + error + third * h / 2);
  }
};

/// Enclosure of an oscillating function: from its ends, where it is monotone.
template <class Function>
Interval oscillating(const Interval& x, Function f, const Taylor& taylor) {
  Interval r = taylor.over(x);
  if (taylor.is_monotone(x)) {
    const double p = f(x.low);
    const double q = f(x.high);
    r.low = std::max(r.low, sum_down(std::min(p, q), -taylor.error));
    r.high = std::min(r.high, sum_up(std::max(p, q), taylor.error));
  }
  r.defined = x.defined;
  r.continuous = x.continuous;
  return r;
}

/// Boxes wider than this say nothing more about an oscillation than its amplitude.
constexpr double kWideOscillation = 4;

bool is_narrow(const Interval& order, const Interval& x) {
  return is_point(order) && x.high - x.low < kWideOscillation;
}

}  // namespace

Interval bessel_j(const Interval& order, const Interval& x) {
  const Interval r = with_decorations_of(order, x);
  if (r.defined == Defined::No) return kUndefined;
  // |J_n| <= 1, and so are its derivatives, as J_n' = (J_(n-1) - J_(n+1)) / 2.
  const Interval bounds = {-1, 1, r.defined, r.continuous};
  if (!is_narrow(order, x)) return bounds;
  const double n = order.low;
  const double middle = x.low + (x.high - x.low) / 2;
  const auto j = [n](double k, double t) { return saddle::bessel_j(n + k, t); };
  const double value = j(0, middle);
  const double slope = (j(-1, middle) - j(1, middle)) / 2;
  const double bend = (j(-2, middle) - 2 * value + j(2, middle)) / 4;
  const Taylor taylor = {middle, value, slope, bend, kSeries, 1};
  return clamped(oscillating(
                     x, [&j](double t) { return j(0, t); }, taylor),
                 -1, 1);
}

Interval sinc_derivative(const Interval& order, const Interval& x) {
  const Interval r = with_decorations_of(order, x);
  if (r.defined == Defined::No) return kUndefined;
  const double n = order.low;
  // The integral of t^n cos(xt + n pi/2) over [0, 1]: at most 1/(n+1), and 2/|x| by parts.
  const double near = n == 0 ? 1 : up(1 / (n + 1), kRoundoff);
  const double far = up(2 / std::max(least_size(x), 1.0), kRoundoff);
  const double size = std::min(near, far);
  const Interval bounds = {-size, size, r.defined, r.continuous};
  if (!is_narrow(order, x)) return bounds;
  const double middle = x.low + (x.high - x.low) / 2;
  const auto f = [n](double k, double t) { return saddle::sinc_derivative(n + k, t); };
  // The power series loses e^|x| to cancellation; f'' uses it up to |x| = n + 2.
  const double error = kSeries * std::exp(std::min(largest_size(x), n + 2));
  const Taylor taylor = {middle, f(0, middle), f(1, middle), f(2, middle), error, 1 / (n + 4)};
  return clamped(oscillating(
                     x, [&f](double t) { return f(0, t); }, taylor),
                 -size, size);
}

}  // namespace saddle
