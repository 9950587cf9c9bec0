// How much rounding alone may move a formula's value: running error analysis.
// Source: N. Higham, "Accuracy and stability of numerical algorithms", 2002, 3.3.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "formula/graph.h"

namespace saddle::testing {

/// First-order bounds on the errors of a graph's nodes. An operation adds its row's `ulps` of its
/// result to what it makes of the errors of its arguments, by its partial derivatives. The bound is
/// as large as the formula is ill-conditioned as it is written, and no larger but by the signs of
/// the single errors, which it takes to conspire.
class RoundingBound {
 public:
  /// `graph` as it is evaluated, powers lowered. `constant_ulps`: the error of constants that are
  /// no small fractions, 0 if the constants are what is meant.
  RoundingBound(const Graph& graph, std::span<const NodeId> roots, double constant_ulps);

  /// The bounds, by node. `values`: the nodes' values, by node.
  std::vector<double> operator()(std::span<const double> values) const;

 private:
  /// An operation's derivatives by its arguments, as a graph of the variables 0, 1, 2.
  struct Partials {
    Graph graph;
    std::array<NodeId, 3> slopes = {0, 0, 0};
  };
  static Partials partials_of(Op op);
  double propagated(const Node& node, std::span<const double> values,
                    std::span<const double> bounds) const;

  const Graph& graph_;
  std::vector<bool> needed_;
  std::map<Op, Partials> partials_;
  double constant_ulps_;
};

}  // namespace saddle::testing
