// What a shader is handed, and what it computes.
#include "formula/hoist.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "graph_value.h"

namespace saddle {
namespace {

constexpr double kT = 0.7;

/// Formulas in u, v and t, with the number that each node without u and v is at kT.
struct Formulas {
  Graph graph;
  std::vector<NodeId> roots;
  std::size_t asked = 0;  // for numbers of so many nodes

  explicit Formulas(const std::vector<std::string>& texts) {
    Scope scope(graph, {});
    for (const std::string& text : texts) roots.push_back(scope.parse("z", text));
  }

  /// At (u, v), with the value of each symbol.
  double value(NodeId root, double u, double v,
               const std::unordered_map<Symbol, double>& symbols) const {
    std::vector<double> numbers(static_cast<std::size_t>(root) + 1);
    for (NodeId id = 0; id <= root; ++id) {
      const Node& node = graph[id];
      if (node.op == Op::Constant) {
        numbers[id] = node.value;
      } else if (node.op == Op::Variable) {
        const auto known = symbols.find(node.symbol);
        numbers[id] = node.symbol == kSymbolU   ? u
                      : node.symbol == kSymbolV ? v
                      : known == symbols.end()  ? NAN
                                                : known->second;
      } else {
        numbers[id] =
            apply(node.op, numbers[node.args[0]], numbers[node.args[1]], numbers[node.args[2]]);
      }
    }
    return numbers[root];
  }

  Hoisted take_out() {
    return hoist(graph, roots, [this](std::span<const NodeId> nodes) {
      asked = nodes.size();
      std::vector<double> numbers;
      for (const NodeId node : nodes) numbers.push_back(value(node, NAN, NAN, {{kSymbolT, kT}}));
      return numbers;
    });
  }

  /// Of what is left, with the numbers that are handed over.
  double value_left(const Hoisted& hoisted, std::size_t root, double u, double v) const {
    std::unordered_map<Symbol, double> symbols;
    for (std::size_t k = 0; k < hoisted.symbols.size(); ++k) {
      symbols[hoisted.symbols[k]] = hoisted.values[k];
    }
    return value(hoisted.roots[root], u, v, symbols);
  }
};

TEST(Hoist, LeavesTheSameValues) {
  Formulas formulas({"u*exp(sin(t)+2)+v^t", "cos(t)*sin(u+t^2)/(1+t)", "t", "7", "u"});
  const Hoisted hoisted = formulas.take_out();
  ASSERT_EQ(hoisted.roots.size(), 5U);
  ASSERT_EQ(hoisted.values.size(), hoisted.symbols.size());
  for (const double u : {-1.5, 0.25, 2.0}) {
    for (std::size_t k = 0; k < formulas.roots.size(); ++k) {
      const double wanted = formulas.value(formulas.roots[k], u, 1.3, {{kSymbolT, kT}});
      EXPECT_EQ(formulas.value_left(hoisted, k, u, 1.3), wanted) << k;
    }
  }
}

TEST(Hoist, TakesTheLargestPartsOnceEach) {
  Formulas formulas({"u*exp(sin(t)+2)", "v*exp(sin(t)+2)"});
  const Hoisted hoisted = formulas.take_out();
  ASSERT_EQ(hoisted.values.size(), 1U);
  EXPECT_EQ(hoisted.values[0], std::exp(std::sin(kT) + 2));
}

TEST(Hoist, LeavesNoTimeInTheProgram) {
  Formulas formulas({"t*u+sin(t*v)", "t^2"});
  const Hoisted hoisted = formulas.take_out();
  const std::vector<bool> needed = reachable(formulas.graph, hoisted.roots);
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    const Node& node = formulas.graph[id];
    EXPECT_FALSE(node.op == Op::Variable && node.symbol == kSymbolT);
  }
}

TEST(Hoist, LeavesConstantsOfFormulasWhereTheyAre) {
  Formulas formulas({"3*u+sin(2)*v"});
  const Hoisted hoisted = formulas.take_out();
  EXPECT_TRUE(hoisted.values.empty());
  EXPECT_EQ(formulas.asked, 0U);
  EXPECT_EQ(hoisted.roots, formulas.roots);
}

TEST(Hoist, KeepsExponentsThatAreWhole) {
  Formulas whole({"u^(t/0.7*3)"});  // 3 at this moment
  EXPECT_TRUE(whole.take_out().values.empty());
  Formulas other({"u^t"});
  EXPECT_EQ(other.take_out().values, std::vector<double>{kT});
}

}  // namespace
}  // namespace saddle
