#include "formula/derive.h"

#include <limits>
#include <span>

#include "formula/tangent.h"

namespace saddle {
namespace {

constexpr double kLn2 = 0.693147180559945309417232;
constexpr double kLn10 = 2.302585092994045684017991;
constexpr double kTwoOverSqrtPi = 1.128379167095512573896159;

/// Whether an operation exceeds the largest of doubles at arguments that people give it. Of cosh
/// and sinh, beyond 710, nobody does, and surfaces that are divided by them would all pay for it.
bool outgrows_doubles(const Graph& graph, const Node& node) {
  switch (node.op) {
    case Op::Exp:
    case Op::Gamma:
      return true;
    case Op::Pow:
      return !graph.is_constant(node.args[1]);
    default:
      return false;
  }
}

/// Whether the value of a node may be too large for a double at arguments that are not.
bool may_outgrow_doubles(const Expression& of) {
  const std::vector<bool> parts = reachable(*of.graph, std::span(&of.id, 1));
  for (NodeId id = 0; id < parts.size(); ++id) {
    if (parts[id] && outgrows_doubles(*of.graph, (*of.graph)[id])) return true;
  }
  return false;
}

/// `t`, but 0 by structure where `of` is infinite. What is bounded then does not change any more in
/// doubles: 1/(1+exp(1000*u)) is 0 from where exp overflows, and its derivative not inf*0.
Tangent unless_infinite(Expression of, Tangent t) {
  if (!t.slope || !may_outgrow_doubles(of)) return t;
  return select(abs(of) > std::numeric_limits<double>::max(), Tangent{}, t);
}

/// The chain rule for one node: its arguments, their tangents and the node itself.
struct ChainRule {
  Expression a, b, c;
  Tangent da, db, dc;
  Expression r;

  Tangent operator()(Op op) const {
    const Tangent zero;
    switch (op) {
      case Op::Constant:
      case Op::Variable:
        break;
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, interval, glsl, derivative) \
  case Op::id:                                                                            \
    return derivative;
#include "formula/ops.def"
    }
    return zero;
  }
};

}  // namespace

std::vector<NodeId> derive(Graph& graph, std::span<const NodeId> roots, Symbol symbol) {
  const std::vector<bool> needed = reachable(graph, roots);
  const std::uint8_t bit = graph[graph.variable(symbol)].depends;
  std::vector<Tangent> tangents(needed.size());
  const auto expression = [&graph](NodeId id) { return Expression{&graph, id}; };
  for (NodeId id = 0; id < needed.size(); ++id) {
    const Node node = graph[id];  // a copy: the rules grow the arena
    if (!needed[id] || (node.depends & bit) == 0) continue;
    if (node.op == Op::Variable) {
      if (node.symbol == symbol) tangents[id].slope = expression(graph.constant(1));
      continue;
    }
    const auto [a, b, c] = node.args;
    const auto tangent = [&](int i) {
      return i < arity(node.op) ? tangents[node.args[i]] : Tangent{};
    };
    const ChainRule rule = {expression(a), expression(b), expression(c), tangent(0),
                            tangent(1),    tangent(2),    expression(id)};
    tangents[id] = rule(node.op);
  }
  std::vector<NodeId> derivatives;
  for (const NodeId root : roots) {
    const Tangent& tangent = tangents[root];
    derivatives.push_back(tangent.slope ? tangent.slope->id : graph.constant(0));
  }
  return derivatives;
}

}  // namespace saddle
