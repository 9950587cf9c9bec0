#include "formula/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formula/value.h"

namespace saddle {

NodeId Parameters::define(NodeId constant, std::optional<Symbol> kept) {
  const Symbol symbol = kept.value_or(graph_.new_symbol());
  constants_[symbol] = constant;
  return graph_.variable(symbol);
}

double Parameters::value_of_variable(Symbol symbol, double t) const {
  if (symbol == kSymbolT) return t;
  const auto parameter = constants_.find(symbol);
  return parameter == constants_.end() ? std::numeric_limits<double>::quiet_NaN()
                                       : graph_[parameter->second].value;
}

double Parameters::evaluate(NodeId root, std::optional<double> t) {
  if (t && *t != t_) values_.clear();
  t_ = t.value_or(t_);
  for (NodeId id = static_cast<NodeId>(values_.size()); id <= root; ++id) {
    const Node& node = graph_[id];
    const auto& [a, b, c] = node.args;
    values_.push_back(node.op == Op::Constant ? node.value
                      : node.op == Op::Variable
                          ? value_of_variable(node.symbol, t_)
                          : apply(node.op, values_[a], values_[b], values_[c]));
  }
  return values_[root];
}

std::optional<double> Parameters::known_value(NodeId node) {
  if (graph_.is_constant(node)) return graph_[node].value;
  if (graph_[node].depends != kDependsOther) return std::nullopt;
  const double value = evaluate(node);  // arguments of functions have none
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::vector<std::vector<double>> Parameters::sample(std::span<const NodeId> roots,
                                                    const std::array<SampledRange, 3>& box) {
  constexpr std::size_t kMaxCurves = 100;
  std::vector<NodeId> key(roots.begin(), roots.end());
  if (const auto known = samples_.find(key); known != samples_.end()) return known->second;
  if (samples_.size() == kMaxCurves) {
    throw TypeFault{"tubes round more than 100 curves", "use fewer"};
  }
  constexpr std::size_t kSamples = 1000;
  // Long formulas get fewer: a tenth of a second for all samples.
  constexpr std::size_t kMaxEvaluations = 10'000'000;
  // Multiples of the powers of 1/g, g^4 = g + 1, fill a box evenly: M. Roberts, 2018.
  constexpr std::array kSteps = {0.81917251339616438, 0.67104360670378919, 0.54970047790197022};
  const std::vector<bool> is_needed = reachable(graph_, roots);
  std::vector<NodeId> needed;
  for (NodeId id = 0; id < is_needed.size(); ++id) {
    if (is_needed[id]) needed.push_back(id);
  }
  std::vector<double> at(is_needed.size());
  const auto value = [&](NodeId id, std::size_t k) {
    const Node& node = graph_[id];
    const auto& [a, b, c] = node.args;
    if (node.op == Op::Constant) return node.value;
    if (node.op != Op::Variable) return apply(node.op, at[a], at[b], at[c]);
    if (constants_.contains(node.symbol)) return value_of_variable(node.symbol, 0);
    const std::size_t which = std::min<std::size_t>(node.symbol, 2);
    const double part = static_cast<double>(k) * kSteps[which];
    return box[which].min + (part - std::floor(part)) * (box[which].max - box[which].min);
  };
  std::vector<std::vector<double>> result(std::min(kSamples, kMaxEvaluations / needed.size()));
  for (std::size_t k = 0; k < result.size(); ++k) {
    for (const NodeId id : needed) at[id] = value(id, k);
    for (const NodeId root : roots) result[k].push_back(at[root]);
  }
  return samples_[std::move(key)] = std::move(result);
}

}  // namespace saddle
