#include "eval/kernels.h"

#include <cmath>

#include "formula/special.h"

namespace saddle {
namespace {

// A functor for each row of the table, so that its loop is compiled with the operation inside.
#define SADDLE_OP(id, name, arity, value, derivative, help)                                   \
  struct id##Value {                                                                          \
    static constexpr int kArity = arity;                                                      \
    double operator()(double a, [[maybe_unused]] double b, [[maybe_unused]] double c) const { \
      return value;                                                                           \
    }                                                                                         \
  };
#include "formula/ops.def"

/// The loop with each operand's kind known at compile time: broadcast costs no copy.
template <class Value, bool kVariesA, bool kVariesB>
void loop(double* out, const std::array<Operand, 3>& in, std::size_t count) {
  const Value value;
  const double* const a = in[0].data;
  const double* const b = in[1].data;
  const double* const c = in[2].data;
  const std::size_t step_c = in[2].varies ? 1 : 0;
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = value(a[kVariesA ? i : 0], Value::kArity > 1 ? b[kVariesB ? i : 0] : 0,
                   Value::kArity > 2 ? c[i * step_c] : 0);
  }
}

template <class Value>
void run(double* out, const std::array<Operand, 3>& in, std::size_t count) {
  if constexpr (Value::kArity == 1) {
    loop<Value, true, false>(out, in, count);
  } else if (in[0].varies) {
    in[1].varies ? loop<Value, true, true>(out, in, count)
                 : loop<Value, true, false>(out, in, count);
  } else {
    in[1].varies ? loop<Value, false, true>(out, in, count)
                 : loop<Value, false, false>(out, in, count);
  }
}

}  // namespace

Kernel kernel(Op op) {
  switch (op) {
    case Op::Constant:
    case Op::Variable:
      break;
#define SADDLE_OP(id, name, arity, value, derivative, help) \
  case Op::id:                                              \
    return &run<id##Value>;
#include "formula/ops.def"
  }
  return nullptr;
}

}  // namespace saddle
