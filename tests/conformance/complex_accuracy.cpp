#include "conformance/complex_accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "eval/batch.h"
#include "graph_value.h"

namespace saddle::testing {
namespace {

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

/// A zero as a number whose sign tells which side of a cut it is.
Wide widened(double a) {
  static const Wide kTiny("1e-60");
  return a != 0 ? Wide(a) : std::signbit(a) ? Wide(-kTiny) : kTiny;
}

using Points = std::vector<std::array<double, 2>>;

/// All sizes in all directions.
Points random_points(int count) {
  std::mt19937_64 random(1);
  Points result;
  for (int k = 0; k < count; ++k) {
    const double size =
        std::pow(10, std::uniform_real_distribution(-8.0, std::log10(12.0))(random));
    const double angle =
        std::uniform_real_distribution(-std::numbers::pi, std::numbers::pi)(random);
    result.push_back({size * std::cos(angle), size * std::sin(angle)});
  }
  return result;
}

/// Points of which one coordinate is `off` or -`off`.
Points points_beside_axes(double off) {
  Points result;
  for (const double size : {1e-8, 0.1, 0.5, 0.99, 1.0, 1.01, 2.0, 3.0, 12.0}) {
    for (const double along : {size, -size}) {
      for (const double across : {off, -off}) {
        result.push_back({along, across});
        result.push_back({across, along});
      }
    }
  }
  return result;
}

/// ln near 1, and what is near 0 there, is as exact as the numbers nearest to 1.
double scale_of(const ComplexFunction& function, const std::array<double, 2>& at, double size) {
  const bool is_of_log = function.formula == "ln(w)" || function.formula == "w^i";
  const bool is_near_one = std::hypot(at[0] - 1, at[1]) < 0.5;
  return is_of_log && is_near_one ? std::max(size, 1.0) : size;
}

ComplexError worst_error(const ComplexFunction& function, const Tape& tape, const Points& points) {
  std::vector<double> u, v;
  for (const auto& at : points) {
    u.push_back(at[0]);
    v.push_back(at[1]);
  }
  std::vector<double> re(points.size()), im(points.size());
  const std::array<double*, 2> outputs = {re.data(), im.data()};
  evaluate_points(tape, u, v, outputs);
  ComplexError worst;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::array<double, 2>& at = points[k];
    const WideComplex exact = function.exact({widened(at[0]), widened(at[1])});
    const auto size = static_cast<double>(sqrt(Wide(exact.re * exact.re + exact.im * exact.im)));
    if (!(size < 1e8) || size < 1e-20) continue;  // poles, and zeros that are none with 1e-60
    if (!std::isfinite(re[k] + im[k])) continue;  // 1e-60 beside a pole
    const Wide d_re = re[k] - exact.re;
    const Wide d_im = im[k] - exact.im;
    const double distance = static_cast<double>(sqrt(Wide(d_re * d_re + d_im * d_im)));
    const double ulps =
        distance / (scale_of(function, at, size) * std::numeric_limits<double>::epsilon());
    if (ulps > worst.ulps) worst = {ulps, at};
  }
  return worst;
}

}  // namespace

const std::vector<ComplexFunction>& complex_functions() {
  using W = WideComplex;
  static const std::vector<ComplexFunction> kFunctions = {
      {"w*w", [](const W& z) { return z * z; }, 1},
      {"w^3", [](const W& z) { return z * z * z; }, 2},
      {"w^7", [](const W& z) { return z * z * z * z * z * z * z; }, 4},
      {"1/w", [](const W& z) { return kOne / z; }, 1.5},
      {"(w+2)/(w-i)",
       [](const W& z) {
         return (z + W{2, 0}) / (z - kI);
       },
       2.5},
      {"w^1.5",
       [](const W& z) {
         return wide_exp(wide_log(z) * W{Wide(3) / 2, 0});
       },
       4},
      {"w^i", [](const W& z) { return wide_exp(wide_log(z) * kI); }, 9},
      {"e^(i*w)", [](const W& z) { return wide_exp(kI * z); }, 1.5},
      {"exp(w)", wide_exp, 1.5},
      {"ln(w)", wide_log, 2},
      {"sqrt(w)", wide_sqrt, 1},
      {"sin(w)", [](const W& z) { return wide_sinh(kI * z) / kI; }, 1.5},
      {"cos(w)", [](const W& z) { return wide_cosh(kI * z); }, 2},
      {"tan(w)", [](const W& z) { return wide_sinh(kI * z) / kI / wide_cosh(kI * z); }, 2},
      {"sinh(w)", wide_sinh, 1.5},
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

ComplexAccuracy measure_accuracy(const ComplexFunction& function, int count) {
  Graph graph;
  const std::vector<Definition> w = {{"w", "u+i*v"}};
  const std::array parts = {parse(graph, "re(" + function.formula + ")", w),
                            parse(graph, "im(" + function.formula + ")", w)};
  const Tape tape = compile(graph, parts);
  return {worst_error(function, tape, random_points(count)),
          worst_error(function, tape, points_beside_axes(0.0)),
          worst_error(function, tape, points_beside_axes(1e-8))};
}

}  // namespace saddle::testing
