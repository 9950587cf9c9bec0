#include "conformance/reference.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace saddle::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalfPi = 1.570796326794896619231322;

/// The ends of a function's domain and its values there, or limits. Outside it is NaN.
struct Ends {
  Op op;
  double low;
  double at_low;
  double high;
  double at_high;
};

constexpr std::array kEnds = {
    Ends{Op::Neg, -kInfinity, kInfinity, kInfinity, -kInfinity},
    Ends{Op::Sqrt, 0, 0, kInfinity, kInfinity},
    Ends{Op::Cbrt, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Exp, -kInfinity, 0, kInfinity, kInfinity},
    Ends{Op::Log, 0, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Log2, 0, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Log10, 0, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Sin, -kInfinity, kNan, kInfinity, kNan},
    Ends{Op::Cos, -kInfinity, kNan, kInfinity, kNan},
    Ends{Op::Tan, -kInfinity, kNan, kInfinity, kNan},
    Ends{Op::Asin, -1, -kHalfPi, 1, kHalfPi},
    Ends{Op::Acos, -1, 2 * kHalfPi, 1, 0},
    Ends{Op::Atan, -kInfinity, -kHalfPi, kInfinity, kHalfPi},
    Ends{Op::Sinh, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Cosh, -kInfinity, kInfinity, kInfinity, kInfinity},
    Ends{Op::Tanh, -kInfinity, -1, kInfinity, 1},
    Ends{Op::Asinh, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Acosh, 1, 0, kInfinity, kInfinity},
    Ends{Op::Atanh, -1, -kInfinity, 1, kInfinity},
    Ends{Op::Abs, -kInfinity, kInfinity, kInfinity, kInfinity},
    Ends{Op::Sign, -kInfinity, -1, kInfinity, 1},
    Ends{Op::Floor, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Ceil, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Round, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Rint, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Trunc, -kInfinity, -kInfinity, kInfinity, kInfinity},
    Ends{Op::Erf, -kInfinity, -1, kInfinity, 1},
    Ends{Op::Gamma, -kInfinity, kNan, kInfinity, kInfinity},
    Ends{Op::Lgamma, -kInfinity, kInfinity, kInfinity, kInfinity},
    Ends{Op::BesselJ, -kInfinity, 0, kInfinity, 0},
    Ends{Op::SincN, -kInfinity, 0, kInfinity, 0},
    Ends{Op::Polygamma, -kInfinity, kNan, kInfinity, 0},  // of order 0: infinite, see below
};

/// What a function of one argument, or of an order and one argument, is where its domain ends.
std::optional<double> end_convention(Op op, double order, double x) {
  if (std::isnan(x)) return kNan;
  for (const Ends& ends : kEnds) {
    if (ends.op != op) continue;
    if (x < ends.low || x > ends.high) return kNan;
    if (x == kInfinity && op == Op::Polygamma && order == 0) return kInfinity;
    if (x == ends.low) return ends.at_low;
    if (x == ends.high) return ends.at_high;
  }
  const bool pole = x <= 0 && x == std::floor(x);
  if (pole && op == Op::Gamma) return x == 0 ? std::copysign(kInfinity, x) : kNan;
  if (pole && op == Op::Lgamma) return kInfinity;
  if (pole && op == Op::Polygamma) return kNan;
  return std::nullopt;
}

bool is_odd(double x) {
  return std::fabs(std::fmod(x, 2)) == 1;
}

std::optional<double> pow_convention(double a, double b) {
  if (a == 1 || b == 0) return 1;
  if (std::isnan(a) || std::isnan(b)) return kNan;
  if (std::isinf(b)) {
    if (a == -1) return 1;
    return (std::fabs(a) > 1) == (b > 0) ? kInfinity : 0;
  }
  if (a == 0 || std::isinf(a)) {
    const double size = (a == 0) == (b < 0) ? kInfinity : 0;
    return is_odd(b) ? std::copysign(size, a) : size;
  }
  return std::nullopt;
}

std::optional<double> atan2_convention(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return kNan;
  const bool left = std::signbit(b);
  std::optional<double> size;
  if (std::isinf(a)) {
    size = !std::isinf(b) ? kHalfPi : left ? 1.5 * kHalfPi : 0.5 * kHalfPi;
  } else if (a == 0 || std::isinf(b)) {
    size = left ? 2 * kHalfPi : 0;
  } else if (b == 0) {
    size = kHalfPi;
  }
  if (!size) return std::nullopt;
  return std::copysign(*size, a);
}

/// Arithmetic with infinities, NaN and zero divisors is the processor's: IEEE 754.
std::optional<double> arithmetic_convention(Op op, double a, double b) {
  if (std::isfinite(a) && std::isfinite(b) && b != 0) return std::nullopt;
  switch (op) {
    case Op::Add:
      return a + b;
    case Op::Sub:
      return a - b;
    case Op::Mul:
      return a * b;
    case Op::Div:
      return a / b;
    default:
      return std::nullopt;
  }
}

std::optional<double> comparison(Op op, double a, double b) {
  switch (op) {
    case Op::Less:
      return a < b;
    case Op::LessEqual:
      return a <= b;
    case Op::Greater:
      return a > b;
    case Op::GreaterEqual:
      return a >= b;
    case Op::Equal:
      return a == b;
    case Op::NotEqual:
      return a != b;
    case Op::And:
      return a != 0 && b != 0;
    case Op::Or:
      return a != 0 || b != 0;
    case Op::Min:
      return std::isnan(a) || std::isnan(b) ? kNan : std::fmin(a, b);
    case Op::Max:
      return std::isnan(a) || std::isnan(b) ? kNan : std::fmax(a, b);
    default:
      return std::nullopt;
  }
}

/// The value where an argument or the result is no number; nothing where 50 digits decide.
std::optional<double> convention(Op op, const Arguments& at) {
  const auto [a, b, c] = at;
  if (op == Op::Select) return a != 0 ? b : c;
  if (op == Op::Pow) return pow_convention(a, b);
  if (op == Op::Atan2) return atan2_convention(a, b);
  if (op == Op::Hypot) {
    if (std::isinf(a) || std::isinf(b)) return kInfinity;
    return std::isnan(a) || std::isnan(b) ? std::optional(kNan) : std::nullopt;
  }
  // By definition a - b floor(a/b), infinite or NaN where that overflows.
  if (op == Op::Mod && !std::isfinite(b * std::floor(a / b))) return a - b * std::floor(a / b);
  if (takes_an_order(op)) return end_convention(op, a, b);
  if (arity(op) == 1) return end_convention(op, 0, a);
  if (const std::optional<double> value = comparison(op, a, b)) return value;
  return arithmetic_convention(op, a, b);
}

/// 2^(floor(log2 |x|) - 52), but the smallest denormal at least.
Real unit_in_the_last_place(const Real& x) {
  constexpr int kDigits = 52;
  constexpr int kLowestExponent = -1022;
  if (x == 0) return ldexp(Real(1), kLowestExponent - kDigits);
  const int exponent = std::max(static_cast<int>(ilogb(x)), kLowestExponent);
  return ldexp(Real(1), exponent - kDigits);
}

}  // namespace

Real reference(Op op, const Arguments& at) {
  if (const std::optional<double> value = convention(op, at)) return *value;
  try {
    return apply_exactly(op, at.a, at.b, at.c);
  } catch (const std::exception&) {
    return kNan;
  }
}

double distance_in_ulps(double computed, const Real& exact, const Real& scale) {
  if (std::isnan(computed) || isnan(exact)) {
    return std::isnan(computed) && isnan(exact) ? 0 : kInfinity;
  }
  const Real end = ldexp(Real(1), std::numeric_limits<double>::max_exponent);
  const auto clamped = [&end](const Real& x) { return x > end ? end : x < -end ? Real(-end) : x; };
  if (isinf(exact) && !std::isinf(computed)) return kInfinity;
  const Real unit = unit_in_the_last_place(clamped(scale));
  return static_cast<double>(abs(clamped(computed) - clamped(exact)) / unit);
}

Real scale_of(Op op, const Arguments& at, const Real& exact) {
  const double x = std::fabs(at.b);
  double least = 0;
  if (op == Op::Mod) least = std::fabs(at.a);
  if (op == Op::Lgamma && at.a < 0) least = 1;
  if (op == Op::Polygamma && at.a == 0) least = 1;
  if (op == Op::BesselJ && x > std::fmax(at.a, 1)) least = std::sqrt(1 / (kHalfPi * x));
  if (op == Op::SincN && x > 1) least = 1 / std::fmax(at.a + 1, x);
  return abs(exact) < least ? Real(least) : exact;
}

bool may_overflow(Op op, const Arguments& at, const Real& exact) {
  const double size = std::fabs(at.a);
  switch (op) {
    case Op::Exp:
    case Op::Pow:
      return abs(exact) > (1 - 1e-12) * std::numeric_limits<double>::max();
    case Op::Sinh:
    case Op::Cosh:
      return size > 709;
    case Op::Asinh:
    case Op::Acosh:
      return size > 1.34e154;  // its square overflows
    case Op::Lgamma:
      return at.a > 2e305;
    default:
      return false;
  }
}

double error_in_ulps(Op op, const Arguments& at, double computed, const Real& exact) {
  if (std::isinf(computed) && (computed > 0) == (exact > 0) && may_overflow(op, at, exact))
    return 0;
  const Real scale = scale_of(op, at, exact);
  const double error = distance_in_ulps(computed, exact, scale);
  if (op != Op::Mod || !std::isfinite(at.b) || !(error > 1)) return error;
  // Where a/b rounds to a whole number the result may be at the other end of its range: mod is
  // measured around the circle of length b.
  return std::fmin(error, std::fmin(distance_in_ulps(computed, Real(exact + at.b), scale),
                                    distance_in_ulps(computed, Real(exact - at.b), scale)));
}

}  // namespace saddle::testing
