#include "eval/tape.h"

#include <cmath>
#include <limits>

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

/// The part of the graph that the roots need, with powers lowered.
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

Rate rate_of(const Node& node) {
  const bool u = (node.depends & kDependsU) != 0;
  const bool v = (node.depends & kDependsV) != 0;
  if (u && v) return Rate::Both;
  if (u) return Rate::U;
  return v ? Rate::V : Rate::Constant;
}

/// Gives every value a slot; those of bank Both go back once nobody needs them any more.
class Allocator {
 public:
  Allocator(const Graph& graph, const std::vector<bool>& needed, std::span<const NodeId> roots)
      : graph_(graph), slots_(needed.size()), last_use_(needed.size(), 0) {
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id]) continue;
      for (int i = 0; i < arity(graph[id].op); ++i) last_use_[graph[id].args[i]] = id;
    }
    for (const NodeId root : roots) last_use_[root] = std::numeric_limits<NodeId>::max();
  }

  void place_leaf(NodeId id, Tape& tape) {
    const Node& node = graph_[id];
    slots_[id].rate = rate_of(node);
    if (node.op == Op::Constant) {
      slots_[id].index = static_cast<std::uint32_t>(tape.constants.size());
      tape.constants.push_back(node.value);
    }  // u and v are slot 0 of their banks
  }

  Instruction place(NodeId id, Tape& tape) {
    const Node& node = graph_[id];
    Instruction instruction;
    instruction.op = node.op;
    for (int i = 0; i < arity(node.op); ++i) instruction.in[i] = slots_[node.args[i]];
    for (int i = 0; i < arity(node.op); ++i) release(node.args[i], id);
    instruction.out = slots_[id] = {rate_of(node), take(rate_of(node), tape)};
    return instruction;
  }

  Slot slot(NodeId id) const { return slots_[id]; }

 private:
  std::uint32_t take(Rate rate, Tape& tape) {
    if (rate == Rate::U) return tape.slots_u++;
    if (rate == Rate::V) return tape.slots_v++;
    if (free_.empty()) return tape.slots_both++;
    const std::uint32_t index = free_.back();
    free_.pop_back();
    return index;
  }

  void release(NodeId argument, NodeId user) {
    if (slots_[argument].rate != Rate::Both || last_use_[argument] != user) return;
    last_use_[argument] = 0;  // once, even if the user takes it twice
    free_.push_back(slots_[argument].index);
  }

  const Graph& graph_;
  std::vector<Slot> slots_;
  std::vector<NodeId> last_use_;
  std::vector<std::uint32_t> free_;
};

}  // namespace

Tape compile(const Graph& graph, std::span<const NodeId> outputs, Powers powers) {
  std::vector<NodeId> roots(outputs.begin(), outputs.end());
  const Graph lowered = lower(graph, roots, powers);
  const std::vector<bool> needed = reachable(lowered, roots);
  Tape tape;
  Allocator allocator(lowered, needed, roots);
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    if (arity(lowered[id].op) == 0) {
      allocator.place_leaf(id, tape);
      continue;
    }
    const Instruction instruction = allocator.place(id, tape);
    switch (instruction.out.rate) {
      case Rate::Constant:
        break;  // constants have been folded
      case Rate::U:
        tape.of_u.push_back(instruction);
        break;
      case Rate::V:
        tape.of_v.push_back(instruction);
        break;
      case Rate::Both:
        tape.of_both.push_back(instruction);
        break;
    }
  }
  for (const NodeId root : roots) tape.outputs.push_back(allocator.slot(root));
  return tape;
}

}  // namespace saddle
