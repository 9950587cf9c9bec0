// Complex functions against their definitions by exponentials and logarithms, with 100 digits: over
// the plane, on both sides of each branch cut, and on the cuts by the signs of zeros.
#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "formula/derive.h"
#include "graph_value.h"

namespace saddle {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;

struct WideComplex {
  Wide re, im;
};

WideComplex operator+(const WideComplex& a, const WideComplex& b) {
  return {a.re + b.re, a.im + b.im};
}
WideComplex operator-(const WideComplex& a, const WideComplex& b) {
  return {a.re - b.re, a.im - b.im};
}
WideComplex operator*(const WideComplex& a, const WideComplex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
WideComplex operator/(const WideComplex& a, const WideComplex& b) {
  const Wide size = b.re * b.re + b.im * b.im;
  return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size};
}

const WideComplex kOne = {1, 0};
const WideComplex kI = {0, 1};
const WideComplex kHalf = {Wide(1) / 2, 0};

WideComplex wide_exp(const WideComplex& a) {
  const Wide size = exp(a.re);
  return {size * cos(a.im), size * sin(a.im)};
}
WideComplex wide_log(const WideComplex& a) {
  return {log(a.re * a.re + a.im * a.im) / 2, atan2(a.im, a.re)};
}
WideComplex wide_sqrt(const WideComplex& a) {
  return wide_exp(wide_log(a) * kHalf);
}
WideComplex wide_sinh(const WideComplex& a) {
  return (wide_exp(a) - wide_exp({-a.re, -a.im})) * kHalf;
}
WideComplex wide_cosh(const WideComplex& a) {
  return (wide_exp(a) + wide_exp({-a.re, -a.im})) * kHalf;
}
WideComplex wide_asinh(const WideComplex& a) {
  // By the roots of both factors, which have the cuts of asinh.
  return wide_log(a + wide_sqrt(kOne + kI * a) * wide_sqrt(kOne - kI * a));
}
WideComplex wide_atanh(const WideComplex& a) {
  return (wide_log(kOne + a) - wide_log(kOne - a)) * kHalf;
}
WideComplex wide_acosh(const WideComplex& a) {
  return wide_log(a + wide_sqrt(a + kOne) * wide_sqrt(a - kOne));
}

struct Function {
  std::string formula;  // of w
  std::function<WideComplex(const WideComplex&)> exact;
  double ulps;  // of the absolute value of the result: measured, rounded up
};

const std::vector<Function>& functions() {
  using W = WideComplex;
  static const std::vector<Function> kFunctions = {
      {"w*w", [](const W& z) { return z * z; }, 1},
      {"w^3", [](const W& z) { return z * z * z; }, 2},
      {"w^7", [](const W& z) { return z * z * z * z * z * z * z; }, 3},
      {"1/w", [](const W& z) { return kOne / z; }, 1},
      {"(w+2)/(w-i)",
       [](const W& z) {
         return (z + W{2, 0}) / (z - kI);
       },
       2},
      {"w^1.5",
       [](const W& z) {
         return wide_exp(wide_log(z) * W{Wide(3) / 2, 0});
       },
       4},
      {"w^i", [](const W& z) { return wide_exp(wide_log(z) * kI); }, 9},
      {"e^(i*w)", [](const W& z) { return wide_exp(kI * z); }, 1},
      {"exp(w)", wide_exp, 1},
      {"ln(w)", wide_log, 2},
      {"sqrt(w)", wide_sqrt, 1},
      {"sin(w)", [](const W& z) { return wide_sinh(kI * z) / kI; }, 1},
      {"cos(w)", [](const W& z) { return wide_cosh(kI * z); }, 2},
      {"tan(w)", [](const W& z) { return wide_sinh(kI * z) / kI / wide_cosh(kI * z); }, 2},
      {"sinh(w)", wide_sinh, 1},
      {"cosh(w)", wide_cosh, 2},
      {"tanh(w)", [](const W& z) { return wide_sinh(z) / wide_cosh(z); }, 2},
      {"asin(w)", [](const W& z) { return wide_asinh(kI * z) / kI; }, 2},
      {"acos(w)",
       [](const W& z) {
         const W angle = wide_asinh(kI * z) / kI;
         return W{acos(Wide(-1)) / 2 - angle.re, -angle.im};
       },
       2},
      {"atan(w)", [](const W& z) { return wide_atanh(kI * z) / kI; }, 2},
      {"asinh(w)", wide_asinh, 2},
      {"acosh(w)", wide_acosh, 2},
      {"atanh(w)", wide_atanh, 2},
      {"conj(w)",
       [](const W& z) {
         return W{z.re, -z.im};
       },
       0.5},
      {"abs(w)+0*i",
       [](const W& z) {
         return W{sqrt(z.re * z.re + z.im * z.im), 0};
       },
       1},
      {"arg(w)+0*i",
       [](const W& z) {
         return W{atan2(z.im, z.re), 0};
       },
       1},
  };
  return kFunctions;
}

/// A zero as a number whose sign tells which side of a cut it is.
Wide widened(double a) {
  static const Wide kTiny("1e-60");
  return a != 0 ? Wide(a) : std::signbit(a) ? Wide(-kTiny) : kTiny;
}

/// The plane in all directions, both axes, and beside them.
std::vector<std::array<double, 2>> points() {
  std::vector<double> numbers;
  for (const double size : {0.0, 1e-8, 0.1, 0.5, 0.99, 1.0, 1.01, 2.0, 3.0, 12.0}) {
    numbers.push_back(size);
    numbers.push_back(-size);
  }
  std::vector<std::array<double, 2>> result;
  for (const double x : numbers) {
    for (const double y : numbers) {
      // The angle of 0 is a multiple of pi, of its neighbours not.
      if (x != 0 || y != 0) result.push_back({x, y});
    }
  }
  return result;
}

/// ln near 1, and what is near 0 there, is as exact as the numbers nearest to 1.
double scale_of(const Function& function, const std::array<double, 2>& at, double size) {
  const bool is_of_log = function.formula == "ln(w)" || function.formula == "w^i";
  const bool is_near_one = std::hypot(at[0] - 1, at[1]) < 0.5;
  return is_of_log && is_near_one ? std::max(size, 1.0) : size;
}

TEST(ComplexFunctions, AgreeWithTheirDefinitionsOnBothSidesOfCuts) {
  for (const Function& function : functions()) {
    Graph graph;
    const std::vector<Definition> w = {{"w", "u+i*v"}};
    const NodeId re = testing::parse(graph, "re(" + function.formula + ")", w);
    const NodeId im = testing::parse(graph, "im(" + function.formula + ")", w);
    double worst = 0;
    std::array<double, 2> worst_at = {};
    for (const auto& at : points()) {
      const WideComplex exact = function.exact({widened(at[0]), widened(at[1])});
      const auto size = static_cast<double>(sqrt(Wide(exact.re * exact.re + exact.im * exact.im)));
      if (!(size < 1e8) || size < 1e-20) continue;  // poles, and zeros that are none with 1e-60
      const double got_re = testing::value(graph, re, at[0], at[1]);
      const double got_im = testing::value(graph, im, at[0], at[1]);
      if (!std::isfinite(got_re + got_im)) continue;  // 1e-60 beside a pole
      const Wide d_re = got_re - exact.re;
      const Wide d_im = got_im - exact.im;
      const double distance = static_cast<double>(sqrt(Wide(d_re * d_re + d_im * d_im)));
      const double ulps =
          distance / (scale_of(function, at, size) * std::numeric_limits<double>::epsilon());
      if (ulps <= worst) continue;
      worst = ulps;
      worst_at = at;
    }
    RecordProperty(function.formula, std::to_string(worst));
    EXPECT_LE(worst, function.ulps)
        << function.formula << " at " << worst_at[0] << " + " << worst_at[1] << "i";
  }
}

TEST(ComplexFunctions, HaveExactDerivatives) {
  for (const Function& function : functions()) {
    if (function.formula.starts_with("a") || function.formula.starts_with("conj")) {
      if (function.formula.find('+') != std::string::npos || function.ulps == 0) continue;
    }
    Graph graph;
    const std::vector<Definition> w = {{"w", "u+i*v"}};
    const NodeId re = testing::parse(graph, "re(diff(" + function.formula + ",u))", w);
    const NodeId im = testing::parse(graph, "im(diff(" + function.formula + ",u))", w);
    for (const auto& at : {std::array{0.3, 0.7}, std::array{-1.6, 0.4}, std::array{-0.8, -2.1},
                           std::array{2.5, -0.2}, std::array{0.5, 1e-9}}) {
      // With 100 digits a difference has more than a double's.
      const Wide step("1e-40");
      const WideComplex above = function.exact({Wide(at[0]) + step, Wide(at[1])});
      const WideComplex below = function.exact({Wide(at[0]) - step, Wide(at[1])});
      const auto exact_re = static_cast<double>((above.re - below.re) / (2 * step));
      const auto exact_im = static_cast<double>((above.im - below.im) / (2 * step));
      const double size = std::hypot(exact_re, exact_im);
      constexpr double kRelative = 1e-13;  // some hundred operations
      EXPECT_NEAR(testing::value(graph, re, at[0], at[1]), exact_re, kRelative * size)
          << function.formula << " at " << at[0] << " + " << at[1] << "i";
      EXPECT_NEAR(testing::value(graph, im, at[0], at[1]), exact_im, kRelative * size)
          << function.formula << " at " << at[0] << " + " << at[1] << "i";
    }
  }
}

TEST(ComplexFunctions, OfRealNumbersStayReal) {
  for (const char* formula : {"sqrt(u)", "ln(u)", "asin(u)", "u^0.5", "acosh(u)"}) {
    EXPECT_TRUE(std::isnan(testing::value(formula, -2))) << formula;
  }
}

}  // namespace
}  // namespace saddle
