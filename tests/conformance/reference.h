// The truth about an operation at any doubles: 50 digits where it is a number, the conventions of
// IEEE 754 and of C (ISO 9899, annex F) where it is none.
#pragma once

#include "conformance/arguments.h"
#include "study/high_precision.h"

namespace saddle::testing {

/// The operation's value; NaN or infinite by the conventions. The sign of a zero is not told.
Real reference(Op op, const Arguments& at);

/// Distance of `computed` from `exact` in units in the last place of `scale`: 0 if both are NaN or
/// the same infinity, infinite if only one is. Past the largest double counts as the power of two
/// there; below the smallest normal number the unit is the smallest denormal.
double distance_in_ulps(double computed, const Real& exact, const Real& scale);

/// The unit that an operation's error is measured in is the last place of this. It is the result
/// itself, except where what the operation is made of cancels:
///   mod          a: a - b floor(a/b) takes a multiple of b, as large as a, off a
///   lgamma       1 at least where a < 0, near its many zeros there
///   polygamma    1 at least of order 0, near the zeros of digamma
///   bessel_j     past the order the waves' height, sqrt(2 / (pi x)), near the zeros
///   sinc's       the waves' height, 1/(n+1) or 1/x, near the zeros
Real scale_of(Op op, const Arguments& at, const Real& exact);

/// Whether an infinite result counts as right: SLEEF's documentation lets these overflow a little,
/// or for asinh, acosh and lgamma much, before the function does.
bool may_overflow(Op op, const Arguments& at, const Real& exact);

/// The error of an evaluator's result in the row's unit.
double error_in_ulps(Op op, const Arguments& at, double computed, const Real& exact);

}  // namespace saddle::testing
