// Building graph nodes as one writes mathematics. The rules of ops.def are written in it: they may
// call every operation of the table, by the name in its function column.
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

// The operations, each by the function column of its row; one argument of two may be a number.
#define SADDLE_FUNCTION_1(name, op)      \
  inline Expression name(Expression a) { \
    return make(Op::op, a);              \
  }
#define SADDLE_FUNCTION_2(name, op)                    \
  inline Expression name(Expression a, Expression b) { \
    return make(Op::op, a, b);                         \
  }                                                    \
  inline Expression name(Expression a, double b) {     \
    return make(Op::op, a, a.of(b));                   \
  }                                                    \
  inline Expression name(double a, Expression b) {     \
    return make(Op::op, b.of(a), b);                   \
  }
#define SADDLE_FUNCTION_3(name, op)                                  \
  inline Expression name(Expression a, Expression b, Expression c) { \
    return make(Op::op, a, b, c);                                    \
  }
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, function, ...) \
  SADDLE_FUNCTION_##arity(function, id)
#include "formula/ops.def"
#undef SADDLE_FUNCTION_1
#undef SADDLE_FUNCTION_2
#undef SADDLE_FUNCTION_3

inline Expression select(Expression condition, double yes, Expression no) {
  return select(condition, condition.of(yes), no);
}

/// 3t^2 - 2t^3, for smoothstep.
inline Expression smooth(Expression t) {
  return t * t * (3 - 2 * t);
}

}  // namespace saddle
