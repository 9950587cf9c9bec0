// Special functions of intervals: poles, turning points, amplitudes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "eval/interval.h"
#include "formula/special.h"
#include "interval_checks.h"

namespace saddle {
namespace {

using namespace testing;

TEST(Interval, TheGammaFunctionHasPolesAndTurnsBetweenThem) {
  expect_pole(gamma(Interval{-0.5, 0.5}));
  EXPECT_EQ(gamma(Interval{-2, -2}).defined, Defined::No);
  EXPECT_EQ(lgamma(Interval{0, 0}).defined, Defined::No);
  const Interval about_least = gamma(Interval{1, 2});
  EXPECT_NEAR(about_least.low, 0.8856031944108887, 1e-12);
  EXPECT_NEAR(about_least.high, 1, 1e-12);
  const Interval negative = gamma(Interval{-0.75, -0.25});  // turns at -0.504, -3.5446
  EXPECT_NEAR(negative.high, -3.544643611155005, 1e-6);
  EXPECT_NEAR(negative.low, std::tgamma(-0.25), 1e-12);
  expect_proved(negative);
  EXPECT_EQ(gamma(Interval{0, 1}).low, 0.8856031944108886);
  // On x > 0 it is known where they turn.
  EXPECT_EQ(gamma(Interval{1.4, 1.5}).low, 0.8856031944108886);
  EXPECT_EQ(lgamma(Interval{1.4, 1.5}).low, -0.12148629053584962);
  EXPECT_NEAR(lgamma(Interval{0.5, 1.25}).low, std::lgamma(1.25), 1e-12);
  EXPECT_NEAR(lgamma(Interval{3, 5}).low, std::log(2), 1e-12);
}

TEST(Interval, PolygammaIsMonotoneOrConvexBetweenPoles) {
  const Interval digamma = polygamma({0, 0}, {1, 2});
  EXPECT_NEAR(digamma.low, -0.5772156649015329, 1e-12);
  EXPECT_NEAR(digamma.high, 0.42278433509846714, 1e-12);
  const Interval trigamma = polygamma({1, 1}, {-0.75, -0.25});  // turns within
  double least = testing::kInfinity;
  for (double x = -0.75; x <= -0.25; x += 1e-3) least = std::min(least, polygamma(1, x));
  EXPECT_LE(trigamma.low, least);
  EXPECT_GT(trigamma.low, least - 1e-3);
  expect_pole(polygamma({1, 1}, {-1.5, -0.5}));
  EXPECT_EQ(polygamma({1, 1}, {-1, -1}).defined, Defined::No);
}

TEST(Interval, OscillatingFunctionsAreBoundedByTheirAmplitude) {
  expect_exact(bessel_j({0, 0}, kAll), -1, 1);
  EXPECT_LE(sinc_derivative({0, 0}, {100, 200}).high, 0.0200001);
  expect_bounds(sinc_derivative({1, 1}, kAll), -0.5, 0.5);
  const Interval crest = sinc_derivative({0, 0}, {-0.125, 0.125});
  EXPECT_EQ(crest.high, 1);
  EXPECT_GT(crest.low, 0.99);
}

}  // namespace
}  // namespace saddle
