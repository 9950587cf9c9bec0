// The derivative of an expression while it is being built. Most are zero because the expression
// does not contain the variable at all; such a zero absorbs whatever it is multiplied by, even
// where that is infinite, because it is no limit but the absence of a term.
#pragma once

#include <optional>

#include "formula/expression.h"

namespace saddle {

/// A derivative: nothing for one that is zero by structure.
struct Tangent {
  std::optional<Expression> slope;
};

/// Whether a derivative is 0 by structure for some values of the conditions it is chosen by.
inline bool has_zero_branch(Expression slope) {
  const Node& node = (*slope.graph)[slope.id];
  if (node.op != Op::Select) return slope.graph->is_constant(slope.id, 0);
  return has_zero_branch({slope.graph, node.args[1]}) ||
         has_zero_branch({slope.graph, node.args[2]});
}

/// Products and sums are looked into so deeply.
constexpr int kSupportDepth = 8;

/// Where an expression may be other than 0, as a condition, if it is 0 by structure around places
/// elsewhere: max(0, u)*v where u > 0. Nothing if it is so nowhere.
inline std::optional<Expression> support(Expression of, int depth = kSupportDepth);

/// The support of a minimum or maximum with 0.
inline std::optional<Expression> support_of_extreme(Expression of) {
  const Node node = (*of.graph)[of.id];  // a copy: conditions grow the arena
  for (const std::size_t k : {0U, 1U}) {
    if (!of.graph->is_constant(node.args[k], 0)) continue;
    const Expression zero = {of.graph, node.args[k]};
    const Expression other = {of.graph, node.args[1 - k]};
    return node.op == Op::Max ? zero < other : other < zero;
  }
  return std::nullopt;
}

/// The support of a choice of which a branch is 0.
inline std::optional<Expression> support_of_choice(Expression of, int depth) {
  Graph* const graph = of.graph;
  const Node node = (*graph)[of.id];
  const bool is_first = graph->is_constant(node.args[2], 0);
  if (!is_first && !graph->is_constant(node.args[1], 0)) return std::nullopt;
  const Expression condition = {graph, node.args[0]};
  const Expression taken = is_first ? condition : make(Op::Equal, condition, of.of(0));
  const auto within = support({graph, node.args[is_first ? 1 : 2]}, depth);
  return within ? make(Op::And, taken, *within) : taken;
}

inline std::optional<Expression> support(Expression of, int depth) {
  Graph* const graph = of.graph;
  const Node node = (*graph)[of.id];
  if (depth == 0) return std::nullopt;
  const auto of_argument = [&](std::size_t k) { return support({graph, node.args[k]}, depth - 1); };
  switch (node.op) {
    case Op::Min:
    case Op::Max:
      return support_of_extreme(of);
    case Op::Neg:
    case Op::Sqrt:
    case Op::Div:
      return of_argument(0);
    case Op::Pow: {
      const bool keeps_zero = graph->is_constant(node.args[1]) && (*graph)[node.args[1]].value > 0;
      return keeps_zero ? of_argument(0) : std::nullopt;
    }
    case Op::Select:
      return support_of_choice(of, depth - 1);
    case Op::Mul: {
      const auto first = of_argument(0);
      const auto second = of_argument(1);
      if (first && second) return make(Op::And, *first, *second);
      return first ? first : second;
    }
    case Op::Add:
    case Op::Sub: {
      const auto first = of_argument(0);
      const auto second = first ? of_argument(1) : std::nullopt;
      if (first && second) return make(Op::Or, *first, *second);
      return std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

/// f(slope), but 0 where the slope is 0 by structure: where max(0, u) is constant, so is its square
/// root, whatever the derivative of a root is there. `known`: a condition that holds.
template <class F>
Expression outside_zeros(Expression slope, F f, std::optional<Expression> known = std::nullopt) {
  const Node node = (*slope.graph)[slope.id];  // a copy: `f` grows the arena
  if (slope.graph->is_constant(slope.id, 0)) return slope;
  if (node.op != Op::Select || !has_zero_branch(slope)) {
    const std::optional<Expression> where = support(slope);
    if (!where || (known && known->id == where->id)) return f(slope);
    return make(Op::Select, *where, f(slope), slope.of(0));
  }
  const Expression condition = {slope.graph, node.args[0]};
  return make(Op::Select, condition, outside_zeros({slope.graph, node.args[1]}, f, condition),
              outside_zeros({slope.graph, node.args[2]}, f));
}

inline Tangent operator-(Tangent t) {
  if (t.slope) return {outside_zeros(*t.slope, [](Expression slope) { return -slope; })};
  return t;
}
inline Tangent operator+(Tangent s, Tangent t) {
  if (s.slope && t.slope) return {*s.slope + *t.slope};
  return s.slope ? s : t;
}
inline Tangent operator-(Tangent s, Tangent t) {
  if (s.slope && t.slope) return {*s.slope - *t.slope};
  return s.slope ? s : -t;
}
inline Tangent operator*(Tangent t, Expression factor) {
  if (!t.slope) return t;
  return {outside_zeros(*t.slope, [&](Expression slope) { return slope * factor; })};
}
inline Tangent operator/(Tangent t, Expression divisor) {
  if (!t.slope) return t;
  return {outside_zeros(*t.slope, [&](Expression slope) { return slope / divisor; })};
}
inline Tangent select(Expression condition, Tangent yes, Tangent no) {
  if (!yes.slope && !no.slope) return {};
  const Expression zero = condition.of(0);
  return {make(Op::Select, condition, yes.slope.value_or(zero), no.slope.value_or(zero))};
}

}  // namespace saddle
