#include "study/high_precision.h"

#include <array>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <limits>

namespace saddle {
namespace {

Real truth(bool condition) {
  return condition ? Real(1) : Real(0);
}

/// Digits that survive when multiples of pi/2 or of the smallest double are taken off the largest:
/// 308 + 308, 19 for the double that is nearest to a multiple, and 50 that are wanted.
using Huge = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<700>>;

/// Boost makes the limits of a type at their first use, and without a lock: here that is before
/// there are threads. Its functions take those of numbers with expression templates, too.
template <class T>
bool make_limits() {
  using Limits = std::numeric_limits<T>;
  for (const auto limit : {Limits::min, Limits::max, Limits::epsilon, Limits::round_error,
                           Limits::infinity, Limits::quiet_NaN}) {
    limit();
  }
  return true;
}
template <class T>
bool make_all_limits() {
  namespace mp = boost::multiprecision;
  using Backend = typename T::backend_type;
  return make_limits<mp::number<Backend, mp::et_off>>() &&
         make_limits<mp::number<Backend, mp::et_on>>();
}
[[maybe_unused]] const bool kHasLimits =
    make_all_limits<Real>() && make_all_limits<boost::multiprecision::cpp_bin_float_100>() &&
    make_all_limits<Huge>();

/// x minus the nearest multiple of pi/2, and which multiple that is, modulo 4.
struct Quadrant {
  Real rest;
  int number = 0;
};

Quadrant reduce(const Real& x) {
  static const Huge kHalfPi = boost::multiprecision::acos(Huge(0));
  const Huge multiple = boost::multiprecision::round(Huge(x) / kHalfPi);
  const Huge turns = boost::multiprecision::floor(multiple / 4);
  return {Real(Huge(x) - multiple * kHalfPi), static_cast<int>(multiple - 4 * turns)};
}

/// The n-th derivative of sin at x.
Real sine_derivative(int n, const Real& x) {
  namespace mp = boost::multiprecision;
  // Below 1 nothing is taken off, and tiny arguments keep their digits.
  const Quadrant at = mp::abs(x) < 1 ? Quadrant{x, 0} : reduce(x);
  const int quarter = (at.number + n) % 4;
  const Real value = quarter % 2 == 0 ? mp::sin(at.rest) : mp::cos(at.rest);
  return quarter < 2 ? value : Real(-value);
}

/// An argument past which an exponential is infinite or zero for every purpose, and Boost's series
/// are slow: e^(+-1e5) is far outside of the doubles.
constexpr double kLargestExponent = 1e5;

Real exponential(const Real& x) {
  if (x > kLargestExponent) return std::numeric_limits<Real>::infinity();
  return x < -kLargestExponent ? Real(0) : Real(boost::multiprecision::exp(x));
}

/// e^|x| - 1, with all digits near 0.
Real growth(const Real& x) {
  const Real size = boost::multiprecision::abs(x);
  if (size > kLargestExponent) return std::numeric_limits<Real>::infinity();
  return boost::math::expm1(size);
}

Real odd(const Real& x, const Real& value_of_size) {
  return x < 0 ? Real(-value_of_size) : value_of_size;
}

Real exact_sinh(const Real& x) {
  const Real e = growth(x);
  return odd(x, boost::multiprecision::isfinite(e) ? Real((e + e / (e + 1)) / 2) : e);
}

Real exact_tanh(const Real& x) {
  const Real e = growth(2 * x);
  return odd(x, boost::multiprecision::isfinite(e) ? Real(e / (e + 2)) : Real(1));
}

Real exact_asinh(const Real& x) {
  const Real size = boost::multiprecision::abs(x);
  const Real square = size * size;
  return odd(x, boost::math::log1p(
                    Real(size + square / (1 + boost::multiprecision::sqrt(Real(square + 1))))));
}

Real exact_pow(const Real& a, const Real& b) {
  namespace mp = boost::multiprecision;
  if (a == 0 || b == 0) return b == 0 ? Real(1) : b > 0 ? Real(0) : 1 / mp::abs(a);
  const bool whole = b == mp::floor(b);
  if (a < 0 && !whole) return std::numeric_limits<Real>::quiet_NaN();
  const Real size = exponential(Real(b * mp::log(mp::abs(a))));
  const bool is_odd = whole && 2 * mp::floor(Real(b / 2)) != b;
  return a < 0 && is_odd ? Real(-size) : size;
}

Real exact_mod(const Real& a, const Real& b) {
  return Real(Huge(a) - Huge(b) * boost::multiprecision::floor(Huge(a) / Huge(b)));
}

/// Past these, gamma is outside of the doubles.
Real exact_gamma(const Real& x) {
  if (x > 1000) return std::numeric_limits<Real>::infinity();
  return x < -1000 && x != boost::multiprecision::floor(x) ? Real(0) : boost::math::tgamma(x);
}

/// In 100 digits: the logarithm loses half of them near its zeros.
Real exact_lgamma(const Real& x) {
  using Fine = boost::multiprecision::cpp_bin_float_100;
  if (boost::multiprecision::abs(x) > 20) return boost::math::lgamma(x);
  return Real(log(abs(boost::math::tgamma(Fine(x)))));
}

/// Where Boost no longer tells even multiples of pi from odd ones: Hankel's asymptotic series, with
/// terms (4n^2-1^2)(4n^2-3^2).../(k! (8x)^k) of alternating kinds.
Real exact_bessel_j(int n, const Real& x) {
  namespace mp = boost::multiprecision;
  if (mp::abs(x) < 1e4) return boost::math::cyl_bessel_j(n, x);
  if (x < 0) return n % 2 == 0 ? exact_bessel_j(n, -x) : Real(-exact_bessel_j(n, -x));
  constexpr int kTerms = 20;  // the last is below 1e-50 at 1e4
  std::array<Real, 2> sums = {Real(1), Real(0)};
  Real term = 1;
  for (int k = 1; k < kTerms; ++k) {
    term *= Real(4 * n * n - (2 * k - 1) * (2 * k - 1)) / (k * 8 * x);
    sums[k % 2] += k / 2 % 2 == 0 ? term : Real(-term);
  }
  // The phase is x - n pi/2 - pi/4; the factor 1/sqrt(2) of its quarter turn is taken out.
  const int quarters = ((-n % 4) + 4) % 4;
  const Real sine = sine_derivative(quarters, x);
  const Real cosine = sine_derivative(quarters + 1, x);
  const Real& pi = boost::math::constants::pi<Real>();
  return (sums[0] * (cosine + sine) - sums[1] * (sine - cosine)) / mp::sqrt(Real(pi * x));
}

Real factorial(int n) {
  Real product = 1;
  for (int k = 2; k <= n; ++k) product *= k;
  return product;
}

/// Bernoulli's numbers B_0, B_2, B_4 ... by their recurrence, in as many digits as it loses.
std::vector<Real> even_bernoulli_numbers(int count) {
  std::vector<Huge> all = {Huge(1)};
  for (int m = 1; m < 2 * count; ++m) {
    Huge sum = 0;
    Huge choose = 1;  // m + 1 over k
    for (int k = 0; k < m; ++k) {
      sum += choose * all[static_cast<std::size_t>(k)];
      choose = choose * (m + 1 - k) / (k + 1);
    }
    all.push_back(-sum / (m + 1));
  }
  std::vector<Real> even;
  for (std::size_t k = 0; k < all.size(); k += 2) even.emplace_back(all[k]);
  return even;
}

/// For x > 0: recurrence up to where the asymptotic series has 50 digits. Boost's own makes a table
/// when the program starts, which every run would wait for.
/// Source: NIST Digital Library of Mathematical Functions, 5.11.2 and 5.15.8.
Real positive_polygamma(int n, const Real& x) {
  namespace mp = boost::multiprecision;
  constexpr int kTerms = 32;
  constexpr int kFar = 60;  // the last term is below 1e-60 there
  static const std::vector<Real> kBernoulli = even_bernoulli_numbers(kTerms);
  Real sum = 0;  // of n! / (x + j)^(n + 1) and the series
  Real y = x;
  const Real n_factorial = factorial(n);
  for (; y < kFar; y += 1) sum += n_factorial / mp::pow(y, n + 1);
  sum += n_factorial / (2 * mp::pow(y, n + 1));
  Real ratio = factorial(n + 1) / 2;  // (2k + n - 1)! / (2k)!
  Real power = mp::pow(y, n + 2);
  for (int k = 1; k < kTerms; ++k) {
    sum += kBernoulli[static_cast<std::size_t>(k)] * ratio / power;
    ratio *= Real((2 * k + n) * (2 * k + n + 1)) / ((2 * k + 1) * (2 * k + 2));
    power *= y * y;
  }
  if (n == 0) return mp::log(y) - sum;
  sum += factorial(n - 1) / mp::pow(y, n);
  return n % 2 == 0 ? Real(-sum) : sum;
}

}  // namespace

/// Its power series, good for |x| < 20 with 50 digits, and beyond
/// the recurrence x s_n + n s_(n-1) = sin^(n)(x), stable for |x| > n.
Real sinc_series(int n, const Real& x) {
  if (boost::multiprecision::abs(x) > 19) {
    Real value = sine_derivative(0, x) / x;
    for (int k = 1; k <= n; ++k) value = (sine_derivative(k, x) - k * value) / x;
    return value;
  }
  Real sum = 0;
  Real power = n % 2 == 0 ? Real(1) : x;  // x^m / m!
  for (int m = n % 2; m < 200; m += 2) {
    const Real term = power / (m + n + 1);
    sum += (m + n) / 2 % 2 == 0 ? term : Real(-term);
    power *= x * x / ((m + 1) * (m + 2));
  }
  return sum;
}

/// By the reflection formula where x < 0.
Real exact_polygamma(int n, const Real& x) {
  if (x > 0) return positive_polygamma(n, x);
  const int sign = n % 2 == 0 ? 1 : -1;
  Real mirrored = sign * positive_polygamma(n, Real(1 - x));
  const Real rest = x - boost::multiprecision::round(x);
  if (sign > 0 && abs(rest) == Real(0.5)) return mirrored;  // derivatives of pi cot(pi x) are 0
  const Real other = sign * positive_polygamma(n, Real(1 - rest));
  if (rest > 0) return mirrored - other + positive_polygamma(n, rest);
  const Real step = sign * factorial(n) / boost::multiprecision::pow(rest, n + 1);
  return mirrored - other + positive_polygamma(n, Real(1 + rest)) - step;
}

// NOLINTNEXTLINE(readability-function-size): a line or two for each operation
Real apply_exactly(Op op, const Real& a, const Real& b, const Real& c) {
  namespace mp = boost::multiprecision;
  switch (op) {
    case Op::Constant:
    case Op::Variable:
    case Op::Hull:
    case Op::Narrow:
      break;
    case Op::Neg:
      return -a;
    case Op::Add:
      return a + b;
    case Op::Sub:
      return a - b;
    case Op::Mul:
      return a * b;
    case Op::Div:
      return a / b;
    case Op::Less:
      return truth(a < b);
    case Op::LessEqual:
      return truth(a <= b);
    case Op::Greater:
      return truth(a > b);
    case Op::GreaterEqual:
      return truth(a >= b);
    case Op::Equal:
      return truth(a == b);
    case Op::NotEqual:
      return truth(a != b);
    case Op::And:
      return truth(a != 0 && b != 0);
    case Op::Or:
      return truth(a != 0 || b != 0);
    case Op::Select:
      return a != 0 ? b : c;
    case Op::Pow:
      return exact_pow(a, b);
    case Op::Sqrt:
      return mp::sqrt(a);
    case Op::Cbrt:
      return a < 0 ? Real(-mp::pow(Real(-a), Real(1) / 3)) : mp::pow(a, Real(1) / 3);
    case Op::Hypot:
      return mp::sqrt(a * a + b * b);
    case Op::Exp:
      return exponential(a);
    case Op::Log:
      return mp::log(a);
    case Op::Log2:
      return mp::log(a) / mp::log(Real(2));
    case Op::Log10:
      return mp::log(a) / mp::log(Real(10));
    case Op::Sin:
      return sine_derivative(0, a);
    case Op::Cos:
      return sine_derivative(1, a);
    case Op::Tan:
      return sine_derivative(0, a) / sine_derivative(1, a);
    case Op::Asin:
      return mp::asin(a);
    case Op::Acos:
      return mp::acos(a);
    case Op::Atan:
      return mp::atan(a);
    case Op::Atan2:
      return mp::atan2(a, b);
    case Op::Sinh:
      return exact_sinh(a);
    case Op::Cosh:
      return (exponential(a) + exponential(Real(-a))) / 2;
    case Op::Tanh:
      return exact_tanh(a);
    case Op::Asinh:
      return exact_asinh(a);
    case Op::Acosh:
      return boost::math::log1p(Real(a - 1 + mp::sqrt(Real(a - 1)) * mp::sqrt(Real(a + 1))));
    case Op::Atanh:
      return boost::math::log1p(Real(2 * a / (1 - a))) / 2;
    case Op::Abs:
      return mp::abs(a);
    case Op::Sign:
      return Real(a.sign());
    case Op::Floor:
      return mp::floor(a);
    case Op::Ceil:
      return mp::ceil(a);
    case Op::Round:
      return mp::round(a);
    case Op::Rint:
      return mp::floor(a + Real(0.5));
    case Op::Trunc:
      return mp::trunc(a);
    case Op::Mod:
      return exact_mod(a, b);
    case Op::Min:
      return b < a ? b : a;
    case Op::Max:
      return a < b ? b : a;
    case Op::Erf:
      return mp::abs(a) > 30 ? Real(a.sign()) : boost::math::erf(a);
    case Op::Gamma:
      return exact_gamma(a);
    case Op::Lgamma:
      return exact_lgamma(a);
    case Op::Polygamma:
      return exact_polygamma(static_cast<int>(a), b);
    case Op::BesselJ:
      return exact_bessel_j(static_cast<int>(a), b);
    case Op::SincN:
      return sinc_series(static_cast<int>(a), b);
  }
  return std::numeric_limits<Real>::quiet_NaN();
}

std::vector<Real> exact_values(const Graph& graph, std::span<const NodeId> roots,
                               const std::function<Real(Symbol)>& variable) {
  const std::vector<bool> needed = reachable(graph, roots);
  std::vector<Real> result(needed.size());
  try {
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id]) continue;
      const Node& node = graph[id];
      if (node.op == Op::Constant) {
        result[id] = node.value;
      } else if (node.op == Op::Variable) {
        result[id] = variable(node.symbol);
      } else {
        const auto [a, b, c] = node.args;
        // The branch that is not taken may be undefined; Select never reads it.
        result[id] = apply_exactly(node.op, result[a], result[b], result[c]);
      }
    }
  } catch (const std::exception&) {
    result.assign(needed.size(), std::numeric_limits<Real>::quiet_NaN());
  }
  return result;
}

Real exact_value(const Graph& graph, NodeId root, const Real& u, const Real& v) {
  const auto variable = [&](Symbol symbol) {
    return symbol == kSymbolU ? u : symbol == kSymbolV ? v : Real(0);
  };
  return exact_values(graph, std::array{root}, variable)[root];
}

}  // namespace saddle
