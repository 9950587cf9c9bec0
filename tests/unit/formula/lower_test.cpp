#include "formula/lower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "graph_value.h"

namespace saddle {
namespace {

/// The operations of a formula's form for tapes.
std::vector<Op> lowered(const std::string& text, Powers powers = Powers::Products) {
  Graph graph;
  std::vector<NodeId> roots = {testing::parse(graph, text)};
  const Graph result = lower(graph, roots, powers);
  std::vector<Op> operations;
  for (NodeId id = 0; id <= roots[0]; ++id) operations.push_back(result[id].op);
  return operations;
}

bool has_power(const std::string& text, Powers powers = Powers::Products) {
  return std::ranges::count(lowered(text, powers), Op::Pow) > 0;
}

/// Products of 16 factors are off by less than 8 ULP; longer ones by more.
TEST(Lower, MakesProductsOfPowersUpToSixteen) {
  for (const char* const text : {"u^3", "u^16", "u^(-16)"}) EXPECT_FALSE(has_power(text)) << text;
  for (const char* const text : {"u^17", "u^(-17)", "u^2.5", "u^v"})
    EXPECT_TRUE(has_power(text)) << text;
  EXPECT_TRUE(has_power("u^3", Powers::Whole));
}

TEST(Lower, TakesARootForAHalf) {
  EXPECT_EQ(std::ranges::count(lowered("u^0.5"), Op::Sqrt), 1);
}

}  // namespace
}  // namespace saddle
