// A formula as a graph of shared, immutable operations: equal sub-expressions are one node.
// Nodes live in an arena; a node's arguments always have smaller ids than the node itself, so
// every pass over a graph is a loop in ascending order and none needs recursion.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace saddle {

/// Every operation a node can be. The rows of formula/ops.def, after the two kinds of leaves and
/// two operations that only enclosures have: eval/differences.h.
enum class Op : std::uint8_t {
  Constant,
  Variable,
  Hull,    ///< all values between two
  Narrow,  ///< a difference, its value by the mean value theorem, and the function in between
#define SADDLE_OP(id, ...) id,
#include "formula/ops.def"
#undef SADDLE_OP
};

/// Number of arguments of an operation, 0 to 3.
inline int arity(Op op) {
  static constexpr std::array<std::uint8_t, 256> kArities = {
      0, 0,  // the leaves
      2, 3,  // Hull and Narrow
#define SADDLE_OP(id, name, arity, ...) arity,
#include "formula/ops.def"
  };
  return kArities[static_cast<std::size_t>(op)];
}

/// The operation of the table applied to numbers; the arguments past its arity are ignored.
double apply(Op op, double a, double b = 0, double c = 0);

using NodeId = std::uint32_t;
/// Variables are numbered; the first three are the parameters of the surface and time.
using Symbol = std::uint32_t;
inline constexpr Symbol kSymbolU = 0;
inline constexpr Symbol kSymbolV = 1;
inline constexpr Symbol kSymbolT = 2;
inline constexpr Symbol kFirstFreeSymbol = 3;

/// Which variables a node depends on, as bits. All symbols past t share one bit.
enum Depends : std::uint8_t {
  kDependsNone = 0,
  kDependsU = 1,
  kDependsV = 2,
  kDependsT = 4,
  kDependsOther = 8,
};

struct Node {
  Op op = Op::Constant;
  std::uint8_t depends = kDependsNone;
  std::array<NodeId, 3> args = {0, 0, 0};  ///< unused ones are 0
  double value = 0;                        ///< Constant: the number
  Symbol symbol = 0;                       ///< Variable: which one
};

class Graph {
 public:
  NodeId constant(double value);
  NodeId variable(Symbol symbol);
  /// A symbol that nothing else uses: an argument of a helper function, a parameter.
  Symbol new_symbol() { return next_symbol_++; }

  /// The node `op(a, b, c)`: an equal one that exists, a constant where all arguments are constant,
  /// or a simpler node that has the same value for every argument, infinities and NaN included
  /// (only the sign of a zero may differ). So x+0, x-0, x*1, x/1, x^1 become x, and -(-x) too;
  /// x-x, x/x, 0*x stay, because they are undefined where x is.
  NodeId make(Op op, NodeId a, NodeId b = 0, NodeId c = 0);

  const Node& operator[](NodeId id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  bool is_constant(NodeId id) const { return nodes_[id].op == Op::Constant; }
  bool is_constant(NodeId id, double value) const {
    return nodes_[id].op == Op::Constant && nodes_[id].value == value;
  }

 private:
  struct NodeHash {
    std::size_t operator()(const Node& node) const;
  };
  struct NodeEqual {
    bool operator()(const Node& a, const Node& b) const;
  };
  NodeId intern(const Node& node);
  bool is_negated(NodeId id) const;
  NodeId negated(NodeId id) const { return nodes_[id].args[0]; }  // of a Neg: what it negates
  std::optional<NodeId> simplified(Op op, NodeId a, NodeId b);
  std::optional<NodeId> simplified_sum(NodeId a, NodeId b);
  std::optional<NodeId> simplified_product(NodeId a, NodeId b);
  std::optional<NodeId> simplified_quotient(NodeId a, NodeId b);

  std::vector<Node> nodes_;
  std::unordered_map<Node, NodeId, NodeHash, NodeEqual> ids_;
  Symbol next_symbol_ = kFirstFreeSymbol;
};

/// Marks, for every id up to the largest root, whether a root needs it.
std::vector<bool> reachable(const Graph& graph, std::span<const NodeId> roots);

/// The roots with every variable of `replacements` replaced by a node, all at once.
std::vector<NodeId> substitute(Graph& graph, std::span<const NodeId> roots,
                               const std::unordered_map<Symbol, NodeId>& replacements);

}  // namespace saddle
