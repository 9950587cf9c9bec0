#include "eval/enclose.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "formula/derive.h"
#include "interval_checks.h"

namespace saddle {
namespace {

using namespace testing;

TEST(Enclosure, ADomainIsProvedUpToItsEdge) {
  expect_proved(enclosure("sqrt(1-u^2)", {0.5, 1}));
  expect_proved(enclosure("sqrt(1-u^2)", {-1, -0.9375}));
  expect_exact(enclosure("sqrt(1-u^2)", {1, 1}), 0, 0);
  EXPECT_EQ(enclosure("sqrt(1-u^2)", {1.125, 2}).defined, Defined::No);
}

TEST(Enclosure, KnowsThatAChoiceOfNanMayBeUndefined) {
  for (const char* formula : {"(hypot(u,v)<0.01)?nan:0.2*u*v", "if(hypot(u,v)<0.01,0/0,u)",
                              "u^2+v^2>=1e-4?u:nan", "(u^2+v^2<1e-4)?sqrt(-1-u^2):1"}) {
    EXPECT_EQ(enclosure(formula, {-1, 1}, {-1, 1}).defined, Defined::Maybe) << formula;
    EXPECT_EQ(enclosure(formula, {0.001, 0.005}, {0, 0.005}).defined, Defined::No) << formula;
    EXPECT_EQ(enclosure(formula, {0.5, 1}, {-1, 1}).defined, Defined::Yes) << formula;
  }
}

TEST(Enclosure, CountsTheOperationsThatBreakABox) {
  const auto breaks = [](const char* formula, const Interval& u, const Interval& v) {
    Graph graph;
    const Tape tape = compile(graph, std::vector{parse(graph, formula)});
    return Enclosure(tape).count_breaks(u, v);
  };
  const char* const two = "floor(u)+sqrt(floor(v))+ln(u+3)";
  EXPECT_EQ(breaks(two, {0.25, 0.5}, {0.25, 0.5}), 0U);
  EXPECT_EQ(breaks(two, {0.5, 1.5}, {0.25, 0.5}), 1U);
  EXPECT_EQ(breaks(two, {0.5, 1.5}, {1.5, 2.5}), 2U);       // not the root, whose argument jumps
  EXPECT_EQ(breaks(two, {-3.75, -3.25}, {0.25, 0.5}), 1U);  // a logarithm of less than 0
}

TEST(Enclosure, KnowsThatASignDoesNotJumpBesideAPowerThatIs0WithIt) {
  for (const char* formula : {"sign(u)*abs(u)^0.3", "abs(u)^3*sign(u)", "sign(u-v)*sqrt(abs(u-v))",
                              "sign(u)*u^2+v", "2*(sign(sin(u))*abs(sin(u))^0.7)*cos(v)"})
    EXPECT_TRUE(enclosure(formula, {-1, 1}, {-1, 1}).continuous) << formula;
  for (const char* formula :
       {"sign(u)*abs(v)^0.3", "sign(u)*(abs(u)+1)", "sign(u)*abs(u+v)^3", "sign(u)*abs(u)^0",
        "sign(u)*abs(u)^max(v-10,0)", "sign(u)*abs(u)^v", "sign(u)*abs(floor(u))",
        "sign(u)*sign(u)+u", "sign(sin(u))*abs(cos(u))"})
    EXPECT_FALSE(enclosure(formula, {-1, 1}, {-1, 1}).continuous) << formula;
}

TEST(Enclosure, TellsBreaksAlongLinesFromThoseOfBothParameters) {
  Graph graph;
  const Tape tape = compile(graph, std::vector{parse(graph, "floor(u)*ceil(v)+sqrt(u-v)")});
  Enclosure enclosure(tape);
  const Interval around_1(0.75, 1.25);
  const Interval below(0.25, 0.5);
  EXPECT_EQ(enclosure.count_breaks_of_both(around_1, below), 0U);
  EXPECT_EQ(enclosure.count_breaks_of_both(around_1, around_1), 1U);  // the root
  EXPECT_EQ(enclosure.count_breaks(around_1, around_1), 3U);
  EXPECT_EQ(enclosure.count_breaks_of_one(0, around_1), 1U);
  EXPECT_EQ(enclosure.count_breaks_of_one(0, below), 0U);
  EXPECT_EQ(enclosure.count_breaks_of_one(1, around_1), 1U);
  // What was computed of u alone is not taken for another range.
  EXPECT_EQ(enclosure.count_breaks_of_both({1.5, 1.75}, below), 0U);
}

TEST(Enclosure, BoundsASineAndACosineThatATapeComputesTogether) {
  expect_proved(enclosure("sin(u*v)+2*cos(u*v)", {0, 1}, {1, 1}));
  const Interval sum = enclosure("sin(u*v)+2*cos(u*v)", {0, 0.25}, {1, 1});
  EXPECT_LE(sum.low, 2);
  EXPECT_GE(sum.high, std::sin(0.25) + 2 * std::cos(0.25));
  EXPECT_LE(sum.high, std::sin(0.25) + 2.01);
  EXPECT_GE(sum.low, 2 * std::cos(0.25) - 0.01);
}

TEST(Enclosure, ClearsContinuousAtEveryJumpAndPole) {
  for (const char* formula : {"floor(u)",
                              "ceil(u)",
                              "trunc(2*u)",
                              "round(u+0.5)",
                              "rint(u+0.5)",
                              "sign(u-1)",
                              "u<1",
                              "u<=1",
                              "u>1",
                              "u>=1",
                              "u==1",
                              "u!=1",
                              "u<1&&v<1",
                              "u<1||v>1",
                              "u<1?2:3",
                              "mod(u,1)",
                              "mod(v,u-1)",
                              "1/(u-1)",
                              "1/(u-1)^2",
                              "(u-1)^(-3)",
                              "(u-1)^(v-2)",
                              "tan(u*pi/2)",
                              "atan2(u-1,-1-v)",
                              "atan2(u-1,v-v)",
                              "gamma(1-u)",
                              "lgamma(1-u)",
                              "if(u<1,u,v)",
                              "step(1,u)",
                              "diff(abs(u-1),u)",
                              "diff(gamma(1-u),u)",
                              "cot(u-1)",
                              "exp(1/(1-u))"}) {
    const Interval r = enclosure(formula, {0.875, 1.0625}, {0.25, 0.5});
    EXPECT_FALSE(r.continuous) << formula;
  }
}

TEST(Enclosure, ProvesSmoothFormulas) {
  for (const char* formula :
       {"u^3-v", "sin(u)/u", "sinc(v-u)", "abs(u-1)", "max(u,v)", "tan(u)", "u^v", "(u-1)^2",
        "hypot(u-1,v-0.3)", "atan2(u,v)", "u<2?u:v", "mod(u,3)", "floor(u/2)", "besselj0(u)",
        "gamma(u)", "u>0?1/u:0", "cbrt(u-1)", "diff(u^v,v)", "diff(gamma(u),u)"}) {
    const Interval r = enclosure(formula, {0.875, 1.0625}, {0.25, 0.5});
    EXPECT_EQ(r.defined, Defined::Yes) << formula;
    EXPECT_TRUE(r.continuous) << formula;
  }
}

TEST(Enclosure, ServesManyBoxesAndAllRates) {
  Graph graph;
  const std::array roots = {testing::parse(graph, "u"),   testing::parse(graph, "v"),
                            testing::parse(graph, "2"),   testing::parse(graph, "u*v+sin(0*u)"),
                            testing::parse(graph, "u+1"), testing::parse(graph, "v+1")};
  Enclosure enclosure(compile(graph, roots));
  std::array<Interval, 6> r;
  enclosure({7, 8}, {9, 10}, r);
  enclosure({1, 2}, {3, 4}, r);
  expect_exact(r[0], 1, 2);
  expect_exact(r[1], 3, 4);
  expect_exact(r[2], 2, 2);
  expect_exact(r[3], 3, 8);
  expect_exact(r[4], 2, 3);
  expect_exact(r[5], 4, 5);
}

TEST(Enclosure, IsThatOfTheBoxHoweverManyRangesCameBefore) {
  Graph graph;
  const std::array roots = {testing::parse(graph, "exp(u)*v^3-sin(v)*u"),
                            testing::parse(graph, "cos(u)"), testing::parse(graph, "sqrt(v)")};
  const Tape tape = compile(graph, roots);
  Enclosure enclosure(tape);
  const auto range = [](int k) { return Interval{k / 64.0, (k + 1) / 64.0}; };
  // More of u than are kept, and each again a little later, with another v.
  for (int k = 0; k < 6000; ++k) {
    const Interval u = range(k % 7 < 5 ? k : k - 4);
    const Interval v = range(k % 3);
    std::array<Interval, 3> kept;
    std::array<Interval, 3> fresh;
    enclosure(u, v, kept);
    enclose(tape, u, v, fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      ASSERT_EQ(kept[i].low, fresh[i].low) << k;
      ASSERT_EQ(kept[i].high, fresh[i].high) << k;
    }
  }
}

TEST(Enclosure, TellsRangesApartThatShareAnEnd) {
  Graph graph;
  const std::array roots = {testing::parse(graph, "exp(u)+v"), testing::parse(graph, "exp(v)*u")};
  const Tape tape = compile(graph, roots);
  Enclosure enclosure(tape);
  const auto expect_fresh = [&](const Interval& u, const Interval& v) {
    std::array<Interval, 2> kept;
    std::array<Interval, 2> fresh;
    enclosure(u, v, kept);
    enclose(tape, u, v, fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i)
      expect_exact(kept[i], fresh[i].low, fresh[i].high);
  };
  // As many as are kept share each place, one after the other and turn about.
  for (int k = 1; k < 3000; ++k) {
    const double x = k / 1024.0;
    expect_fresh({0, x}, {-x, 3});
    if (k % 3 == 0) expect_fresh({-x, 3}, {0, x});
  }
}

TEST(Enclosure, TellsItsStepsAndSkipsThoseOfOtherOutputs) {
  Graph graph;
  const std::array roots = {testing::parse(graph, "u+v"), testing::parse(graph, "u*v"),
                            testing::parse(graph, "erf(u)+gamma(v)+erf(u*v)"),
                            testing::parse(graph, "u-3*v")};
  const Tape tape = compile(graph, roots);
  const std::size_t sum = Enclosure(tape, 1).steps();
  EXPECT_EQ(sum, 1U);
  EXPECT_EQ(Enclosure(tape, 2).steps(), 2U);
  const std::size_t with_special = Enclosure(tape, 3).steps();
  EXPECT_EQ(with_special, 2 + 3 * 30 + 2) << "each of the three like 30 sums";
  EXPECT_EQ(Enclosure(tape).steps(), with_special + 2);
}

TEST(Enclosure, OfTheFirstOutputsAloneIsTheSame) {
  Graph graph;
  const std::array roots = {testing::parse(graph, "sin(u)+cos(u)*v"), testing::parse(graph, "u"),
                            testing::parse(graph, "exp(u*v)/gamma(v)"),
                            testing::parse(graph, "sin(u)^3*v")};
  const Tape tape = compile(graph, roots);
  std::array<Interval, 4> all;
  Enclosure whole(tape);
  whole({0.5, 0.75}, {2, 2.25}, all);
  for (const std::size_t count : {1, 2, 3}) {
    std::vector<Interval> first(count);
    Enclosure part(tape, count);
    part({0.1, 0.2}, {1, 3}, first);  // what that leaves behind does no harm
    part({0.5, 0.75}, {2, 2.25}, first);
    for (std::size_t k = 0; k < count; ++k) expect_exact(first[k], all[k].low, all[k].high);
  }
}

TEST(Enclosure, ByTheMeanValueIsNarrowerWhereAVariableOccursOften) {
  Graph graph;
  const NodeId f = testing::parse(graph, "u*u-u*v+v*v+u");
  const std::array roots = {f, derive(graph, std::array{f}, kSymbolU)[0],
                            derive(graph, std::array{f}, kSymbolV)[0]};
  Enclosure enclosure(compile(graph, roots));
  std::array<Interval, 3> r;
  std::array<Interval, 3> middle;
  enclosure({1, 1.125}, {1, 1.125}, r);
  enclosure({1.0625, 1.0625}, {1.0625, 1.0625}, middle);
  const Interval offset = {-0.0625, 0.0625};
  const Interval narrow = mean_value(r[0], middle[0], r[1], offset, r[2], offset);
  EXPECT_LT(narrow.high - narrow.low, (r[0].high - r[0].low) / 2);
  for (const double u : {1.0, 1.05, 1.125}) {
    for (const double v : {1.0, 1.1, 1.125})
      EXPECT_TRUE(contains(narrow, u * u - u * v + v * v + u));
  }
  EXPECT_EQ(mean_value({0, 1, Defined::Yes, false}, {0, 0}, {0, 0}, offset, {0, 0}, offset).high,
            1);
}

TEST(Enclosure, ByTheMeanValueTakesEachSlopeTimesItsOwnOffset) {
  const Interval from_u = mean_value({-99, 99}, {1, 1}, {2, 2}, {-0.25, 0.5}, {0, 0}, {0, 0});
  expect_exact(from_u, 0.5, 2);
  const Interval from_v = mean_value({-99, 99}, {1, 1}, {0, 0}, {0, 0}, {2, 2}, {-0.25, 0.5});
  expect_exact(from_v, 0.5, 2);
}

}  // namespace
}  // namespace saddle
