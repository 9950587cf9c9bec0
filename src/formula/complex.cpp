#include "formula/complex.h"

#include <cmath>
#include <limits>

namespace saddle {
namespace {

/// Whole exponents up to this size become products, as those of real numbers do
/// (formula/lower.cpp).
constexpr double kMaxComplexProduct = 16;

bool is_zero(Expression a) {
  return a.graph->is_constant(a.id, 0);
}

/// The constant 0 takes no part: see above.
Expression times(Expression a, Expression b) {
  return is_zero(a) || is_zero(b) ? a.of(0) : a * b;
}
Expression over(Expression a, Expression b) {
  return is_zero(a) ? a : a / b;
}
Expression square(Expression a) {
  return is_zero(a) ? a : pow(a, 2);
}

Complex real(Expression a) {
  return {a, a.of(0)};
}
/// i*a
Complex turned(const Complex& a) {
  return {-a.im, a.re};
}
/// a/i
Complex turned_back(const Complex& a) {
  return {a.im, -a.re};
}

/// 1 where the sign of `a` is minus, that of -0 included.
Expression is_negative(Expression a) {
  return 1 / a < 0;
}

Complex squared(const Complex& a) {
  return {square(a.re) - square(a.im), times(2 * a.re, a.im)};
}
Complex cubed(const Complex& a) {
  return {pow(a.re, 3) - times(3 * a.re, square(a.im)),
          times(3 * square(a.re), a.im) - pow(a.im, 3)};
}

/// a^n for whole n > 0. Cubes and squares are written out; others are made of these.
Complex power(const Complex& a, int n) {
  if (n == 1) return a;
  if (n == 2) return squared(a);
  if (n == 3) return cubed(a);
  if (n % 2 == 0) return squared(power(a, n / 2));
  return power(a, n - 1) * a;
}

Complex from_polar(Expression r, Expression angle) {
  return {times(r, cos(angle)), times(r, sin(angle))};
}

/// sqrt(1-a), sqrt(1+a).
struct Roots {
  Complex minus, plus;
};
Roots roots_of(const Complex& a) {
  const Complex one = real(a.re.of(1));
  return {sqrt(one - a), sqrt(one + a)};
}

/// The real part of atanh(x+iy): no cancellation anywhere.
Expression half_asinh(Expression x, Expression y) {
  return asinh(2 * x / (hypot(1 - x, y) * hypot(1 + x, y))) / 2;
}

}  // namespace

Complex operator-(const Complex& a) {
  return {-a.re, -a.im};
}
Complex operator+(const Complex& a, const Complex& b) {
  return {a.re + b.re, a.im + b.im};
}
Complex operator-(const Complex& a, const Complex& b) {
  return {a.re - b.re, a.im - b.im};
}

Complex operator*(const Complex& a, const Complex& b) {
  if (a.re.id == b.re.id && a.im.id == b.im.id) return squared(a);
  return {times(a.re, b.re) - times(a.im, b.im), times(a.re, b.im) + times(a.im, b.re)};
}

Complex operator/(const Complex& a, const Complex& b) {
  if (is_zero(b.im)) return {over(a.re, b.re), over(a.im, b.re)};
  if (is_zero(b.re)) return turned_back({over(a.re, b.im), over(a.im, b.im)});
  const Complex product = a * conj(b);
  const Expression divisor = square(b.re) + square(b.im);
  return {over(product.re, divisor), over(product.im, divisor)};
}

Complex operator/(double a, const Complex& b) {
  return real(b.re.of(a)) / b;
}

Complex conj(const Complex& a) {
  return {a.re, -a.im};
}
Expression arg(const Complex& a) {
  return atan2(a.im, a.re);
}
Expression abs(const Complex& a) {
  return is_zero(a.im) ? abs(a.re) : is_zero(a.re) ? abs(a.im) : hypot(a.re, a.im);
}

Complex pow(const Complex& a, const Complex& b) {
  if (!is_zero(b.im)) return exp(b * log(a));
  const Graph& graph = *b.re.graph;
  if (!graph.is_constant(b.re.id)) return from_polar(pow(abs(a), b.re), times(b.re, arg(a)));
  const double n = graph[b.re.id].value;
  if (n == 0) return real(a.re.of(1));
  if (n == 0.5) return sqrt(a);
  if (n == std::floor(n) && std::fabs(n) <= kMaxComplexProduct) {
    const Complex product = power(a, static_cast<int>(std::fabs(n)));
    return n > 0 ? product : 1 / product;
  }
  return from_polar(pow(abs(a), b.re), times(b.re, arg(a)));
}

Complex sqrt(const Complex& a) {
  // The larger part first; the other one without cancellation, as y over twice it. Far below every
  // root but that of 0, which is 0 over it.
  constexpr double kTiny = std::numeric_limits<double>::min();
  const Expression larger = sqrt((abs(a) + abs(a.re)) / 2);
  const Expression divisor = max(2 * larger, kTiny);
  const Expression is_right = a.re >= 0;
  return {select(is_right, larger, abs(a.im) / divisor),
          select(is_right, over(a.im, divisor), select(is_negative(a.im), -larger, larger))};
}

Complex exp(const Complex& a) {
  return from_polar(exp(a.re), a.im);
}
Complex log(const Complex& a) {
  return {log(abs(a)), arg(a)};
}

Complex sin(const Complex& a) {
  return {times(sin(a.re), cosh(a.im)), times(cos(a.re), sinh(a.im))};
}
Complex cos(const Complex& a) {
  return {times(cos(a.re), cosh(a.im)), -times(sin(a.re), sinh(a.im))};
}
Complex sinh(const Complex& a) {
  return {times(sinh(a.re), cos(a.im)), times(cosh(a.re), sin(a.im))};
}
Complex cosh(const Complex& a) {
  return {times(cosh(a.re), cos(a.im)), times(sinh(a.re), sin(a.im))};
}

Complex tanh(const Complex& a) {
  // (T + it)/(1 + iTt) with T = tanh(x), t = tan(y): nothing overflows.
  const Expression along = tanh(a.re);
  const Expression across = tan(a.im);
  const Expression divisor = 1 + square(times(along, across));
  return {over(times(along, 1 + square(across)), divisor),
          over(times(across, (1 - along) * (1 + along)), divisor)};
}
Complex tan(const Complex& a) {
  return turned_back(tanh(turned(a)));
}

Complex asin(const Complex& a) {
  const auto [minus, plus] = roots_of(a);
  return {atan2(a.re, times(minus.re, plus.re) - times(minus.im, plus.im)),
          asinh(times(minus.re, plus.im) - times(minus.im, plus.re))};
}

Complex acos(const Complex& a) {
  const auto [minus, plus] = roots_of(a);
  return {2 * atan2(minus.re, plus.re), asinh(times(plus.re, minus.im) - times(plus.im, minus.re))};
}

Complex acosh(const Complex& a) {
  const Complex one = real(a.re.of(1));
  const Complex minus = sqrt(a - one);
  const Complex plus = sqrt(a + one);
  return {asinh(times(minus.re, plus.re) + times(minus.im, plus.im)), 2 * atan2(minus.im, plus.re)};
}

Complex asinh(const Complex& a) {
  return turned_back(asin(turned(a)));
}

Complex atanh(const Complex& a) {
  const Expression lean = (1 - a.re) * (1 + a.re) - square(a.im);
  return {half_asinh(a.re, a.im), atan2(2 * a.im, lean) / 2};
}
Complex atan(const Complex& a) {
  return turned_back(atanh(turned(a)));
}

}  // namespace saddle
