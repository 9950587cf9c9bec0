#include "formula/graph.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "graph_value.h"

namespace saddle {
namespace {

TEST(Graph, SharesEqualExpressions) {
  Graph graph;
  EXPECT_EQ(testing::parse(graph, "sin(u)*cos(v)+1"), testing::parse(graph, "1+cos(v)*sin(u)"));
}

TEST(Graph, FoldsConstants) {
  Graph graph;
  EXPECT_TRUE(graph.is_constant(testing::parse(graph, "2*sin(1)^2+max(1,2)")));
}

TEST(Graph, DropsWhatDoesNothing) {
  Graph graph;
  const NodeId u = graph.variable(kSymbolU);
  for (const char* text : {"u+0", "0+u", "u-0", "u*1", "1*u", "u/1", "u^1", "-(-u)", "1?u:v"}) {
    EXPECT_EQ(testing::parse(graph, text), u) << text;
  }
}

TEST(Graph, KeepsWhatIsUndefinedUndefined) {
  EXPECT_TRUE(std::isnan(testing::value("0*ln(u)", -1)));
  EXPECT_TRUE(std::isnan(testing::value("u/u", 0)));
  EXPECT_TRUE(std::isnan(testing::value("1/u-1/u", 0)));
  EXPECT_TRUE(std::isnan(testing::value("min(u,sqrt(u))", -1)));
  EXPECT_TRUE(std::isnan(testing::value("max(sqrt(u),u)", -1)));
  EXPECT_TRUE(std::isnan(testing::value("sign(sqrt(u))", -1)));
}

TEST(Graph, KnowsWhatANodeDependsOn) {
  Graph graph;
  EXPECT_EQ(graph[testing::parse(graph, "sin(u)+2")].depends, kDependsU);
  EXPECT_EQ(graph[testing::parse(graph, "u*v")].depends, kDependsU | kDependsV);
  EXPECT_EQ(graph[testing::parse(graph, "2+3")].depends, kDependsNone);
}

TEST(Graph, SubstitutesAllVariablesAtOnce) {
  Graph graph;
  const NodeId u = graph.variable(kSymbolU);
  const NodeId v = graph.variable(kSymbolV);
  const NodeId difference = graph.make(Op::Sub, u, v);
  const NodeId swapped =
      substitute(graph, std::array{difference}, {{kSymbolU, v}, {kSymbolV, u}})[0];
  EXPECT_EQ(swapped, graph.make(Op::Sub, v, u));
}

TEST(Graph, DividesByPowersOfTwoExactly) {
  Graph graph;
  const NodeId half = testing::parse(graph, "u/2");
  EXPECT_EQ(graph[half].op, Op::Mul);
  EXPECT_EQ(graph[testing::parse(graph, "u/3")].op, Op::Div);
  constexpr double kDenormal = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(testing::value(graph, half, 3 * kDenormal, 0), 3 * kDenormal / 2);
  // The reciprocal of 2^-1030 is infinite.
  EXPECT_EQ(testing::value("u/2^(-1030)", 3 * kDenormal), 3 * kDenormal / 0x1p-1030);
}

}  // namespace
}  // namespace saddle
