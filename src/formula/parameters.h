// Definitions that are constants, and what nodes are worth that depend on them.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "formula/graph.h"

namespace saddle {

/// The range of a variable, or of what stands for one.
struct SampledRange {
  double min = 0;
  double max = 0;
};

class Parameters {
 public:
  explicit Parameters(Graph& graph) : graph_(graph) {}

  /// A variable that stands for a constant, so that diff() can differentiate by it. `kept`: its
  /// symbol, if it has one.
  NodeId define(NodeId constant, std::optional<Symbol> kept = std::nullopt);

  /// The constants of the variables.
  const std::unordered_map<Symbol, NodeId>& constants() const { return constants_; }

  /// The value of a root that depends on parameters and t alone. All nodes up to it are computed,
  /// once for each t: a scene's numbers share most of theirs. NaN where it depends on more.
  /// Without a t it is that of the last call.
  double evaluate(NodeId root, std::optional<double> t = std::nullopt);

  /// The value of a node of constants and parameters; nothing for another one, or NaN.
  std::optional<double> known_value(NodeId node);

  /// The values of nodes at 1000 places, of long formulas fewer, of the box of u, v and all other
  /// variables. Throws TypeFault for too many different roots: they are tubes' curves.
  std::vector<std::vector<double>> sample(std::span<const NodeId> roots,
                                          const std::array<SampledRange, 3>& box);

 private:
  double value_of_variable(Symbol symbol, double t) const;

  Graph& graph_;
  std::unordered_map<Symbol, NodeId> constants_;
  std::vector<double> values_;  // of the graph's nodes, at t_
  double t_ = 0;
  std::map<std::vector<NodeId>, std::vector<std::vector<double>>> samples_;  // by their roots
};

}  // namespace saddle
