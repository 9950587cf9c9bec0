#include "formula/special.h"

#include <math.h>  // lgamma_r and jn are POSIX, not C++

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace saddle {
namespace {

// The sums below cancel, most of all near the zero of digamma: long double has the digits for that.
constexpr long double kPi = 3.14159265358979323846264338327950288L;

/// A term this small beside the sum, and the ones after it, which fall geometrically, are together
/// below a hundredth of the sum's last place.
constexpr double kNegligible = 0x1p-60;

/// By products: std::pow and std::tgamma take ten times as long as all the rest.
long double factorial(int n) {
  long double product = 1;
  for (int k = 2; k <= n; ++k) product *= k;
  return product;
}

long double power(long double base, int n) {
  long double product = 1;
  for (int k = 0; k < n; ++k) product *= base;
  return product;
}

/// The asymptotic series of polygamma is good from n + 20 on, that of digamma from 10 on.
constexpr int kSeriesFrom = 20;
constexpr int kDigammaFrom = 10;

/// The asymptotic series of polygamma for n > 0 and x that is large compared with n.
long double polygamma_series(int n, long double x) {
  // B_2k for k = 1 ... 10: at x >= n + 20 the first term left out is below half an ULP.
  static constexpr std::array<long double, 10> kBernoulli = {
      1.0L / 6,       -1.0L / 30, 1.0L / 42,      -1.0L / 30,     5.0L / 66,
      -691.0L / 2730, 7.0L / 6,   -3617.0L / 510, 43867.0L / 798, -174611.0L / 330};
  const long double inverse = 1 / x;
  long double scale = power(inverse, n);  // x^-(n+2k)
  long double sum = factorial(n - 1) * scale;
  sum += factorial(n) * scale * inverse / 2;
  for (int k = 1; k <= static_cast<int>(kBernoulli.size()); ++k) {
    // (2k+n-1)! / (2k)! as a product: the factorials alone overflow.
    long double ratio = 1;
    for (int i = 2 * k + 1; i <= 2 * k + n - 1; ++i) ratio *= i;
    scale *= inverse * inverse;
    sum += kBernoulli[k - 1] * ratio * scale;
  }
  return n % 2 == 0 ? -sum : sum;
}

/// cot(pi x), with all digits near its zeros and poles: the period and the quarter come off
/// exactly.
long double cotangent_of_turns(double x) {
  const long double rest = x - std::round(x);
  if (std::fabs(rest) <= 0.25L) return 1 / std::tan(kPi * rest);
  return std::copysign(std::tan(kPi * (0.5L - std::fabs(rest))), rest);
}

/// The n-th derivative of pi*cot(pi*x): pi^(n+1) P_n(cot), P_0 = c, P_(n+1) = -(1 + c^2) P_n'.
long double cotangent_derivative(int n, double x) {
  if (n == 0) return kPi * cotangent_of_turns(x);
  std::vector<long double> p = {0, 1};
  for (int k = 0; k < n; ++k) {
    std::vector<long double> next(p.size() + 1, 0.0L);
    for (std::size_t i = 1; i < p.size(); ++i) {
      next[i - 1] -= static_cast<long double>(i) * p[i];
      next[i + 1] -= static_cast<long double>(i) * p[i];
    }
    p = next;
  }
  const long double c = cotangent_of_turns(x);
  long double value = p.back();
  for (std::size_t i = p.size() - 1; i-- > 0;) value = value * c + p[i];
  return power(kPi, n + 1) * value;
}

/// The asymptotic series of digamma.
long double digamma_series(long double x) {
  // B_2k / 2k for k = 1 ... 10: at x >= 10 the first term left out is 3e-20.
  static constexpr std::array<long double, 10> kOver2k = {
      1.0L / 12,        -1.0L / 120, 1.0L / 252,      -1.0L / 240,      1.0L / 132,
      -691.0L / 32'760, 1.0L / 12,   -3617.0L / 8160, 43867.0L / 14364, -174611.0L / 6600};
  const long double inverse = 1 / x;
  const long double square = inverse * inverse;
  long double sum = 0;
  for (std::size_t k = kOver2k.size(); k-- > 0;) sum = (sum + kOver2k[k]) * square;
  return std::log(x) - inverse / 2 - sum;
}

/// For x > 0. The terms of the recurrence are one fraction: a division takes as long as 20
/// products.
long double digamma_right(long double x) {
  long double over = 0;
  long double under = 1;
  for (; x < kDigammaFrom; x += 1) {
    over = over * x + under;
    under *= x;
  }
  return digamma_series(x) - over / under;
}

/// For x > 0.
long double polygamma_right(int n, long double x) {
  if (n == 0) return digamma_right(x);
  long double shifted = 0;  // recurrence up to where the series is good
  for (; x < kSeriesFrom + n; x += 1) shifted += power(1 / x, n + 1);
  shifted *= factorial(n);
  return polygamma_series(n, x) + (n % 2 == 0 ? -shifted : shifted);
}

}  // namespace

double log_gamma(double x) {
  int sign_of_gamma = 0;
  return lgamma_r(x, &sign_of_gamma);
}

double polygamma(double n, double x) {
  const int order = static_cast<int>(n);
  if (std::isnan(x) || (x <= 0 && x == std::floor(x))) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (x > 0) return static_cast<double>(polygamma_right(order, x));
  const long double mirrored = polygamma_right(order, 1 - static_cast<long double>(x));
  return static_cast<double>((order % 2 == 0 ? mirrored : -mirrored) -
                             cotangent_derivative(order, x));
}

double bessel_j(double n, double x) {
  return jn(static_cast<int>(n), x);
}

double sinc_derivative(double n, double x) {
  if (std::isinf(x)) return 0;
  const int order = static_cast<int>(n);
  // Further out the terms cancel; further in the recurrence below multiplies errors by n/x.
  if (std::fabs(x) <= std::fmax(1.0, n / 2)) {
    // sum over even m + n of (-1)^((m+n)/2) x^m / (m! (m+n+1))
    double sum = 0;
    double power = order % 2 == 0 ? 1.0 : x;  // x^m / m!
    for (int m = order % 2;; m += 2) {
      const double term = power / (m + order + 1);
      sum += (m + order) / 2 % 2 == 0 ? term : -term;
      // The terms fall at least geometrically once m > |x|.
      if (m > std::fabs(x) && std::fabs(term) <= kNegligible * std::fabs(sum)) return sum;
      if (term == 0) return sum;
      power *= x * x / ((m + 1.0) * (m + 2.0));
    }
  }
  // x s_n + n s_(n-1) = the n-th derivative of sin x; upward, errors grow little for |x| > n/2.
  const std::array<double, 4> sines = {std::sin(x), std::cos(x), -std::sin(x), -std::cos(x)};
  double value = sines[0] / x;
  for (int k = 1; k <= order; ++k) value = (sines[k % 4] - k * value) / x;
  return value;
}

}  // namespace saddle
