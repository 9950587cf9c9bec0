// Values of graphs with 50 digits where "undefined" is taken strictly: whatever needs a value that
// is no real number is undefined itself, comparisons and choices aside.
#pragma once

#include <array>
#include <cmath>
#include <exception>
#include <span>
#include <vector>

#include "study/high_precision.h"

namespace saddle::testing {

struct StrictValue {
  /// Unknown: too large for 50 digits, or the reference has no value.
  enum Kind { Number, Undefined, Unknown } kind = Undefined;
  Real value = 0;

  bool is_number() const { return kind == Number; }
};

inline bool is_whole(const Real& x) {
  return boost::multiprecision::floor(x) == x;
}

/// Whether numbers a, b are in the domain of an operation.
inline bool in_domain(Op op, const Real& a, const Real& b) {
  switch (op) {
    case Op::Div:
    case Op::Mod:
      return b != 0;
    case Op::Sqrt:
      return a >= 0;
    case Op::Log:
    case Op::Log2:
    case Op::Log10:
      return a > 0;
    case Op::Asin:
    case Op::Acos:
      return abs(a) <= 1;
    case Op::Acosh:
      return a >= 1;
    case Op::Atanh:
      return abs(a) < 1;
    case Op::Pow:
      return a > 0 || (a == 0 ? b >= 0 : is_whole(b));
    case Op::Gamma:
    case Op::Lgamma:
      return a > 0 || !is_whole(a);
    case Op::Polygamma:
      return b > 0 || !is_whole(b);
    default:
      return true;
  }
}

/// Whether NaN as an argument still gives a number.
inline bool is_decision(Op op) {
  return op == Op::Less || op == Op::LessEqual || op == Op::Greater || op == Op::GreaterEqual ||
         op == Op::Equal || op == Op::NotEqual || op == Op::And || op == Op::Or;
}

inline StrictValue decide(Op op, const StrictValue& a, const StrictValue& b) {
  const auto truth_of = [](const StrictValue& x) { return !x.is_number() || x.value != 0; };
  const bool numbers = a.is_number() && b.is_number();
  if (op == Op::And) return {StrictValue::Number, Real(truth_of(a) && truth_of(b))};
  if (op == Op::Or) return {StrictValue::Number, Real(truth_of(a) || truth_of(b))};
  if (!numbers) return {StrictValue::Number, Real(op == Op::NotEqual)};
  return {StrictValue::Number, apply_exactly(op, a.value, b.value, 0)};
}

inline StrictValue apply_strictly(Op op, const StrictValue& a, const StrictValue& b,
                                  const StrictValue& c) {
  const std::array<const StrictValue*, 3> args = {&a, &b, &c};
  if (op == Op::Select) {
    if (a.kind == StrictValue::Unknown) return a;
    return !a.is_number() || a.value != 0 ? b : c;
  }
  for (int i = 0; i < arity(op); ++i) {
    if (args[i]->kind == StrictValue::Unknown) return *args[i];
  }
  if (is_decision(op)) return decide(op, a, b);
  for (int i = 0; i < arity(op); ++i) {
    if (!args[i]->is_number()) return {StrictValue::Undefined};
  }
  if (!in_domain(op, a.value, b.value)) return {StrictValue::Undefined};
  if (op == Op::Atan2 && a.value == 0 && b.value == 0) return {StrictValue::Number, 0};
  try {
    const Real result = apply_exactly(op, a.value, b.value, c.value);
    const bool finite = boost::multiprecision::isfinite(result);
    return {finite ? StrictValue::Number : StrictValue::Unknown, result};
  } catch (const std::exception&) {
    return {StrictValue::Unknown};
  }
}

/// The values of all nodes up to the largest root, at (u, v).
inline std::vector<StrictValue> strict_values(const Graph& graph, std::span<const NodeId> roots,
                                              double u, double v) {
  const std::vector<bool> needed = reachable(graph, roots);
  std::vector<StrictValue> result(needed.size());
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    const Node& node = graph[id];
    const auto [a, b, c] = node.args;
    if (node.op == Op::Variable) {
      result[id] = {StrictValue::Number, node.symbol == kSymbolU ? u : v};
    } else if (node.op != Op::Constant) {
      result[id] = apply_strictly(node.op, result[a], result[b], result[c]);
    } else if (!std::isnan(node.value)) {
      result[id] = {std::isinf(node.value) ? StrictValue::Unknown : StrictValue::Number,
                    node.value};
    }
  }
  return result;
}

}  // namespace saddle::testing
