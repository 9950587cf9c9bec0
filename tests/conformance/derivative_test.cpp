// The derivative rule of every operation by every argument, as a tape of doubles, against the same
// rule in 50 digits, at nasty arguments. tests/property/derivative_test.cpp compares the rules with
// differences; here their arithmetic is at stake.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "conformance/reference.h"
#include "conformance/report.h"
#include "conformance/rounding.h"
#include "eval/batch.h"
#include "formula/derive.h"
#include "formula/lower.h"

namespace saddle::testing {
namespace {

/// The bound is of first order; where an error is a large part of its number, as 1 - tanh(a) for a
/// large a, products of errors come on top.
constexpr double kHigherOrders = 1.5;

/// Of the last argument of a choice, which the tape has no variable for.
constexpr double kThirdArgument = 0.75;

/// The slope of a row by one of its arguments, as it is evaluated.
struct Slope {
  Graph graph;
  NodeId root = 0;
};

Slope slope_of(const Row& row, double order, Symbol by) {
  Graph graph;
  const NodeId u = graph.variable(kSymbolU);
  const NodeId v = graph.variable(kSymbolV);
  const NodeId first = takes_an_order(row.op) ? graph.constant(order) : u;
  const NodeId value = graph.make(row.op, first, v, graph.constant(kThirdArgument));
  std::vector<NodeId> roots = derive(graph, std::array{value}, by);
  Graph lowered = lower(graph, roots);
  return {std::move(lowered), roots[0]};
}

std::vector<double> tape_values(const Slope& slope, const std::vector<Arguments>& arguments) {
  std::vector<double> u;
  std::vector<double> v;
  for (const Arguments& at : arguments) {
    u.push_back(at.a);
    v.push_back(at.b);
  }
  std::vector<double> values(u.size());
  const std::array<double*, 1> outputs = {values.data()};
  evaluate_points(compile(slope.graph, std::array{slope.root}), u, v, outputs, 1);
  return values;
}

/// The truth about every node as doubles; empty where one is no number or overflows as a double:
/// what a rule makes of an overflow is not promised.
std::vector<double> node_values(const Slope& slope, const std::vector<bool>& needed,
                                const std::vector<Real>& exact) {
  std::vector<double> values;
  for (NodeId id = 0; id < exact.size(); ++id) {
    values.push_back(static_cast<double>(exact[id]));
    if (!needed[id]) continue;
    const auto [a, b, c] = slope.graph[id].args;
    const Op op = slope.graph[id].op;
    const bool overflow =
        arity(op) > 0 && may_overflow(op, {values[a], values[b], values[c]}, exact[id]);
    if (overflow || !std::isfinite(values.back())) return {};
  }
  return values;
}

/// How many arguments were compared.
int compare(const Row& row, double order, Symbol by) {
  const Slope slope = slope_of(row, order, by);
  if (slope.graph.is_constant(slope.root)) return 1;
  std::vector<Arguments> arguments;
  for (const Arguments& at : arguments_of(row)) {
    if (!takes_an_order(row.op) || at.a == order) arguments.push_back(at);
  }
  const std::vector<double> computed = tape_values(slope, arguments);
  const std::array roots = {slope.root};
  const std::vector<bool> needed = reachable(slope.graph, roots);
  const RoundingBound bound(slope.graph, roots, 0);
  Worst worst;
  int compared = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto variable = [&](Symbol s) -> Real {
      return s == kSymbolU ? arguments[i].a : arguments[i].b;
    };
    const std::vector<Real> exact = exact_values(slope.graph, roots, variable);
    const std::vector<double> values = node_values(slope, needed, exact);
    if (values.empty()) continue;
    const double limit = kHigherOrders * bound(values)[slope.root];
    if (!std::isfinite(limit)) continue;
    const double error = static_cast<double>(abs(computed[i] - exact[slope.root]));
    worst.take(limit > 0 ? error / limit : error, arguments[i], computed[i]);
    EXPECT_LE(error, limit) << row.id << " by argument " << by << " at " << arguments[i].a << ", "
                            << arguments[i].b << ": " << computed[i] << " is not "
                            << exact[slope.root];
    ++compared;
  }
  show("derivative", std::string(row.id) + "/" + std::to_string(by), 1, worst);
  return compared;
}

TEST(Conformance, EveryDerivativeIsWithinTheRoundingOfItsRule) {
  constexpr int kLeastCompared = 40;
  for (const Row& row : kRows) {
    const Symbol first = takes_an_order(row.op) ? 1 : 0;
    const Symbol last = static_cast<Symbol>(std::min(row.arity, 2));
    for (Symbol by = first; by < last; ++by) {
      for (const double order : {0.0, 3.0}) {
        if (order > 0 && !takes_an_order(row.op)) continue;
        const int compared = compare(row, order, by);
        EXPECT_TRUE(compared == 1 || compared >= kLeastCompared) << row.id << " by " << by;
      }
    }
  }
}

}  // namespace
}  // namespace saddle::testing
