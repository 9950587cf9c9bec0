#include "formula/special.h"

#include <math.h>  // lgamma_r and jn are POSIX, not C++

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace saddle {
namespace {

constexpr double kPi = 3.141592653589793238462643;

double factorial(int n) {
  return std::tgamma(n + 1.0);
}

/// The asymptotic series of polygamma, for x that is large compared with n.
double polygamma_series(int n, double x) {
  // B_2k for k = 1 ... 10: at x >= 20 + n the first term left out is below half an ULP.
  static constexpr std::array<double, 10> kBernoulli = {
      1.0 / 6,       -1.0 / 30, 1.0 / 42,      -1.0 / 30,     5.0 / 66,
      -691.0 / 2730, 7.0 / 6,   -3617.0 / 510, 43867.0 / 798, -174611.0 / 330};
  double sum = n == 0 ? -std::log(x) : factorial(n - 1) / std::pow(x, n);
  sum += factorial(n) / (2 * std::pow(x, n + 1));
  for (int k = 1; k <= static_cast<int>(kBernoulli.size()); ++k) {
    // (2k+n-1)! / (2k)! as a product: the factorials alone overflow.
    double ratio = 1;
    for (int i = 2 * k + 1; i <= 2 * k + n - 1; ++i) ratio *= i;
    if (n == 0) ratio = 1.0 / (2 * k);
    sum += kBernoulli[k - 1] * ratio / std::pow(x, 2 * k + n);
  }
  return n % 2 == 0 ? -sum : sum;
}

/// The n-th derivative of pi*cot(pi*x): pi^(n+1) P_n(cot), P_0 = c, P_(n+1) = -(1 + c^2) P_n'.
double cotangent_derivative(int n, double x) {
  std::vector<double> p = {0, 1};
  for (int k = 0; k < n; ++k) {
    std::vector<double> next(p.size() + 1, 0.0);
    for (std::size_t i = 1; i < p.size(); ++i) {
      next[i - 1] -= static_cast<double>(i) * p[i];
      next[i + 1] -= static_cast<double>(i) * p[i];
    }
    p = next;
  }
  // From the nearest pole, which is exact: pi times a number near 1 would lose the distance.
  const double c = 1 / std::tan(kPi * std::remainder(x, 1.0));
  double value = 0;
  for (std::size_t i = p.size(); i-- > 0;) value = value * c + p[i];
  return std::pow(kPi, n + 1) * value;
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
  if (x < 0) {  // reflection
    const double mirrored = polygamma(n, 1 - x);
    return (order % 2 == 0 ? mirrored : -mirrored) - cotangent_derivative(order, x);
  }
  double shifted = 0;  // recurrence up to where the series is good
  while (x < 20 + order) {
    shifted += factorial(order) / std::pow(x, order + 1);
    x += 1;
  }
  return polygamma_series(order, x) + (order % 2 == 0 ? -shifted : shifted);
}

double bessel_j(double n, double x) {
  return jn(static_cast<int>(n), x);
}

double sinc_derivative(double n, double x) {
  const int order = static_cast<int>(n);
  if (std::fabs(x) <= std::fmax(1.0, n)) {
    // sum over even m + n of (-1)^((m+n)/2) x^m / (m! (m+n+1))
    double sum = 0;
    double power = order % 2 == 0 ? 1.0 : x;  // x^m / m!
    for (int m = order % 2;; m += 2) {
      const double term = power / (m + order + 1);
      sum += (m + order) / 2 % 2 == 0 ? term : -term;
      // The terms fall at least geometrically once m > |x|.
      if (m > std::fabs(x) && std::fabs(term) <= 1e-18 * std::fabs(sum)) return sum;
      if (term == 0) return sum;
      power *= x * x / ((m + 1.0) * (m + 2.0));
    }
  }
  // x s_n + n s_(n-1) = the n-th derivative of sin x; stable upward for |x| > n.
  const std::array<double, 4> sines = {std::sin(x), std::cos(x), -std::sin(x), -std::cos(x)};
  double value = sines[0] / x;
  for (int k = 1; k <= order; ++k) value = (sines[k % 4] - k * value) / x;
  return value;
}

}  // namespace saddle
