// Building graph nodes as one writes mathematics. The rules of ops.def are written in it: they may
// call every operation of the table, by the name that its interval column has.
#pragma once

#include <cmath>

#include "formula/graph.h"

namespace saddle {

/// A node together with the graph it lives in.
struct Expression {
  Graph* graph;
  NodeId id;

  Expression of(double value) const { return {graph, graph->constant(value)}; }
};

inline Expression make(Op op, Expression a) {
  return {a.graph, a.graph->make(op, a.id)};
}
inline Expression make(Op op, Expression a, Expression b) {
  return {a.graph, a.graph->make(op, a.id, b.id)};
}
inline Expression make(Op op, Expression a, Expression b, Expression c) {
  return {a.graph, a.graph->make(op, a.id, b.id, c.id)};
}

#define SADDLE_BINARY(name, op)                        \
  inline Expression name(Expression a, Expression b) { \
    return make(Op::op, a, b);                         \
  }                                                    \
  inline Expression name(Expression a, double b) {     \
    return make(Op::op, a, a.of(b));                   \
  }                                                    \
  inline Expression name(double a, Expression b) {     \
    return make(Op::op, b.of(a), b);                   \
  }
SADDLE_BINARY(operator+, Add)
SADDLE_BINARY(operator-, Sub)
SADDLE_BINARY(operator*, Mul)
SADDLE_BINARY(operator/, Div)
SADDLE_BINARY(operator<, Less)
SADDLE_BINARY(operator<=, LessEqual)
SADDLE_BINARY(operator>, Greater)
SADDLE_BINARY(operator>=, GreaterEqual)
SADDLE_BINARY(operator==, Equal)
SADDLE_BINARY(operator!=, NotEqual)
SADDLE_BINARY(both, And)
SADDLE_BINARY(either, Or)
SADDLE_BINARY(pow, Pow)
SADDLE_BINARY(hypot, Hypot)
SADDLE_BINARY(atan2, Atan2)
SADDLE_BINARY(mod, Mod)
SADDLE_BINARY(min, Min)
SADDLE_BINARY(max, Max)
SADDLE_BINARY(polygamma, Polygamma)
SADDLE_BINARY(bessel_j, BesselJ)
SADDLE_BINARY(sinc_derivative, SincN)
#undef SADDLE_BINARY

#define SADDLE_UNARY(name, op)           \
  inline Expression name(Expression a) { \
    return make(Op::op, a);              \
  }
SADDLE_UNARY(operator-, Neg)
SADDLE_UNARY(sqrt, Sqrt)
SADDLE_UNARY(cbrt, Cbrt)
SADDLE_UNARY(exp, Exp)
SADDLE_UNARY(log, Log)
SADDLE_UNARY(log2, Log2)
SADDLE_UNARY(log10, Log10)
SADDLE_UNARY(sin, Sin)
SADDLE_UNARY(cos, Cos)
SADDLE_UNARY(tan, Tan)
SADDLE_UNARY(asin, Asin)
SADDLE_UNARY(acos, Acos)
SADDLE_UNARY(atan, Atan)
SADDLE_UNARY(sinh, Sinh)
SADDLE_UNARY(cosh, Cosh)
SADDLE_UNARY(tanh, Tanh)
SADDLE_UNARY(asinh, Asinh)
SADDLE_UNARY(acosh, Acosh)
SADDLE_UNARY(atanh, Atanh)
SADDLE_UNARY(abs, Abs)
SADDLE_UNARY(sign, Sign)
SADDLE_UNARY(floor, Floor)
SADDLE_UNARY(ceil, Ceil)
SADDLE_UNARY(round, Round)
SADDLE_UNARY(rint, Rint)
SADDLE_UNARY(trunc, Trunc)
SADDLE_UNARY(erf, Erf)
SADDLE_UNARY(gamma, Gamma)
SADDLE_UNARY(lgamma, Lgamma)
#undef SADDLE_UNARY

inline Expression select(Expression condition, Expression yes, Expression no) {
  return make(Op::Select, condition, yes, no);
}
inline Expression select(Expression condition, double yes, Expression no) {
  return select(condition, condition.of(yes), no);
}

/// 3t^2 - 2t^3, for smoothstep.
inline Expression smooth(Expression t) {
  return t * t * (3 - 2 * t);
}

}  // namespace saddle
