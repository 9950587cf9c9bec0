// Values of graphs by the plainest means: node after node, with no program in between.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "formula/graph.h"
#include "formula/scope.h"

namespace saddle::testing {

/// The node of one formula of u and v (and t), with optional definitions.
inline NodeId parse(Graph& graph, const std::string& text,
                    std::vector<Definition> definitions = {}) {
  Scope scope(graph, std::move(definitions));
  const NodeId root = scope.parse("z", text);
  const std::vector<NodeId> roots = {root};
  return substitute(graph, scope.bind(roots, 0), {})[0];
}

/// The values of all nodes up to `root` at (u, v); t is 0.
inline std::vector<double> values(const Graph& graph, NodeId root, double u, double v) {
  std::vector<double> result(static_cast<std::size_t>(root) + 1, 0.0);
  for (NodeId id = 0; id <= root; ++id) {
    const Node& node = graph[id];
    if (node.op == Op::Constant) {
      result[id] = node.value;
    } else if (node.op == Op::Variable) {
      result[id] = node.symbol == kSymbolU ? u : node.symbol == kSymbolV ? v : 0;
    } else {
      result[id] = apply(node.op, result[node.args[0]], result[node.args[1]], result[node.args[2]]);
    }
  }
  return result;
}

inline double value(const Graph& graph, NodeId root, double u, double v) {
  return values(graph, root, u, v)[root];
}

/// The value of a formula at (u, v).
inline double value(const std::string& text, double u = 0, double v = 0) {
  Graph graph;
  const NodeId root = parse(graph, text);
  return value(graph, root, u, v);
}

}  // namespace saddle::testing
