#include "formula/lower.h"

#include <cmath>

namespace saddle {
namespace {

/// Whole exponents up to this size become products: at most 2 log2(n) multiplications, each exact
/// to half an ULP, so at n = 16 the product is off by less than 8 ULP and far cheaper than pow.
constexpr double kMaxProductExponent = 16;

/// base^exponent as squarings and products; shares the squares with other powers of the base.
NodeId product_power(Graph& graph, NodeId base, int exponent) {
  NodeId result = graph.constant(1);
  for (NodeId square = base; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = graph.make(Op::Mul, result, square);
    if (exponent > 1) square = graph.make(Op::Mul, square, square);
  }
  return result;
}

NodeId lower_power(Graph& graph, NodeId base, NodeId exponent, Powers powers) {
  const double n = graph[exponent].value;
  if (!graph.is_constant(exponent)) return graph.make(Op::Pow, base, exponent);
  if (n == 0.5) {
    // pow(-inf, 0.5) is inf and sqrt(-inf) is NaN; no surface is defined at either.
    return graph.make(Op::Sqrt, base);
  }
  if (powers == Powers::Products && n == std::floor(n) && std::fabs(n) <= kMaxProductExponent) {
    const NodeId power = product_power(graph, base, static_cast<int>(std::fabs(n)));
    return n > 0 ? power : graph.make(Op::Div, graph.constant(1), power);
  }
  return graph.make(Op::Pow, base, exponent);
}

}  // namespace

Graph lower(const Graph& graph, std::vector<NodeId>& roots, Powers powers) {
  const std::vector<bool> needed = reachable(graph, roots);
  Graph lowered;
  std::vector<NodeId> image(needed.size(), 0);
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    const Node& node = graph[id];
    const auto [a, b, c] = node.args;
    if (node.op == Op::Constant) {
      image[id] = lowered.constant(node.value);
    } else if (node.op == Op::Variable) {
      image[id] = lowered.variable(node.symbol);
    } else if (node.op == Op::Pow) {
      image[id] = lower_power(lowered, image[a], image[b], powers);
    } else {
      image[id] = lowered.make(node.op, image[a], image[b], image[c]);
    }
  }
  for (NodeId& root : roots) root = image[root];
  return lowered;
}

}  // namespace saddle
