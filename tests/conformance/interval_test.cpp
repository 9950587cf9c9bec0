// Every operation's enclosure of single numbers against 50 digits, at nasty arguments. Boxes that
// are wider are property/interval_test.cpp's.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "conformance/reference.h"
#include "eval/enclose.h"

namespace saddle::testing {
namespace {

bool is_finite(const Arguments& at) {
  return std::isfinite(at.a) && std::isfinite(at.b) && std::isfinite(at.c);
}

/// The truth is known to 50 digits, less those that a power loses.
const Real kTruth("1e-44");

/// What is so small or so large that doubles have no number for it counts as its end.
bool holds(const Interval& found, const Real& exact) {
  const Real error = kTruth * abs(exact) + std::numeric_limits<double>::denorm_min();
  const bool above =
      found.low == -std::numeric_limits<double>::infinity() || Real(found.low) <= exact + error;
  const bool below =
      found.high == std::numeric_limits<double>::infinity() || exact - error <= Real(found.high);
  return above && below;
}

TEST(Conformance, EnclosuresOfNumbersHoldTheTruthOfEveryOperation) {
  for (const Operation& row : kOperations) {
    for (const Arguments& at : arguments_of(row)) {
      if (!is_finite(at)) continue;
      const Interval found = enclose(row.op, constant_interval(at.a), constant_interval(at.b),
                                     constant_interval(at.c));
      const Real exact = reference(row.op, at);
      const auto where = [&] {
        std::ostringstream text;
        text << row.id << " of " << at.a << ", " << at.b << ", " << at.c << ": [" << found.low
             << ", " << found.high << "], " << exact;
        return text.str();
      };
      if (boost::multiprecision::isnan(exact)) {
        EXPECT_NE(found.defined, Defined::Yes) << where();
      } else if (boost::multiprecision::isinf(exact)) {
        // A pole, or what overflows: a number all the same, too large for doubles.
        EXPECT_TRUE(found.defined != Defined::Yes || std::isinf(found.low) ||
                    std::isinf(found.high))
            << where();
      } else {
        EXPECT_NE(found.defined, Defined::No) << where();
        EXPECT_TRUE(holds(found, exact)) << where();
      }
    }
  }
}

}  // namespace
}  // namespace saddle::testing
