// The derivative rule of every operation by every argument, as a tape of doubles, against the same
// rule in 50 digits, at nasty arguments. tests/property/derivative_test.cpp compares the rules with
// differences; here their arithmetic is at stake, in two ways: the evaluator's is held to what
// rounding may do to the rule as it is written, and the rule's to the conditioning of the
// derivative itself, so that a rule that cancels where the derivative is tame is found.
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

/// Last places that a rule may lose beyond what a rounding of the arguments does to the derivative:
/// rules are up to four operations of up to two or three each.
constexpr double kRuleUlps = 12;

/// Rules that lose more by intent: 1 - tanh(a)^2 is exact beside 1 only, as a square of cosh would
/// cost as much as tanh itself; a^(b-1) multiplies the rounding of b-1 by ln(a), as a^b/a would be
/// undefined at 0; and mod's is floor(a/b), which jumps where a/b rounds to a whole number.
bool loses_more_by_intent(Op op) {
  return op == Op::Tanh || op == Op::Pow || op == Op::Mod;
}

/// Of the last argument of a choice, which the tape has no variable for.
constexpr double kThirdArgument = 0.75;

/// The slope of a row by one of its arguments, as it is evaluated, and its own derivatives by u, v.
struct Slope {
  Graph graph;
  NodeId root = 0;
  Graph second_graph;
  std::vector<NodeId> second;
};

Slope slope_of(const Operation& row, double order, Symbol by) {
  Graph graph;
  const NodeId u = graph.variable(kSymbolU);
  const NodeId v = graph.variable(kSymbolV);
  const NodeId first = takes_an_order(row.op) ? graph.constant(order) : u;
  const NodeId value = graph.make(row.op, first, v, graph.constant(kThirdArgument));
  std::vector<NodeId> roots = derive(graph, std::array{value}, by);
  std::vector<NodeId> second = derive(graph, roots, kSymbolU);
  second.push_back(derive(graph, roots, kSymbolV)[0]);
  Graph lowered = lower(graph, roots);
  return {std::move(lowered), roots[0], std::move(graph), second};
}

double last_place(double x) {
  return std::nextafter(std::fabs(x), HUGE_VAL) - std::fabs(x);
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

/// What the derivative's own conditioning excuses; infinite where it has no second derivatives.
/// Their part is left out for an error that is excused without it.
double condition_limit(const Slope& slope, const Arguments& at, const Real& exact, double error) {
  const double least = kRuleUlps * last_place(static_cast<double>(exact));
  if (error <= least) return least;
  const auto variable = [&](Symbol s) -> Real { return s == kSymbolU ? at.a : at.b; };
  const std::vector<Real> values = exact_values(slope.second_graph, slope.second, variable);
  Real limit = last_place(static_cast<double>(exact));
  limit += abs(values[slope.second[0]]) * last_place(at.a);
  limit += abs(values[slope.second[1]]) * last_place(at.b);
  return isfinite(limit) ? kRuleUlps * static_cast<double>(limit) : HUGE_VAL;
}

/// How many arguments were compared.
int compare(const Operation& row, double order, Symbol by) {
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
    double limit = kHigherOrders * bound(values)[slope.root];
    if (!std::isfinite(limit)) continue;
    const double error = static_cast<double>(abs(computed[i] - exact[slope.root]));
    if (!loses_more_by_intent(row.op)) {
      limit = std::fmin(limit, condition_limit(slope, arguments[i], exact[slope.root], error));
    }
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
  for (const Operation& row : kOperations) {
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
