// Complex functions against their definitions by exponentials and logarithms, with 100 digits.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <string>
#include <vector>

namespace saddle::testing {

using Wide = boost::multiprecision::cpp_bin_float_100;

struct WideComplex {
  Wide re, im;
};

struct ComplexFunction {
  std::string formula;  ///< of w
  std::function<WideComplex(const WideComplex&)> exact;
  double ulps;  ///< of the absolute value of the result: measured, rounded up
};

/// The complex functions of the language, and what is made of its operators.
const std::vector<ComplexFunction>& complex_functions();

/// The largest error of a function at some points, in units in the last place of the absolute value
/// of the result.
struct ComplexError {
  double ulps = 0;
  std::array<double, 2> at = {};
};

struct ComplexAccuracy {
  ComplexError plane;   ///< at random points, with absolute values from 1e-8 to 12
  ComplexError axes;    ///< on the axes, by the signs of zeros, which tell the side of a cut
  ComplexError beside;  ///< 1e-8 beside the axes
};

/// By the tape, on the processor's best level; at `count` random points. Points at which the result
/// is 0, or more than 1e8, do not count.
ComplexAccuracy measure_accuracy(const ComplexFunction& function, int count);

}  // namespace saddle::testing
