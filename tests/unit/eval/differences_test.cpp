#include "eval/differences.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "eval/enclose.h"
#include "eval/tape.h"
#include "graph_value.h"

namespace saddle {
namespace {

struct Bounds {
  Interval natural, narrowed;
};

/// The enclosures of a formula over a box, with and without the mean value theorem.
Bounds bounds(const std::string& text, const Interval& u, const Interval& v = {0, 0}) {
  Graph graph;
  const NodeId root = testing::parse(graph, text);
  const NodeId narrowed = narrow_differences(graph, std::array{root})[0];
  const Tape tape = compile(graph, std::vector{root, narrowed}, Powers::Whole);
  std::array<Interval, 2> outputs;
  enclose(tape, u, v, outputs);
  return {outputs[0], outputs[1]};
}

double width(const Interval& a) {
  return a.high - a.low;
}

TEST(Differences, AreAsNarrowAsTheSlope) {
  for (const char* const text :
       {"(sin(u+1e-6)-sin(u))/1e-6", "(sin(u+1e-6)-sin(u-1e-6))/2e-6", "(u-(u-1e-6))/1e-6",
        "(cos(v)*(u+1e-6)^2-u^2*cos(v))/1e-6", "(u*(1+v)-(1+v)*(u-1e-6))/1e-6"}) {
    const Bounds a = bounds(text, {0.5, 0.75}, {0, 0.25});
    EXPECT_GT(width(a.natural), 1e4) << text;
    EXPECT_LT(width(a.narrowed), 1) << text;
    EXPECT_TRUE(a.narrowed.continuous);
    EXPECT_EQ(a.narrowed.defined, Defined::Yes);
  }
}

TEST(Differences, MoveInBothParameters) {
  const Bounds a = bounds("(sin(u+1e-4)*cos(v-1e-4)-sin(u)*cos(v))/1e-4", {0.5, 0.625}, {1, 1.125});
  EXPECT_LT(width(a.narrowed), 1);
  const double slope = std::cos(0.5) * std::cos(1) + std::sin(0.5) * std::sin(1);
  EXPECT_TRUE(contains(a.narrowed, slope));
}

TEST(Differences, OfDifferencesAreNarrowToo) {
  const Bounds a =
      bounds("((sin(u+2e-3)-sin(u+1e-3))/1e-3-(sin(u+1e-3)-sin(u))/1e-3)/1e-3", {0.5, 0.625});
  EXPECT_GT(width(a.natural), 1e4);
  EXPECT_LT(width(a.narrowed), 1);
  EXPECT_TRUE(contains(a.narrowed, -std::sin(0.55)));
}

/// A part that both values share is no function of what is moved.
TEST(Differences, LeaveSharedPartsAsTheyAre) {
  const Bounds a = bounds("((u+1)*sin(u+1)-u*sin(u+1))/1", {0.5, 0.625});
  EXPECT_TRUE(contains(a.narrowed, std::sin(1.5)));
  EXPECT_TRUE(contains(a.narrowed, std::sin(1.625)));
  EXPECT_LT(width(a.narrowed), 0.01);
}

TEST(Differences, SayNothingOfWhatJumpsInBetween) {
  const Bounds a = bounds("(floor(u+1e-3)-floor(u))/1e-3", {0.5, 1.5});
  EXPECT_FALSE(a.narrowed.continuous);
  EXPECT_EQ(a.narrowed.low, a.natural.low);
  EXPECT_EQ(a.narrowed.high, a.natural.high);
  EXPECT_GE(a.narrowed.high, 1000);
}

TEST(Differences, KnowAKinkByTheSlopesBesideIt) {
  const Bounds a = bounds("(abs(u+1e-3)-abs(u))/1e-3", {-0.5, 0.5});
  EXPECT_TRUE(a.narrowed.continuous);
  EXPECT_LE(a.narrowed.high, 1.001);
  EXPECT_GE(a.narrowed.low, -1.001);
  EXPECT_TRUE(contains(a.narrowed, 1) && contains(a.narrowed, -1));
}

TEST(Differences, NeedASlope) {
  const Bounds a = bounds("(sqrt(u+1e-3)-sqrt(u))/1e-3", {0, 0.5});
  EXPECT_EQ(a.narrowed.low, a.natural.low);
  EXPECT_EQ(a.narrowed.high, a.natural.high);
}

TEST(Differences, OfOtherFormulasKeepTheirNodes) {
  for (const char* const text : {"sin(u)-cos(u)", "u^2-v^2", "sin(u)-sin(2*u)", "u+1-v", "u*v"}) {
    Graph graph;
    const NodeId root = testing::parse(graph, text);
    EXPECT_EQ(narrow_differences(graph, std::array{root})[0], root) << text;
  }
}

/// 1e-9-1 has seven digits of 1e-9 left, and u+1e16-1e16 is a whole number.
TEST(Differences, TakeOnlyStepsThatAreExact) {
  const Bounds a = bounds("((u+1e-9)-1-(u-1))/1e-9", {1, 1.000001});
  EXPECT_TRUE(contains(a.narrowed, 1));
  EXPECT_TRUE(contains(a.narrowed, ((1 + 1e-9) - 1) / 1e-9));
  const Bounds b = bounds("((u+1e16)-1e16)-u", {0, 8});
  EXPECT_TRUE(contains(b.narrowed, 1) && contains(b.narrowed, -1));
}

/// u+h is rounded, whatever the size of the function.
TEST(Differences, HoldWhatDoublesGive) {
  constexpr double kStep = 1e-10;
  const Bounds a = bounds("(sin(u+1e-10)-sin(u))/1e-10", {3.14, 3.143});
  EXPECT_LT(width(a.narrowed), 0.1);
  for (int k = 0; k <= 1000; ++k) {
    const double u = 3.14 + 3e-6 * k;
    EXPECT_TRUE(contains(a.narrowed, (std::sin(u + kStep) - std::sin(u)) / kStep)) << u;
  }
}

}  // namespace
}  // namespace saddle
