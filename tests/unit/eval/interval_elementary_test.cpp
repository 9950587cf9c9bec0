// Elementary functions of intervals: domains, poles, turning points.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "eval/interval.h"
#include "interval_checks.h"

namespace saddle {
namespace {

using namespace testing;

constexpr double kPi = 3.14159265358979323846;

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

}  // namespace
}  // namespace saddle
