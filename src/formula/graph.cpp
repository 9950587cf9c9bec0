#include "formula/graph.h"

#include <bit>
#include <cassert>
#include <cmath>

#include "formula/special.h"

namespace saddle {

double apply(Op op, [[maybe_unused]] double a, [[maybe_unused]] double b,
             [[maybe_unused]] double c) {
  switch (op) {
    case Op::Constant:
    case Op::Variable:
    case Op::Hull:
    case Op::Narrow:
      break;
#define SADDLE_OP(id, name, arity, help, value, ...) \
  case Op::id:                                       \
    return value;
#include "formula/ops.def"
  }
  assert(false && "leaves are not applied");
  return 0;
}

std::size_t Graph::NodeHash::operator()(const Node& node) const {
  std::uint64_t hash = static_cast<std::uint64_t>(node.op);
  const auto mix = [&hash](std::uint64_t word) {
    // Multiplication by an odd constant (2^64 / golden ratio) spreads the bits upward.
    hash = (std::rotl(hash, 23) ^ word) * 0x9e3779b97f4a7c15U;
  };
  mix(node.args[0]);
  mix(node.args[1]);
  mix(node.args[2]);
  mix(std::bit_cast<std::uint64_t>(node.value));
  mix(node.symbol);
  return hash ^ (hash >> 32);
}

bool Graph::NodeEqual::operator()(const Node& a, const Node& b) const {
  // Bits, not values: NaN equals itself, 0 and -0 differ.
  return a.op == b.op && a.args == b.args && a.symbol == b.symbol &&
         std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

NodeId Graph::intern(const Node& node) {
  const auto [place, is_new] = ids_.try_emplace(node, static_cast<NodeId>(nodes_.size()));
  if (is_new) nodes_.push_back(node);
  return place->second;
}

NodeId Graph::constant(double value) {
  Node node;
  node.value = value;
  return intern(node);
}

NodeId Graph::variable(Symbol symbol) {
  Node node;
  node.op = Op::Variable;
  node.symbol = symbol;
  node.depends = symbol < kFirstFreeSymbol ? static_cast<std::uint8_t>(1U << symbol)
                                           : static_cast<std::uint8_t>(kDependsOther);
  return intern(node);
}

NodeId Graph::make(Op op, NodeId a, NodeId b, NodeId c) {
  const int count = arity(op);
  std::array<NodeId, 3> args = {a, count > 1 ? b : 0, count > 2 ? c : 0};
  bool all_constant = true;
  std::uint8_t depends = kDependsNone;
  for (int i = 0; i < count; ++i) {
    all_constant = all_constant && is_constant(args[i]);
    depends |= nodes_[args[i]].depends;
  }
  if (all_constant) {
    return constant(apply(op, nodes_[args[0]].value, nodes_[args[1]].value, nodes_[args[2]].value));
  }
  if (op == Op::Select) {
    if (is_constant(a)) return nodes_[a].value != 0 ? b : c;
    if (b == c) return b;
  }
  if (count <= 2) {
    if (const std::optional<NodeId> simpler = simplified(op, args[0], args[1])) return *simpler;
  }
  // a+b and b+a, a*b and b*a are equal to the bit: one order serves both.
  if ((op == Op::Add || op == Op::Mul) && args[0] > args[1]) std::swap(args[0], args[1]);
  Node node;
  node.op = op;
  node.depends = depends;
  node.args = args;
  return intern(node);
}

namespace {

/// 1/value if dividing by `value` and multiplying by that are the same, to the bit: powers of two.
double exact_reciprocal(double value) {
  int exponent = 0;
  const bool power_of_two = std::fabs(std::frexp(value, &exponent)) == 0.5;
  const bool in_range = std::isnormal(value) && std::isnormal(1 / value);
  return power_of_two && in_range ? 1 / value : 0;
}

}  // namespace

bool Graph::is_negated(NodeId id) const {
  return nodes_[id].op == Op::Neg;
}

/// An existing or simpler node equal to op(a, b), or nothing if there is no rule for it.
std::optional<NodeId> Graph::simplified(Op op, NodeId a, NodeId b) {
  switch (op) {
    case Op::Neg:
      if (is_negated(a)) return negated(a);
      return std::nullopt;
    case Op::Add:
      return simplified_sum(a, b);
    case Op::Sub:
      if (is_constant(b, 0)) return a;
      if (is_constant(a, 0)) return make(Op::Neg, b);
      if (is_negated(b)) return make(Op::Add, a, negated(b));
      return std::nullopt;
    case Op::Mul:
      return simplified_product(a, b);
    case Op::Div:
      return simplified_quotient(a, b);
    case Op::Pow:
      if (is_constant(b, 1)) return a;
      // pow(a, 0) and pow(1, b) are 1 whatever the other is, NaN included (IEEE 754-2019, 9.2).
      if (is_constant(b, 0) || is_constant(a, 1)) return constant(1);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

std::optional<NodeId> Graph::simplified_sum(NodeId a, NodeId b) {
  if (is_constant(a, 0)) return b;
  if (is_constant(b, 0)) return a;
  if (is_negated(b)) return make(Op::Sub, a, negated(b));
  if (is_negated(a)) return make(Op::Sub, b, negated(a));
  if (a == b) return make(Op::Mul, constant(2), a);
  return std::nullopt;
}

std::optional<NodeId> Graph::simplified_product(NodeId a, NodeId b) {
  if (is_constant(a)) std::swap(a, b);
  if (is_constant(b, 1)) return a;
  if (is_constant(b, -1)) return make(Op::Neg, a);
  if (is_negated(a)) return make(Op::Neg, make(Op::Mul, negated(a), b));
  if (is_negated(b)) return make(Op::Neg, make(Op::Mul, a, negated(b)));
  return std::nullopt;
}

std::optional<NodeId> Graph::simplified_quotient(NodeId a, NodeId b) {
  if (is_constant(b)) {
    const double reciprocal = exact_reciprocal(nodes_[b].value);
    if (reciprocal != 0) return make(Op::Mul, constant(reciprocal), a);
  }
  if (is_negated(a)) return make(Op::Neg, make(Op::Div, negated(a), b));
  return std::nullopt;
}

std::vector<bool> reachable(const Graph& graph, std::span<const NodeId> roots) {
  NodeId largest = 0;
  for (const NodeId root : roots) largest = std::max(largest, root);
  std::vector<bool> needed(static_cast<std::size_t>(largest) + 1, false);
  for (const NodeId root : roots) needed[root] = true;
  for (NodeId id = largest + 1; id-- > 0;) {
    if (!needed[id]) continue;
    const Node& node = graph[id];
    for (int i = 0; i < arity(node.op); ++i) needed[node.args[i]] = true;
  }
  return needed;
}

std::vector<NodeId> substitute(Graph& graph, std::span<const NodeId> roots,
                               const std::unordered_map<Symbol, NodeId>& replacements) {
  const std::vector<bool> needed = reachable(graph, roots);
  std::vector<NodeId> image(needed.size());
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    const Node node = graph[id];  // a copy: make() may move the arena
    image[id] = id;
    if (node.op == Op::Variable) {
      const auto found = replacements.find(node.symbol);
      if (found != replacements.end()) image[id] = found->second;
    } else if (node.op != Op::Constant) {
      const auto& args = node.args;
      const bool changed =
          image[args[0]] != args[0] || image[args[1]] != args[1] || image[args[2]] != args[2];
      if (changed) image[id] = graph.make(node.op, image[args[0]], image[args[1]], image[args[2]]);
    }
  }
  std::vector<NodeId> result;
  for (const NodeId root : roots) result.push_back(image[root]);
  return result;
}

}  // namespace saddle
