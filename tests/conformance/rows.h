// The rows of the table of operations, for tests that go through all of them.
#pragma once

#include <array>

#include "formula/graph.h"

namespace saddle::testing {

struct Row {
  Op op;
  const char* id;
  const char* name;  ///< "" for operations that only derivatives produce
  int arity;
  double ulps;
};

inline constexpr std::array kRows = {
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, ...) \
  Row{Op::id, #id, name, arity, ulps},
#include "formula/ops.def"
};

/// Whether the first argument is a whole constant, the order of a derivative or of a function.
inline bool takes_an_order(Op op) {
  return op == Op::Polygamma || op == Op::BesselJ || op == Op::SincN;
}

}  // namespace saddle::testing
