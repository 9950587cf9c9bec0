// Powers, elementary and special functions of intervals: domains, poles, turning points.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "eval/interval.h"
#include "formula/special.h"
#include "interval_checks.h"

namespace saddle {
namespace {

using namespace testing;

constexpr double kPi = 3.14159265358979323846;

TEST(Interval, AWholePowerIsAsNarrowAsItsRange) {
  expect_exact(enclosure("u^3", {-1, 2}), -1, 8);
  expect_exact(enclosure("u^4", {-2, 1}), 0, 16);
  expect_exact(enclosure("u^3", {-1, 2}, {}, Powers::Products), -4, 8);
  expect_bounds(pow(Interval{-1, 2}, {21, 21}), -1, 2097152);
  expect_bounds(enclosure("u^(-2)", {2, 4}), 1.0 / 16, 0.25);
}

TEST(Interval, DomainsAreProvedCrossedOrMissed) {
  using Function = Interval (*)(const Interval&);
  struct Case {
    Function f;
    Interval within, across, outside;
  };
  const std::array<Case, 8> cases = {{{sqrt, {0, 1}, {-1, 1}, {-2, -1}},
                                      {log, {1e-9, 1}, {0, 1}, {-1, 0}},
                                      {log2, {1e-9, 1}, {-1, 1}, {-1, 0}},
                                      {log10, {1e-9, 1}, {-1, 1}, {-1, 0}},
                                      {asin, {-1, 1}, {0, 1.5}, {1.01, 2}},
                                      {acos, {-1, 1}, {-2, 0}, {-2, -1.01}},
                                      {acosh, {1, 2}, {0, 2}, {-1, 0.9}},
                                      {atanh, {-0.9, 0.9}, {0, 1}, {1, 2}}}};
  for (const Case& c : cases) {
    expect_proved(c.f(c.within));
    EXPECT_EQ(c.f(c.across).defined, Defined::Maybe);
    EXPECT_TRUE(c.f(c.across).continuous);  // the edge of a domain is no jump
    EXPECT_EQ(c.f(c.outside).defined, Defined::No);
  }
}

TEST(Interval, WavesHaveTheirTurningPoints) {
  expect_exact(sin(Interval{0, 7}), -1, 1);
  expect_bounds(sin(Interval{1, 2}), std::sin(1), 1);
  expect_bounds(sin(Interval{-2, 1}), -1, std::sin(1));
  expect_bounds(sin(Interval{0.1, 0.2}), std::sin(0.1), std::sin(0.2));
  expect_bounds(cos(Interval{-1, 0.5}), std::cos(1), 1);
  expect_bounds(cos(Interval{3, 4}), -1, std::cos(4));
  expect_bounds(cos(Interval{1e6, 1e6 + 0.001}), std::cos(1e6), std::cos(1e6 + 0.001));
  expect_exact(sin(Interval{1e15, 1e15}), -1, 1);
  expect_exact(cos(kAll), -1, 1);
  expect_proved(cos(kAll));
}

TEST(Interval, TheTangentHasPoles) {
  expect_bounds(tan(Interval{-1.5, 1.5}), std::tan(-1.5), std::tan(1.5));
  expect_proved(tan(Interval{-1.5, 1.5}));
  expect_pole(tan(Interval{1.5, 1.6}));
  expect_pole(tan(Interval{-1.6, -1.5}));
  expect_pole(tan(Interval{1e15, 1e15}));
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
  EXPECT_EQ(pow({0, 0}, {-0.5, -0.5}).defined, Defined::No);
  EXPECT_EQ(pow({0, 0}, {-1, -1}).defined, Defined::No);
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

TEST(Interval, AnglesJumpAtTheNegativeAxis) {
  expect_bounds(atan2({1, 2}, {-1, 1}), std::atan2(1, 1), std::atan2(1, -1));
  expect_bounds(atan2({-2, -1}, {-1, 1}), std::atan2(-1, -1), std::atan2(-1, 1));
  expect_bounds(atan2({-1, 1}, {1, 2}), -kPi / 4, kPi / 4);
  expect_bounds(atan2({1, 2}, {-3, -1}), std::atan2(2, -1), std::atan2(1, -3));
  for (const Interval& y : {Interval{-1, 1}, Interval{0, 1}, Interval{-1, 0}}) {
    const Interval r = atan2(y, {-2, -1});
    EXPECT_FALSE(r.continuous);
    expect_bounds(r, -kPi, kPi);
  }
  const Interval origin = atan2({0, 0}, {0, 0});
  EXPECT_EQ(origin.defined, Defined::Yes);
  EXPECT_FALSE(origin.continuous);
  EXPECT_TRUE(contains(origin, 0));
}

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
