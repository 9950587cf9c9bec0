// Powers of intervals: poles, signs, whole exponents.
#include <gtest/gtest.h>

#include "eval/interval.h"
#include "interval_checks.h"

namespace saddle {
namespace {

using namespace testing;

TEST(Interval, AWholePowerIsAsNarrowAsItsRange) {
  expect_exact(enclosure("u^3", {-1, 2}), -1, 8);
  expect_exact(enclosure("u^4", {-2, 1}), 0, 16);
  expect_exact(enclosure("u^3", {-1, 2}, {}, Powers::Products), -4, 8);
  expect_bounds(pow(Interval{-1, 2}, {21, 21}), -1, 2097152);
  expect_bounds(enclosure("u^(-2)", {2, 4}), 1.0 / 16, 0.25);
}

TEST(Interval, ThePowerOfANegativeNumberIsDefinedForWholeExponentsOnly) {
  EXPECT_EQ(pow({-2, -1}, {0.5, 0.5}).defined, Defined::No);
  EXPECT_EQ(pow({-2, -1}, {0.25, 0.75}).defined, Defined::No);
  const Interval across = pow({-2, 4}, {0.5, 0.5});
  EXPECT_EQ(across.defined, Defined::Maybe);
  expect_bounds(across, 0, 2);
  const Interval any = pow({-2, -1}, {0.5, 3.5});
  expect_pole(any);
  EXPECT_TRUE(contains(any, -8) && contains(any, 4));
}

TEST(Interval, ThePowerOfZeroIsAPoleForNegativeExponents) {
  expect_pole(pow({0, 0}, {-0.5, -0.5}));
  expect_pole(pow({0, 0}, {-1, -1}));
  expect_pole(pow({0, 1}, {-0.5, -0.5}));
  expect_pole(pow({-1, 1}, {-3, -3}));
  expect_bounds(pow({-1, 2}, {-2, -2}), 0.25, kInfinity);
  expect_exact(pow({0, 0}, {0.5, 0.5}), 0, 0);
}

TEST(Interval, PowersHaveTheirExtremesAtTheCorners) {
  expect_bounds(pow({0.5, 2}, {-1, 3}), 0.125, 8);
  EXPECT_FALSE(pow({0, 1}, {0, 1}).continuous);
  expect_exact(pow({-3, 5}, {0, 0}), 1, 1);
}

TEST(Interval, APowerOfTheUndefinedMayBeOne) {
  expect_exact(pow(kUndefined, {0, 0}), 1, 1);
  EXPECT_EQ(pow(kUndefined, {0, 0}).defined, Defined::Maybe);
  EXPECT_EQ(pow({1, 1}, kUndefined).defined, Defined::Maybe);
  EXPECT_EQ(pow({2, 2}, kUndefined).defined, Defined::No);
}

}  // namespace
}  // namespace saddle
