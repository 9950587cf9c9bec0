// The enclosure of a function's values over a box, and bounds of results that doubles round.
// Source: IEEE 1788-2015, "Standard for interval arithmetic".
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace saddle {

/// At how many points of the box the function is defined: a real number comes out, and out of
/// every operation on the way. 1/0 is none, so atan(1/0) is undefined (doubles give pi/2).
enum class Defined : std::uint8_t { No, Maybe, Yes };

/// The values of a function over a box: all lie in [low, high], those that exact arithmetic on
/// reals gives and those that the evaluator gives in doubles (where no NaN and no infinity was on
/// the way). `low` may be -inf and `high` inf, for "no bound is known"; never the reverse.
struct Interval {
  double low = 0;
  double high = 0;
  Defined defined = Defined::Yes;
  /// Proved: no jump and no pole in the box. The edge of a domain (sqrt or ln at 0) is neither.
  bool continuous = true;
};

/// The values of a function that is nowhere defined: low > high.
inline constexpr Interval kUndefined = {std::numeric_limits<double>::infinity(),
                                        -std::numeric_limits<double>::infinity(), Defined::No,
                                        true};

/// Proved: defined in the whole box, without a jump or a pole.
inline bool is_continuous(const Interval& a) {
  return a.defined == Defined::Yes && a.continuous;
}

inline bool contains(const Interval& a, double x) {
  return a.low <= x && x <= a.high;
}
inline bool is_point(const Interval& a) {
  return a.low == a.high;
}

namespace rounding {

inline constexpr double kMax = std::numeric_limits<double>::max();

/// Bounds an exactly rounded operation: 2^-52 |x| is at least the distance of x to its neighbours,
/// so x - kRoundoff |x| is at most the next number below x, and the exact result is above that.
inline constexpr double kRoundoff = 0x1p-52;

/// Results this small, and so all that may have lost digits to underflow, are bounded by this and
/// by zero. 2^-52 of it is still a normal number: denormal ones are slow.
inline constexpr double kUnderflow = 0x1p-960;

/// A lower bound of a result with the computed value x, sign right, that is off by error * |x| at
/// most. Zero counts as exact.
inline double down(double x, double error) {
  const double size = std::fabs(x);
  if (size < kUnderflow) return x < 0 ? -kUnderflow : 0;
  if (size > kMax) return std::min(x, kMax);  // finite, but too large
  return x - size * error;
}
inline double up(double x, double error) {
  return -down(-x, error);
}

/// Numbers of the low and of the high end of an interval, on which operations work at once.
using Ends [[gnu::vector_size(16)]] = double;

inline Ends absolute(Ends a) {
  using Bits [[gnu::vector_size(16)]] = std::int64_t;
  constexpr std::int64_t kNoSign = std::numeric_limits<std::int64_t>::max();
  return std::bit_cast<Ends>(std::bit_cast<Bits>(a) & Bits{kNoSign, kNoSign});
}

/// A lower bound of the low ends' sum, and an upper bound of the high ends'. A sum that can be
/// taken apart again is exact, as is every sum so small that it could underflow (O. Moller, "Quasi
/// double-precision in floating point addition", 1965).
inline Ends sums(Ends a, Ends b) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  constexpr Ends kMost = {kMax, kEndless};
  constexpr Ends kLeast = {-kEndless, -kMax};
  constexpr Ends kOutward = {-kRoundoff, kRoundoff};
  Ends sum = a + b;
  sum = kMost < sum ? kMost : sum;
  sum = sum < kLeast ? kLeast : sum;
  const Ends lost = absolute(sum - a - b) + absolute(sum - b - a);
  const Ends error = lost <= 0 ? Ends{0, 0} : kOutward;
  return sum + absolute(sum) * error;
}

inline double sum_down(double a, double b) {
  return sums(Ends{a, a}, Ends{b, b})[0];
}
inline double sum_up(double a, double b) {
  return sums(Ends{a, a}, Ends{b, b})[1];
}

/// Zero bits at the end of the 53 that make up either number's significand.
inline int trailing_zeros(double a, double b) {
  constexpr std::uint64_t kLeadingBit = std::uint64_t{1} << 52U;
  return std::countr_zero(std::bit_cast<std::uint64_t>(a) | std::bit_cast<std::uint64_t>(b) |
                          kLeadingBit);
}

/// The error of the four products of the ends of a and b: none where 53 bits hold them all, as they
/// do for boxes from bisecting [-1, 1].
inline double product_error(const Interval& a, const Interval& b) {
  const int zeros = trailing_zeros(a.low, a.high) + trailing_zeros(b.low, b.high);
  return zeros >= 53 ? 0 : kRoundoff;
}

/// The decorations of a result: undefined where one argument is, continuous where both are.
inline Interval with_decorations_of(const Interval& a, const Interval& b) {
  return {0, 0, std::min(a.defined, b.defined), a.continuous && b.continuous};
}

}  // namespace rounding

}  // namespace saddle
