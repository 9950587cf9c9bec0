#include "eval/differences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>

#include "formula/derive.h"

namespace saddle {

namespace {

/// Differences of differences of ... in one another. Surfaces that are thickened twice by hand have
/// 2 in their formulas, and 2 more in their second derivatives.
constexpr int kMostNested = 4;
/// Nodes that may be added: a surface thickened by hand takes 300 to 3,000.
constexpr std::size_t kMostNodes = 20'000;
/// Pairs of nodes that are compared for one difference. Sums and products are compared in both
/// orders, so that formulas which differ in many places would take endless ones.
constexpr std::size_t kMostPairs = 2'000;

/// A node as base + by.
struct Shifted {
  NodeId base;
  double by;
};

bool is_commutative(Op op) {
  return op == Op::Add || op == Op::Mul;
}

/// a - b, if that is exact in doubles.
std::optional<double> exact_difference(double a, double b) {
  const double difference = a - b;
  const bool is_exact = a - difference == b && b + difference == a;
  return is_exact ? std::optional(difference) : std::nullopt;
}

/// A node as the one to which its last operation adds a constant, if it does that.
std::optional<Shifted> without_constant(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  const auto is_constant = [&](std::size_t k) { return graph.is_constant(node.args[k]); };
  if (node.op == Op::Add && is_constant(1)) return Shifted{node.args[0], graph[node.args[1]].value};
  if (node.op == Op::Add && is_constant(0)) return Shifted{node.args[1], graph[node.args[0]].value};
  if (node.op == Op::Sub && is_constant(1))
    return Shifted{node.args[0], -graph[node.args[1]].value};
  return std::nullopt;
}

/// Takes a node apart into a base and the constants that are added to it. Sums of constants are
/// exact, and no smaller than these: u+1e16-1e16 rounds u to whole numbers.
Shifted shifted(const Graph& graph, NodeId id) {
  Shifted result = {id, 0};
  while (const auto inner = without_constant(graph, result.base)) {
    const auto by = exact_difference(inner->by, -result.by);
    if (!by || std::fabs(*by) < std::max(std::fabs(inner->by), std::fabs(result.by))) break;
    result = {inner->base, *by};
  }
  return result;
}

/// An argument of a function at two places: base + first and base + second.
struct Argument {
  NodeId base;
  double first, second;
  double shift;  ///< first - second, exactly
};

/// Compares two formulas, and finds the arguments with which both are one function.
class Comparison {
 public:
  explicit Comparison(const Graph& graph) : graph_(graph) {}

  bool are_alike(NodeId first, NodeId second) {
    const auto known = partners_.find(first);
    if (known != partners_.end()) return known->second == second;
    if (++pairs_ > kMostPairs) return false;
    const auto argument = use_of(first, second);
    if (first != second && !argument && !have_like_parts(first, second)) return false;
    // A part of the function has the same counterpart wherever it stands.
    if (!partners_.try_emplace(first, second).second) return false;
    compared_.push_back(first);
    if (argument) uses_[first] = *argument;
    return true;
  }

  const std::vector<Argument>& arguments() const { return arguments_; }
  /// The number of an argument, and what the function adds to it.
  using Use = std::pair<std::size_t, double>;
  std::optional<Use> use(NodeId part) const {
    const auto found = uses_.find(part);
    return found != uses_.end() ? std::optional(found->second) : std::nullopt;
  }
  /// Whether a part of the first formula differs from its counterpart.
  bool differs(NodeId part) const {
    const auto found = partners_.find(part);
    return found != partners_.end() && found->second != part;
  }

 private:
  /// The use of two different nodes, if each is an argument with a constant added.
  std::optional<Use> use_of(NodeId first, NodeId second) {
    const Shifted a = shifted(graph_, first);
    const Shifted b = shifted(graph_, second);
    if (first == second || a.base != b.base || graph_.is_constant(a.base)) return std::nullopt;
    const auto shift = exact_difference(a.by, b.by);
    if (!shift) return std::nullopt;
    std::size_t k = 0;
    while (k < arguments_.size() && arguments_[k].base != a.base) ++k;
    if (k == arguments_.size()) arguments_.push_back({a.base, a.by, b.by, *shift});
    const auto offset = exact_difference(a.by, arguments_[k].first);
    if (arguments_[k].shift != *shift || !offset) return std::nullopt;
    return Use{k, *offset};
  }

  bool have_like_parts(NodeId first, NodeId second) {
    const Node& a = graph_[first];
    const Node& b = graph_[second];
    if (a.op != b.op || arity(a.op) == 0 || a.op == Op::Hull) return false;
    const std::size_t compared = compared_.size();
    const std::size_t arguments = arguments_.size();
    bool are = true;
    for (std::size_t k = 0; are && k < static_cast<std::size_t>(arity(a.op)); ++k)
      are = are_alike(a.args[k], b.args[k]);
    if (are || !is_commutative(a.op)) return are;
    for (; compared_.size() > compared; compared_.pop_back()) {
      partners_.erase(compared_.back());
      uses_.erase(compared_.back());
    }
    arguments_.resize(arguments);
    return are_alike(a.args[0], b.args[1]) && are_alike(a.args[1], b.args[0]);
  }

  const Graph& graph_;
  std::unordered_map<NodeId, NodeId> partners_;  ///< of parts of the first formula
  std::unordered_map<NodeId, Use> uses_;
  std::vector<NodeId> compared_;  ///< parts of the first formula, in order
  std::vector<Argument> arguments_;
  std::size_t pairs_ = 0;
};

class Narrower {
 public:
  explicit Narrower(Graph& graph) : graph_(graph), most_nodes_(graph.size() + kMostNodes) {}

  std::vector<NodeId> narrow(std::span<const NodeId> roots) {
    const std::vector<bool> needed = reachable(graph_, roots);
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (needed[id] && !images_.contains(id)) images_[id] = image_of(id);
    }
    std::vector<NodeId> result;
    for (const NodeId root : roots) result.push_back(images_[root]);
    return result;
  }

 private:
  NodeId image_of(NodeId id) {
    const Node node = graph_[id];  // a copy: make() may move the arena
    if (arity(node.op) == 0) return id;
    std::array<NodeId, 3> args = {};
    for (std::size_t k = 0; k < static_cast<std::size_t>(arity(node.op)); ++k)
      args[k] = images_[node.args[k]];
    const NodeId image = graph_.make(node.op, args[0], args[1], args[2]);
    if (node.op != Op::Sub || nested_ == kMostNested || graph_.size() > most_nodes_) return image;
    const auto formulas = by_mean_value(node.args[0], node.args[1]);
    if (!formulas) return image;
    ++nested_;
    const std::vector<NodeId> narrowed = narrow(*formulas);
    --nested_;
    return graph_.make(Op::Narrow, image, narrowed[0], narrowed[1]);
  }

  /// The difference by the mean value theorem, and the function between both places.
  std::optional<std::array<NodeId, 2>> by_mean_value(NodeId first, NodeId second) {
    Comparison comparison(graph_);
    if (!comparison.are_alike(first, second) || comparison.arguments().empty()) return std::nullopt;
    const std::vector<Argument>& arguments = comparison.arguments();
    std::vector<Symbol> symbols;
    std::unordered_map<Symbol, NodeId> places;
    std::vector<NodeId> shifts;
    for (const Argument& argument : arguments) {
      symbols.push_back(graph_.new_symbol());
      const auto at = [&](double by) {
        return graph_.make(Op::Add, argument.base, graph_.constant(by));
      };
      const NodeId between = graph_.make(Op::Hull, at(argument.first), at(argument.second));
      places[symbols.back()] = between;
      shifts.push_back(rounded(argument.shift, between));
    }
    const NodeId function = function_of(first, comparison, symbols);
    NodeId difference = graph_.constant(0);
    for (std::size_t k = 0; k < arguments.size(); ++k) {
      const NodeId slope = derive(graph_, std::array{function}, symbols[k])[0];
      difference = graph_.make(Op::Add, difference, graph_.make(Op::Mul, shifts[k], slope));
    }
    const auto result = substitute(graph_, std::array{difference, function}, places);
    return std::array{result[0], result[1]};
  }

  /// A shift in doubles: the arguments, which are `between` two places, are rounded at both.
  NodeId rounded(double shift, NodeId between) {
    constexpr double kRounding = 0x1p-52;  // half of it at each
    const auto error = [&](double sign) {
      return graph_.make(Op::Mul, graph_.constant(sign * kRounding), between);
    };
    return graph_.make(Op::Add, graph_.constant(shift), graph_.make(Op::Hull, error(1), error(-1)));
  }

  /// The formula `first` as a function of its arguments, which are `symbols`.
  NodeId function_of(NodeId first, const Comparison& comparison, std::span<const Symbol> symbols) {
    const std::vector<bool> needed = reachable(graph_, std::array{first});
    std::vector<NodeId> image(needed.size());
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id]) continue;
      const Node node = graph_[id];
      image[id] = id;
      if (const auto use = comparison.use(id)) {
        const auto& [number, offset] = *use;
        image[id] = graph_.make(Op::Add, graph_.variable(symbols[number]), graph_.constant(offset));
      } else if (comparison.differs(id)) {
        image[id] =
            graph_.make(node.op, image[node.args[0]], image[node.args[1]], image[node.args[2]]);
      }
    }
    return image[first];
  }

  Graph& graph_;
  std::size_t most_nodes_;
  int nested_ = 0;
  std::unordered_map<NodeId, NodeId> images_;
};

}  // namespace

std::vector<NodeId> narrow_differences(Graph& graph, std::span<const NodeId> roots) {
  return Narrower(graph).narrow(roots);
}

}  // namespace saddle
