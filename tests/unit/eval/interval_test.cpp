#include "eval/interval.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "interval_checks.h"

namespace saddle {
namespace {

using namespace testing;

constexpr Interval kMaybe = {1, 2, Defined::Maybe, true};

TEST(Interval, SumsAndProductsOfFewBitsAreExact) {
  expect_exact(Interval{1, 2} + Interval{0.25, 3}, 1.25, 5);
  expect_exact(Interval{1, 2} - Interval{1, 2}, -1, 1);
  expect_exact(Interval{-1.5, 2} * Interval{0.25, 3}, -4.5, 6);
  expect_exact(sqr(Interval{-1.5, 1}), 0, 2.25);
}

TEST(Interval, OtherSumsAndProductsAreRoundedOutward) {
  const Interval third = Interval{1, 1} / Interval{3, 3};
  EXPECT_LT(third.low, third.high);
  expect_bounds(third, 1.0 / 3, 1.0 / 3);
  const Interval sum = Interval{0.1, 0.1} + Interval{0.2, 0.2};
  EXPECT_LT(sum.low, sum.high);
  const Interval product = Interval{0.1, 0.1} * Interval{0.1, 0.1};
  EXPECT_LT(product.low, product.high);
}

TEST(Interval, AProductWithZeroIsZeroHoweverLargeTheOther) {
  expect_exact(Interval{0, 0} * kAll, 0, 0);
  expect_exact(Interval{0, 1} * Interval{2, kInfinity}, 0, kInfinity);
  expect_exact(Interval{-1, 0} * Interval{2, kInfinity}, -kInfinity, 0);
}

TEST(Interval, InfiniteBoundsAddUpToInfinity) {
  expect_exact(kAll - kAll, -kInfinity, kInfinity);
  expect_exact(Interval{1, kInfinity} + Interval{-kInfinity, 1}, -kInfinity, kInfinity);
}

TEST(Interval, OverflowLeavesAFiniteBound) {
  const Interval r = exp(Interval{1000, 1001});
  EXPECT_LE(r.low, std::numeric_limits<double>::max());
  EXPECT_GT(r.low, 1e308);
  EXPECT_EQ(r.high, kInfinity);
  expect_proved(r);
}

TEST(Interval, UnderflowKeepsTheSign) {
  const Interval tiny = exp(Interval{-1000, -999});
  EXPECT_EQ(tiny.low, 0);
  EXPECT_GT(tiny.high, 0);
  const Interval product = Interval{1e-200, 1e-200} * Interval{-1e-200, -1e-200};
  EXPECT_LT(product.low, 0);
  EXPECT_EQ(product.high, 0);
  // Ends that are 0 belong to both signs.
  const Interval positive = {0, 1e-200};
  const Interval negative = {-1e-200, 0};
  EXPECT_EQ((negative * negative).low, 0);
  EXPECT_EQ((positive * positive).low, 0);
  EXPECT_EQ((positive * negative).high, 0);
  EXPECT_EQ((negative * positive).high, 0);
  const Interval quotient = Interval{1e-200, 1e-200} / Interval{1e200, 1e200};
  EXPECT_EQ(quotient.low, 0);
  EXPECT_GT(quotient.high, 0);
  const Interval sine = sin(Interval{-1e-310, 1e-310});  // denormal: few digits are left
  EXPECT_LT(sine.low, -1e-310);
  EXPECT_GT(sine.high, 1e-310);
  expect_exact(sin(Interval{0, 0}), 0, 0);
}

/// Ends of boxes whose products and quotients underflow, and ends whose do not.
constexpr std::array<double, 7> kSmallAndLarge = {-1, -1e-200, 0, 1e-200, 1, 1e200, -1e200};

/// Calls `check` with all boxes that have such ends.
template <class Check>
void for_boxes(const Check& check) {
  for (const double low : kSmallAndLarge) {
    for (const double high : kSmallAndLarge) {
      if (low <= high) check(Interval{low, high});
    }
  }
}

TEST(Interval, ProductsAreOnTheSideOfZeroWhereTheirSignsPutThem) {
  for_boxes([](const Interval& a) {
    for_boxes([&](const Interval& b) {
      const Interval r = a * b;
      const bool any_negative = (a.low < 0 && b.high > 0) || (a.high > 0 && b.low < 0);
      const bool any_positive = (a.low < 0 && b.low < 0) || (a.high > 0 && b.high > 0);
      EXPECT_EQ(r.low < 0, any_negative) << a.low << " " << a.high << " " << b.low << " " << b.high;
      EXPECT_EQ(r.high > 0, any_positive)
          << a.low << " " << a.high << " " << b.low << " " << b.high;
    });
  });
}

TEST(Interval, QuotientsAreOnTheSideOfZeroWhereTheirSignsPutThem) {
  for_boxes([](const Interval& a) {
    for_boxes([&](const Interval& b) {
      if (b.low <= 0) return;
      for (const Interval& r : {a / b, -a / -b}) {
        EXPECT_EQ(r.low < 0, a.low < 0) << a.low << " " << a.high << " " << b.low << " " << b.high;
        EXPECT_EQ(r.high > 0, a.high > 0)
            << a.low << " " << a.high << " " << b.low << " " << b.high;
      }
    });
  });
}

TEST(Interval, NothingIsLostJustWhereUnderflowBegins) {
  constexpr double kLeast = 0x1p-960;
  for (const double sign : {-1.0, 1.0}) {
    const double end = sign * kLeast;
    expect_exact(Interval{sign * 0x1p-480, sign * 0x1p-480} * Interval{0x1p-480, 0x1p-480}, end,
                 end);
    expect_exact(Interval{end, end} / Interval{1, 1}, end, end);
  }
}

TEST(Interval, AProductOfAnEndlessBoxIsAsNearToZero) {
  constexpr double kLeast = 0x1p-960;
  expect_exact(Interval{kLeast, kInfinity} * Interval{1, 1}, kLeast, kInfinity);
  expect_exact(Interval{-kInfinity, -kLeast} * Interval{1, 1}, -kInfinity, -kLeast);
}

TEST(Interval, ASquareIsNotNegative) {
  expect_exact(sqr(Interval{0, 0}), 0, 0);
  expect_exact(sqr(Interval{-1, 2}), 0, 4);
  expect_exact(enclosure("u*u", {-1, 2}), 0, 4);
  expect_exact(enclosure("u^2", {-1, 2}), 0, 4);
}

TEST(Interval, DivisionByABoxWithZeroInsideIsUnboundedAndMaybeDefined) {
  const Interval r = Interval{1, 2} / Interval{-1, 1};
  expect_exact(r, -kInfinity, kInfinity);
  expect_pole(r);
}

TEST(Interval, DivisionByABoxThatEndsAtZeroIsBoundedOnOneSide) {
  expect_bounds(Interval{1, 2} / Interval{0, 4}, 0.25, kInfinity);
  expect_bounds(Interval{1, 2} / Interval{-4, 0}, -kInfinity, -0.25);
  expect_bounds(Interval{-2, -1} / Interval{0, 4}, -kInfinity, -0.25);
  expect_exact(Interval{0, 1} / Interval{0, 4}, 0, kInfinity);
  expect_exact(Interval{-1, 0} / Interval{0, 4}, -kInfinity, 0);
  expect_exact(Interval{-1, 1} / Interval{0, 4}, -kInfinity, kInfinity);
  expect_pole(Interval{1, 2} / Interval{0, 4});
}

/// floor(u/3) jumps at u = 6, and nowhere beside it.
TEST(Interval, DivisionIsExactWhereTheQuotientIs) {
  expect_exact(Interval{6, 7.5} / Interval{3, 3}, 2, 2.5);
  expect_exact(mod({6, 6}, {3, 3}), 0, 0);
  expect_proved(mod({6, 6}, {3, 3}));
  constexpr double kQuotient = 0x1p50 + 1;  // of 51 bits; the product with 3 needs 53 at most
  expect_exact(Interval{3 * kQuotient, 3 * kQuotient} / Interval{3, 3}, kQuotient, kQuotient);
  const Interval third = Interval{1, 1} / Interval{3, 3};
  EXPECT_LT(third.low, third.high);
}

TEST(Interval, ZeroDividedIsZeroWhereItIsDefined) {
  for (const Interval& divisor : {Interval{-1, 1}, Interval{0, 4}, Interval{-4, 0}}) {
    expect_exact(Interval{0, 0} / divisor, 0, 0);
    expect_pole(Interval{0, 0} / divisor);
  }
}

TEST(Interval, DivisionByZeroIsInfiniteOrUndefined) {
  // An infinity may come back as a value: smoothstep(0.3, 0.3, u) jumps from 0 to 1.
  expect_pole(Interval{1, 2} / Interval{0, 0});
  expect_exact(min(Interval{1, 2} / Interval{0, 0}, {3, 3}), -kInfinity, 3);
  EXPECT_EQ((Interval{0, 0} / Interval{0, 0}).defined, Defined::No);
}

TEST(Interval, WhatIsUndefinedStaysSo) {
  for (const Interval& r : {kUndefined + kMaybe,
                            kMaybe * kUndefined,
                            -kUndefined,
                            sqr(kUndefined),
                            abs(kUndefined),
                            min(kUndefined, kMaybe),
                            sin(kUndefined),
                            exp(kUndefined),
                            log(kUndefined),
                            tan(kUndefined),
                            floor(kUndefined),
                            mod(kMaybe, kUndefined),
                            hypot(kUndefined, kMaybe),
                            atan2(kMaybe, kUndefined),
                            cosh(kUndefined),
                            gamma(kUndefined),
                            lgamma(kUndefined),
                            bessel_j({0, 0}, kUndefined),
                            polygamma({0, 0}, kUndefined),
                            pow(kUndefined, kMaybe)}) {
    EXPECT_EQ(r.defined, Defined::No);
    EXPECT_GT(r.low, r.high);
  }
}

TEST(Interval, WhatMayBeUndefinedStaysSo) {
  for (const Interval& r : {kMaybe + Interval{1, 1}, kMaybe / Interval{1, 2}, sqrt(kMaybe),
                            max(kMaybe, {1, 1}), pow(kMaybe, {3, 3}), pow({2, 3}, kMaybe)}) {
    EXPECT_EQ(r.defined, Defined::Maybe);
  }
}

TEST(Interval, StepsAreConstantOrJump) {
  using Function = Interval (*)(const Interval&);
  struct Case {
    Function f;
    Interval flat;
    double value;
    Interval across;
  };
  const std::array<Case, 6> cases = {{{floor, {1, 1.5}, 1, {0.5, 1}},
                                      {ceil, {1.5, 2}, 2, {1, 1.5}},
                                      {round, {1.5, 2.25}, 2, {1.25, 1.5}},
                                      {rint, {-0.5, 0.25}, 0, {-0.75, -0.5}},
                                      {trunc, {-0.75, 0.75}, 0, {-1, -0.5}},
                                      {sign, {0.25, 3}, 1, {0, 1}}}};
  for (const Case& c : cases) {
    expect_exact(c.f(c.flat), c.value, c.value);
    expect_proved(c.f(c.flat));
    EXPECT_FALSE(c.f(c.across).continuous);
    EXPECT_EQ(c.f(c.across).high - c.f(c.across).low, 1);
  }
}

TEST(Interval, TheRemainderIsTightWhereTheQuotientStaysWithinAWholeNumber) {
  expect_exact(mod({5.25, 5.5}, {1, 1}), 0.25, 0.5);
  expect_proved(mod({5.25, 5.5}, {1, 1}));
  const Interval across = mod({5.5, 6.5}, {1, 1});
  EXPECT_FALSE(across.continuous);
  EXPECT_NEAR(across.low, 0, kFewUlps);
  EXPECT_NEAR(across.high, 1, kFewUlps);
  expect_pole(mod({1, 2}, {-1, 1}));
  EXPECT_EQ(mod({1, 2}, {0, 0}).defined, Defined::No);
}

TEST(Interval, TheRemainderHoldsWhatTheQuotientsRoundingMakesOfIt) {
  int negative = 0;
  for (int n = 1; n < 1000; ++n) {
    const double a = std::nextafter(0.1 * n, 0);  // a / 0.1 is below n, and often rounds to n
    const double computed = apply(Op::Mod, a, 0.1);
    negative += computed < 0 ? 1 : 0;
    EXPECT_TRUE(contains(mod({a, a}, {0.1, 0.1}), computed)) << n;
    EXPECT_TRUE(contains(mod({a, a + 0.2}, {0.1, 0.1}), computed)) << n;
  }
  EXPECT_GT(negative, 0);
}

TEST(Interval, TheRemainderHoldsWhatUnderflowMakesOfIt) {
  // -1e-400 is -0 in doubles, whose floor leaves all of a.
  const double computed = apply(Op::Mod, -1e-200, 1e200);
  EXPECT_EQ(computed, -1e-200);
  EXPECT_TRUE(contains(mod({-1e-200, -1e-200}, {1e200, 1e200}), computed));
  expect_exact(mod({0, 1e-300}, {1, 1}), 0, 1e-300);
}

TEST(Interval, TheRemainderHasTheSignOfItsDivisor) {
  const Interval across = mod({5.5, 6.5}, {-1, -1});
  EXPECT_NEAR(across.low, -1, kFewUlps);
  EXPECT_NEAR(across.high, 0, kFewUlps);
}

TEST(Interval, ADifferenceIsNarrowedToWhatTheFunctionsRoundingLeaves) {
  expect_exact(narrow({0, 2}, {1, 1}, {0, 0}), 1, 1);
  const Interval r = narrow({-9, 9}, {1, 2}, {-4, 3});
  const double error = 2 * 100 * rounding::kRoundoff * 4;  // of two values of a hundred steps each
  EXPECT_LE(r.low, 1 - error);
  EXPECT_GE(r.low, 1 - 1.01 * error);
  EXPECT_GE(r.high, 2 + error);
  EXPECT_LE(r.high, 2 + 1.01 * error);
}

TEST(Interval, RintHoldsWhatTheRoundingOfTheSumMakesOfIt) {
  const double below_half = std::nextafter(0.5, 0);
  const Interval r = rint({below_half, below_half});
  expect_exact(r, 0, 1);  // 0, but in doubles below_half + 0.5 is 1
  EXPECT_FALSE(r.continuous);
}

TEST(Interval, TheSizeOfABoxOnOneSideOfZeroIsAsWide) {
  expect_exact(abs(Interval{0.5, 2}), 0.5, 2);
  expect_exact(abs(Interval{-2, -0.5}), 0.5, 2);
  expect_exact(abs(Interval{-0.5, 0.25}), 0, 0.5);
  expect_exact(abs(Interval{-0.25, 0.5}), 0, 0.5);
}

TEST(Interval, KinksAreContinuous) {
  expect_exact(abs(Interval{-3, 2}), 0, 3);
  expect_exact(min({-3, 2}, {-1, 1}), -3, 1);
  expect_exact(max({-3, 2}, {-1, 1}), -1, 2);
  expect_proved(abs(Interval{-3, 2}));
  expect_proved(max({-3, 2}, {-1, 1}));
}

TEST(Interval, ComparisonsAreDecidedOrBoth) {
  expect_exact(Interval{0, 1} < Interval{2, 3}, 1, 1);
  expect_exact(Interval{2, 3} < Interval{0, 2}, 0, 0);
  expect_exact(Interval{0, 2} < Interval{2, 3}, 0, 1);
  expect_exact(Interval{0, 2} <= Interval{2, 3}, 1, 1);
  expect_exact(Interval{2, 3} <= Interval{0, 2}, 0, 1);
  expect_exact((Interval{0, 1} == Interval{2, 3}), 0, 0);
  expect_exact((Interval{2, 2} == Interval{2, 2}), 1, 1);
  expect_exact((Interval{1, 2} == Interval{1, 2}), 0, 1);
  expect_exact((Interval{1, 2} != Interval{3, 4}), 1, 1);
  EXPECT_FALSE((Interval{1, 2} != Interval{1, 2}).continuous);
  expect_proved(Interval{0, 1} < Interval{2, 3});
}

TEST(Interval, ComparisonsWithTheUndefinedAreDefinedButOpen) {
  for (const Interval& r : {kUndefined < Interval{1, 2}, kMaybe <= Interval{8, 9},
                            kMaybe == Interval{8, 9}, kUndefined != kUndefined}) {
    expect_exact(r, 0, 1);
    EXPECT_EQ(r.defined, Defined::Yes);
    EXPECT_FALSE(r.continuous);
  }
}

TEST(Interval, LogicIsThreeValued) {
  const Interval open = {0, 1};
  expect_exact(both({2, 3}, {-1, -0.5}), 1, 1);
  expect_exact(both({0, 0}, open), 0, 0);
  expect_exact(both({2, 3}, open), 0, 1);
  expect_exact(either({2, 3}, open), 1, 1);
  expect_exact(either({0, 0}, {0, 0}), 0, 0);
  expect_exact(either({0, 0}, open), 0, 1);
}

TEST(Interval, TheBranchThatIsNotTakenDoesNotMatter) {
  const Interval yes = select({1, 1}, {2, 3}, kUndefined);
  expect_exact(yes, 2, 3);
  expect_proved(yes);
  expect_exact(select({0, 0}, kUndefined, {2, 3}), 2, 3);
  const Interval open = select({0, 1}, {2, 3}, {5, 6});
  expect_exact(open, 2, 6);
  EXPECT_FALSE(open.continuous);
  EXPECT_EQ(select({0, 1}, {2, 3}, kUndefined).defined, Defined::Maybe);
  expect_proved(select({0, 1}, {2, 2}, {2, 2}));
  expect_exact(select(kUndefined, {2, 3}, {5, 6}), 2, 6);  // NaN counts as true, in doubles
}

TEST(Interval, ConstantsMayBeInfiniteOrUndefined) {
  EXPECT_EQ(constant_interval(std::nan("")).defined, Defined::No);
  EXPECT_EQ(constant_interval(kInfinity).defined, Defined::Maybe);
  expect_exact(min({1, 2}, constant_interval(kInfinity)), 1, 2);
}

}  // namespace
}  // namespace saddle
