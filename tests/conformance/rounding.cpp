#include "conformance/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conformance/reference.h"
#include "formula/derive.h"

namespace saddle::testing {
namespace {

double last_place(double x) {
  const double size = std::fabs(x);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

/// Sixteenths and whole numbers are meant as they are.
bool is_small_fraction(double x) {
  return 16 * x == std::round(16 * x);
}

/// The values of a small graph, by the plainest means.
std::vector<double> values_of(const Graph& graph, const std::array<double, 3>& variables) {
  std::vector<double> values(graph.size());
  for (NodeId id = 0; id < graph.size(); ++id) {
    const Node& node = graph[id];
    const auto [a, b, c] = node.args;
    values[id] = node.op == Op::Constant   ? node.value
                 : node.op == Op::Variable ? variables[node.symbol]
                                           : apply(node.op, values[a], values[b], values[c]);
  }
  return values;
}

double ulps_of(Op op) {
  for (const Operation& row : kOperations) {
    if (row.op == op) return row.ulps;
  }
  return 0;
}

}  // namespace

RoundingBound::RoundingBound(const Graph& graph, std::span<const NodeId> roots,
                             double constant_ulps)
    : graph_(graph), needed_(reachable(graph, roots)), constant_ulps_(constant_ulps) {
  for (NodeId id = 0; id < needed_.size(); ++id) {
    const Op op = graph[id].op;
    if (needed_[id] && arity(op) > 0 && !partials_.contains(op)) partials_[op] = partials_of(op);
  }
}

RoundingBound::Partials RoundingBound::partials_of(Op op) {
  Partials result;
  Graph& graph = result.graph;
  std::array<NodeId, 3> args{};
  for (Symbol i = 0; i < 3; ++i) args[i] = graph.variable(i);
  const NodeId root = graph.make(op, args[0], args[1], args[2]);
  const Symbol first = takes_an_order(op) ? 1 : 0;  // the order is exact
  for (Symbol i = 0; i < 3; ++i) {
    result.slopes[i] = i < first ? graph.constant(0) : derive(graph, std::array{root}, i)[0];
  }
  return result;
}

double RoundingBound::propagated(const Node& node, std::span<const double> values,
                                 std::span<const double> bounds) const {
  const auto bound = [&](int i) { return i < arity(node.op) ? bounds[node.args[i]] : 0.0; };
  if (bound(0) == 0 && bound(1) == 0 && bound(2) == 0) return 0;
  const auto [a, b, c] = node.args;
  // Products and quotients by hand: often, and their slopes may underflow where this does not.
  if (node.op == Op::Mul) return std::fabs(values[b]) * bound(0) + std::fabs(values[a]) * bound(1);
  if (node.op == Op::Div) {
    return (bound(0) + std::fabs(values[a] / values[b]) * bound(1)) / std::fabs(values[b]);
  }
  const Partials& partials = partials_.at(node.op);
  const std::vector<double> slopes = values_of(partials.graph, {values[a], values[b], values[c]});
  // Steps have no slope, but a jump between the ends of what the argument may be.
  if (arity(node.op) == 1 && partials.graph.is_constant(partials.slopes[0], 0)) {
    const double reach = bound(0) + last_place(values[a]);  // the value is rounded, too
    return apply(node.op, values[a] + reach) - apply(node.op, values[a] - reach);
  }
  double sum = 0;
  for (int i = 0; i < arity(node.op); ++i) {
    if (bound(i) != 0) sum += std::fabs(slopes[partials.slopes[i]]) * bound(i);
  }
  return sum;
}

std::vector<double> RoundingBound::operator()(std::span<const double> values) const {
  std::vector<double> bounds(needed_.size(), 0.0);
  for (NodeId id = 0; id < needed_.size(); ++id) {
    if (!needed_[id]) continue;
    const Node& node = graph_[id];
    const double value = values[id];
    if (node.op == Op::Constant) {
      bounds[id] = is_small_fraction(value) ? 0 : constant_ulps_ * last_place(value);
    }
    if (arity(node.op) == 0) continue;
    const Arguments at{values[node.args[0]], values[node.args[1]], values[node.args[2]]};
    const double scale = static_cast<double>(scale_of(node.op, at, value));
    // An underflow is off by the smallest denormal at most.
    const double own = std::max(ulps_of(node.op) * last_place(scale), last_place(0));
    bounds[id] = own + propagated(node, values, bounds);
  }
  return bounds;
}

}  // namespace saddle::testing
