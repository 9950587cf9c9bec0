#include "formula/hoist.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace saddle {
namespace {

bool varies(const Node& node) {
  return (node.depends & (kDependsU | kDependsV)) != 0;
}

/// Largest parts without u and v: arguments of nodes with them, and roots.
std::vector<NodeId> parts_of(const Graph& graph, std::span<const NodeId> roots) {
  std::vector<NodeId> parts;
  const auto take = [&](NodeId id) {
    if (!varies(graph[id]) && !graph.is_constant(id)) parts.push_back(id);
  };
  const std::vector<bool> needed = reachable(graph, roots);
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id] || !varies(graph[id])) continue;
    for (int k = 0; k < arity(graph[id].op); ++k) take(graph[id].args[static_cast<std::size_t>(k)]);
  }
  for (const NodeId root : roots) take(root);
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return parts;
}

class Hoister {
 public:
  Hoister(Graph& graph, std::span<const NodeId> parts, std::span<const double> values)
      : graph_(graph) {
    for (std::size_t i = 0; i < parts.size(); ++i) values_[parts[i]] = values[i];
  }

  Hoisted run(std::span<const NodeId> roots) {
    const std::vector<bool> needed = reachable(graph_, roots);
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id] || !varies(graph_[id])) continue;
      const Node node = graph_[id];  // a copy: nodes move as the graph grows
      std::array<NodeId, 3> args = {0, 0, 0};
      for (std::size_t k = 0; k < static_cast<std::size_t>(arity(node.op)); ++k) {
        args[k] = replaced(node.args[k], node.op == Op::Pow && k == 1);
      }
      images_[id] = arity(node.op) == 0 ? id : graph_.make(node.op, args[0], args[1], args[2]);
    }
    for (const NodeId root : roots) result_.roots.push_back(replaced(root, false));
    return std::move(result_);
  }

 private:
  NodeId replaced(NodeId id, bool is_exponent) {
    if (const auto image = images_.find(id); image != images_.end()) return image->second;
    const auto value = values_.find(id);
    if (value == values_.end()) return id;
    if (is_exponent && value->second == std::floor(value->second)) {
      return graph_.constant(value->second);
    }
    const auto [known, is_new] = variables_.try_emplace(id, 0);
    if (is_new) {
      result_.symbols.push_back(graph_.new_symbol());
      result_.values.push_back(value->second);
      known->second = graph_.variable(result_.symbols.back());
    }
    return known->second;
  }

  Graph& graph_;
  std::unordered_map<NodeId, double> values_;     // of parts
  std::unordered_map<NodeId, NodeId> variables_;  // for parts
  std::unordered_map<NodeId, NodeId> images_;     // of nodes with u or v
  Hoisted result_;
};

}  // namespace

Hoisted hoist(Graph& graph, std::span<const NodeId> roots,
              const std::function<std::vector<double>(std::span<const NodeId> nodes)>& values) {
  const std::vector<NodeId> parts = parts_of(graph, roots);
  return Hoister(graph, parts, values(parts)).run(roots);
}

}  // namespace saddle
