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

/// f(slope), but 0 in the branches that are 0 by structure: where max(0, u) is constant, so is its
/// square root, whatever the derivative of a root is there.
template <class F>
Expression outside_zeros(Expression slope, F f) {
  const Node node = (*slope.graph)[slope.id];  // a copy: `f` grows the arena
  if (!has_zero_branch(slope)) return f(slope);
  if (node.op != Op::Select) return slope;
  const auto [condition, yes, no] = node.args;
  return make(Op::Select, {slope.graph, condition}, outside_zeros({slope.graph, yes}, f),
              outside_zeros({slope.graph, no}, f));
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
