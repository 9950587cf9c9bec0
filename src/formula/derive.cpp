#include "formula/derive.h"

#include <array>
#include <limits>

#include "formula/operations.h"
#include "formula/tangent.h"

namespace saddle {
namespace {

constexpr double kLn2 = 0.693147180559945309417232;
constexpr double kLn10 = 2.302585092994045684017991;
constexpr double kTwoOverSqrtPi = 1.128379167095512573896159;

/// Leaves are finite.
Infinite infinite(Op op) {
  return has_row(op) ? row_of(op).infinite : Infinite::Never;
}

/// Whether an operation exceeds the largest of doubles at common arguments. cosh and sinh do so
/// beyond 710 only, and every surface divided by them would pay for the guard.
bool outgrows_doubles(const Graph& graph, const Node& node) {
  if (node.op == Op::Pow) return !graph.is_constant(node.args[1]);
  return infinite(node.op) == Infinite::Overflows;
}

/// Whether an operation may be infinite where its arguments are not, though it does not outgrow
/// doubles: at a pole.
bool has_poles(const Graph& graph, const Node& node) {
  switch (node.op) {
    case Op::Div:
      return !graph.is_constant(node.args[1]);
    case Op::Pow:
      return graph.is_constant(node.args[1]) && graph[node.args[1]].value < 0;
    default:
      return infinite(node.op) == Infinite::AtPoles;
  }
}

/// Whether the value of a node may be infinite where the parameters are not.
bool may_be_infinite(const Expression& of) {
  const Graph& graph = *of.graph;
  const std::vector<bool> is_part = reachable(graph, std::array{of.id});
  for (NodeId id = 0; id < is_part.size(); ++id) {
    if (is_part[id] && (outgrows_doubles(graph, graph[id]) || has_poles(graph, graph[id])))
      return true;
  }
  return false;
}

/// Whether the value of a node may be infinite because doubles end, and for no other reason: at the
/// pole of exp(u)/v its reciprocal goes through 0 with a slope. Exponents do not matter: exp(1/u)
/// has outgrown doubles before.
bool only_outgrows_doubles(const Expression& of) {
  const Graph& graph = *of.graph;
  std::vector<bool> is_part(of.id + 1, false);
  is_part[of.id] = true;
  bool outgrows = false;
  for (NodeId id = of.id + 1; id-- > 0;) {
    if (!is_part[id]) continue;
    const Node& node = graph[id];
    if (outgrows_doubles(graph, node)) {
      outgrows = true;
      continue;
    }
    if (has_poles(graph, node)) return false;
    for (int k = 0; k < arity(node.op); ++k) is_part[node.args[static_cast<std::size_t>(k)]] = true;
  }
  return outgrows;
}

/// `t`, but 0 by structure where `of` is infinite.
Tangent unless_infinite(Expression of, Tangent t) {
  return select(abs(of) > std::numeric_limits<double>::max(), Tangent{}, t);
}

/// The same where doubles end. Bounded values do not change any more there: 1/(1+exp(1000*u)) is 0
/// from where exp overflows, and its derivative not inf*0.
Tangent unless_beyond_doubles(Expression of, Tangent t) {
  return t.slope && only_outgrows_doubles(of) ? unless_infinite(of, t) : t;
}

/// The same at poles, too: what settles as fast as tanh has no slope left there.
Tangent unless_settled(Expression of, Tangent t) {
  return t.slope && may_be_infinite(of) ? unless_infinite(of, t) : t;
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
      case Op::Hull:
      case Op::Narrow:
        break;
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, function, kind, infinite, \
                  numbers, derivative)                                                            \
  case Op::id:                                                                                    \
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
