// A long sum keeps the digits of a double.
#include "base/compensated_sum.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

TEST(CompensatedSum, OfMillionsOfEqualTermsIsTheirProduct) {
  // A plain sum is off by 1.6e-4: many additions in a row round in the same direction.
  CompensatedSum sum;
  for (int k = 0; k < 10'000'000; ++k) sum.add(0.1);
  EXPECT_NEAR(sum.value(), 1e6, 1e-10);
}

TEST(CompensatedSum, KeepsWhatALargerTermHides) {
  CompensatedSum sum;
  for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
  EXPECT_EQ(sum.value(), 2);
}

}  // namespace
}  // namespace saddle
