// Functions of a complex number by other ways than those of the gallery's formulas.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace saddle {

/// |gamma(w)| by Lanczos's sum (g = 7, nine terms: 15 digits), reflected left of 1/2.
inline double gamma_modulus(std::complex<double> w) {
  static constexpr std::array<double, 9> kTerms = {
      0.99999999999980993,  676.5203681218851,     -1259.1392167224028,
      771.32342877765313,   -176.61502916214059,   12.507343278686905,
      -0.13857109526572012, 9.9843695780195716e-6, 1.5056327351493116e-7};
  const double pi = std::numbers::pi;
  if (w.real() < 0.5) return pi / (std::abs(std::sin(pi * w)) * gamma_modulus(1.0 - w));
  w -= 1.0;
  std::complex<double> sum = kTerms[0];
  for (std::size_t k = 1; k < kTerms.size(); ++k) sum += kTerms[k] / (w + double(k));
  const std::complex<double> t = w + 7.5;
  return std::sqrt(2 * pi) * std::abs(std::exp((w + 0.5) * std::log(t) - t) * sum);
}

/// zeta(s) by Euler and Maclaurin's sum: 40 terms and seven Bernoulli numbers.
inline std::complex<double> zeta(std::complex<double> s) {
  static constexpr std::array<double, 7> kBernoulli = {1.0 / 6,  -1.0 / 30,     1.0 / 42, -1.0 / 30,
                                                       5.0 / 66, -691.0 / 2730, 7.0 / 6};
  constexpr double kTerms = 40;
  std::complex<double> sum = 0;
  for (double n = 1; n < kTerms; ++n) sum += std::pow(n, -s);
  sum += std::pow(kTerms, 1.0 - s) / (s - 1.0) + std::pow(kTerms, -s) / 2.0;
  std::complex<double> factor = s * std::pow(kTerms, -s - 1.0) / 2.0;  // over (2k)!
  for (std::size_t k = 1; k <= kBernoulli.size(); ++k) {
    sum += kBernoulli[k - 1] * factor;
    const double m = 2 * double(k);
    factor *= (s + m - 1.0) * (s + m) / (kTerms * kTerms * (m + 1) * (m + 2));
  }
  return sum;
}

}  // namespace saddle
