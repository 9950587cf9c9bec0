// Functions of a real number that the table of operations needs and <cmath> lacks.
#pragma once

namespace saddle {

// Static, so that each file has its own copies: eval/kernel_loops.cpp compiles them for several
// instruction sets, and the linker must not mix those up.

/// -1, 0 or 1; NaN of NaN.
static inline double sign(double a) {
  return a > 0 ? 1.0 : a < 0 ? -1.0 : a;
}

/// Minimum and maximum; NaN if either is NaN, so that what is undefined stays undefined.
static inline double smaller(double a, double b) {
  return b < a || b != b ? b : a;
}
static inline double larger(double a, double b) {
  return a < b || b != b ? b : a;
}

/// ln |gamma(x)|. Unlike std::lgamma it writes no global, so threads may share it.
double log_gamma(double x);

/// Derivative of order `n` + 1 of ln gamma(x): digamma for n = 0, trigamma for n = 1 ... n is a
/// whole number >= 0. NaN at the poles 0, -1, -2 ...
/// Source: M. Abramowitz, I. Stegun, "Handbook of mathematical functions", 1964, 6.4.
double polygamma(double n, double x);

/// Bessel function of the first kind of whole order `n`.
double bessel_j(double n, double x);

/// Derivative of order `n` (whole, >= 0) of sin(x)/x, continued to x = 0.
double sinc_derivative(double n, double x);

}  // namespace saddle
