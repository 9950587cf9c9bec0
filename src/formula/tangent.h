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

inline Tangent operator-(Tangent t) {
  if (t.slope) return {-*t.slope};
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
  if (t.slope) return {*t.slope * factor};
  return t;
}
inline Tangent operator/(Tangent t, Expression divisor) {
  if (t.slope) return {*t.slope / divisor};
  return t;
}
inline Tangent select(Expression condition, Tangent yes, Tangent no) {
  if (!yes.slope && !no.slope) return {};
  const Expression zero = condition.of(0);
  return {make(Op::Select, condition, yes.slope.value_or(zero), no.slope.value_or(zero))};
}

}  // namespace saddle
