#include "formula/derive.h"

#include "formula/tangent.h"

namespace saddle {
namespace {

constexpr double kLn2 = 0.693147180559945309417232;
constexpr double kLn10 = 2.302585092994045684017991;
constexpr double kTwoOverSqrtPi = 1.128379167095512573896159;

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
