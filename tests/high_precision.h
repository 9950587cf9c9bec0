// Values of graphs with 50 digits, from Boost's functions: independent of the table's own values.
#pragma once

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <vector>

#include "formula/graph.h"

namespace saddle::testing {

using Real = boost::multiprecision::cpp_bin_float_50;

inline Real truth(bool condition) {
  return condition ? Real(1) : Real(0);
}

/// The n-th derivative of sin(x)/x from its power series: good for |x| < 20 with 50 digits.
inline Real sinc_series(int n, const Real& x) {
  Real sum = 0;
  Real power = n % 2 == 0 ? Real(1) : x;  // x^m / m!
  for (int m = n % 2; m < 200; m += 2) {
    const Real term = power / (m + n + 1);
    sum += (m + n) / 2 % 2 == 0 ? term : Real(-term);
    power *= x * x / ((m + 1) * (m + 2));
  }
  return sum;
}

/// Polygamma by steps of 1 to where x > 0: Boost's own reflection is wrong at -1/2.
inline Real shifted_polygamma(int n, Real x) {
  Real sum = 0;
  for (; x < 0; x += 1)
    sum += boost::math::tgamma(Real(n + 1)) / boost::multiprecision::pow(x, n + 1);
  return boost::math::polygamma(n, x) + (n % 2 == 0 ? Real(-sum) : sum);
}

inline Real apply_exactly(Op op, const Real& a, const Real& b, const Real& c) {
  namespace mp = boost::multiprecision;
  switch (op) {
    case Op::Constant:
    case Op::Variable:
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
      return mp::pow(a, b);
    case Op::Sqrt:
      return mp::sqrt(a);
    case Op::Cbrt:
      return a < 0 ? Real(-mp::pow(Real(-a), Real(1) / 3)) : mp::pow(a, Real(1) / 3);
    case Op::Hypot:
      return mp::sqrt(a * a + b * b);
    case Op::Exp:
      return mp::exp(a);
    case Op::Log:
      return mp::log(a);
    case Op::Log2:
      return mp::log(a) / mp::log(Real(2));
    case Op::Log10:
      return mp::log(a) / mp::log(Real(10));
    case Op::Sin:
      return mp::sin(a);
    case Op::Cos:
      return mp::cos(a);
    case Op::Tan:
      return mp::tan(a);
    case Op::Asin:
      return mp::asin(a);
    case Op::Acos:
      return mp::acos(a);
    case Op::Atan:
      return mp::atan(a);
    case Op::Atan2:
      return mp::atan2(a, b);
    case Op::Sinh:
      return (mp::exp(a) - mp::exp(Real(-a))) / 2;
    case Op::Cosh:
      return (mp::exp(a) + mp::exp(Real(-a))) / 2;
    case Op::Tanh:
      return 1 - 2 / (mp::exp(Real(2 * a)) + 1);
    case Op::Asinh:
      return mp::log(a + mp::sqrt(a * a + 1));
    case Op::Acosh:
      return mp::log(a + mp::sqrt(a - 1) * mp::sqrt(a + 1));
    case Op::Atanh:
      return mp::log((1 + a) / (1 - a)) / 2;
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
      return a - b * mp::floor(a / b);
    case Op::Min:
      return b < a ? b : a;
    case Op::Max:
      return a < b ? b : a;
    case Op::Erf:
      return boost::math::erf(a);
    case Op::Gamma:
      return boost::math::tgamma(a);
    case Op::Lgamma:
      return boost::math::lgamma(a);
    case Op::Polygamma:
      return shifted_polygamma(static_cast<int>(a), b);
    case Op::BesselJ:
      return boost::math::cyl_bessel_j(static_cast<int>(a), b);
    case Op::SincN:
      return sinc_series(static_cast<int>(a), b);
  }
  return std::numeric_limits<Real>::quiet_NaN();
}

/// The value of `root` at (u, v), t = 0; NaN where Boost finds an argument outside of a domain.
inline Real exact_value(const Graph& graph, NodeId root, const Real& u, const Real& v) {
  const std::vector<NodeId> roots = {root};
  const std::vector<bool> needed = reachable(graph, roots);
  std::vector<Real> result(needed.size());
  try {
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id]) continue;
      const Node& node = graph[id];
      if (node.op == Op::Constant) {
        result[id] = node.value;
      } else if (node.op == Op::Variable) {
        result[id] = node.symbol == kSymbolU ? u : node.symbol == kSymbolV ? v : Real(0);
      } else {
        const auto [a, b, c] = node.args;
        // The branch that is not taken may be undefined; Select below never reads it.
        result[id] = apply_exactly(node.op, result[a], result[b], result[c]);
      }
    }
  } catch (const std::exception&) {
    return std::numeric_limits<Real>::quiet_NaN();
  }
  return result[root];
}

}  // namespace saddle::testing
