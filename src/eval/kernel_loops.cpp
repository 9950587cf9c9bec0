// The loops over a block, one for each row of the table of operations. This file is compiled once
// for each CPU level, with SADDLE_LEVEL naming the level. It may only use functions of its own, of
// C and of SLEEF: an inline function of a header that is compiled here for AVX-512 could be the
// copy that the linker keeps for everyone.
//
// The same bits on all levels: plain arithmetic is IEEE 754 in vectors too (nothing is contracted),
// and SLEEF's finz functions do the same operations on every level, whatever the other lanes hold.
// They need a fused multiply-add, which the purecfma form takes from the processor as well; for
// processors without one (before 2013) there are the cinz functions, which differ in the last bit.
#define FP_FAST_FMA  // sleef.h then declares its functions for processors with FMA
#include <immintrin.h>
#include <math.h>
#include <sleef.h>

#include "eval/kernels.h"
#include "formula/special.h"

namespace saddle {
namespace {

#if defined(__AVX512F__)
using Vector = __m512d;
constexpr size_t kWidth = 8;
static Vector load(const double* p) {
  return _mm512_loadu_pd(p);
}
static Vector spread(double x) {
  return _mm512_set1_pd(x);
}
static void store(double* p, Vector x) {
  _mm512_storeu_pd(p, x);
}
#define SLEEF(name, accuracy) Sleef_finz_##name##d8_##accuracy##avx512f
#elif defined(__AVX2__)
using Vector = __m256d;
constexpr size_t kWidth = 4;
static Vector load(const double* p) {
  return _mm256_loadu_pd(p);
}
static Vector spread(double x) {
  return _mm256_set1_pd(x);
}
static void store(double* p, Vector x) {
  _mm256_storeu_pd(p, x);
}
#define SLEEF(name, accuracy) Sleef_finz_##name##d4_##accuracy##avx2
#elif defined(SADDLE_WITHOUT_FMA)
using Vector = __m128d;
constexpr size_t kWidth = 2;
static Vector load(const double* p) {
  return _mm_loadu_pd(p);
}
static Vector spread(double x) {
  return _mm_set1_pd(x);
}
static void store(double* p, Vector x) {
  _mm_storeu_pd(p, x);
}
#define SLEEF(name, accuracy) Sleef_cinz_##name##d2_##accuracy##sse2
#else
using Vector = double;
constexpr size_t kWidth = 1;
static Vector load(const double* p) {
  return *p;
}
static Vector spread(double x) {
  return x;
}
static void store(double* p, Vector x) {
  *p = x;
}
#define SLEEF(name, accuracy) Sleef_finz_##name##d1_##accuracy##purecfma
#endif

struct NoVector {};

// For each row: the value of one number, and the vector function if SLEEF has it.
#define LOOP \
  NoVector {}
#define SLEEF1(name, accuracy) SLEEF(name, accuracy)(a)
#define SLEEF2(name, accuracy) SLEEF(name, accuracy)(a, b)
#define SADDLE_OP(id, name, arity, help, value, vector, ...)                                       \
  struct id##Row {                                                                                 \
    static constexpr int kArity = arity;                                                           \
    static double of([[maybe_unused]] double a, [[maybe_unused]] double b,                         \
                     [[maybe_unused]] double c) {                                                  \
      return value;                                                                                \
    }                                                                                              \
    static auto of_vector([[maybe_unused]] Vector a, [[maybe_unused]] Vector b) { return vector; } \
  };
#include "formula/ops.def"

template <class T>
constexpr bool kIsVector = true;
template <>
constexpr bool kIsVector<NoVector> = false;

/// The plain loop, with each operand's kind known at compile time: a broadcast costs no copy.
template <class Row, bool kVariesA, bool kVariesB>
void loop(double* out, const Operand* in, size_t count) {
  const double* const a = in[0].data;
  const double* const b = in[1].data;
  const double* const c = in[2].data;
  const size_t step_c = in[2].varies ? 1 : 0;
#pragma GCC ivdep  // out is an operand's data or overlaps none
  for (size_t i = 0; i < count; ++i) {
    out[i] = Row::of(a[kVariesA ? i : 0], Row::kArity > 1 ? b[kVariesB ? i : 0] : 0,
                     Row::kArity > 2 ? c[i * step_c] : 0);
  }
}

/// The loop over whole vectors; the last one is padded with copies of the last number.
template <class Row, bool kVariesA, bool kVariesB>
void vector_loop(double* out, const Operand* in, size_t count) {
  const double* const a = in[0].data;
  const double* const b = in[1].data;
  const auto value = [=](size_t i) {
    const Vector second = Row::kArity < 2 ? spread(0) : kVariesB ? load(b + i) : spread(*b);
    return Row::of_vector(kVariesA ? load(a + i) : spread(*a), second);
  };
  size_t i = 0;
  for (; i + kWidth <= count; i += kWidth) store(out + i, value(i));
  if (i == count) return;
  double last_a[kWidth];
  double last_b[kWidth];
  double last_out[kWidth];
  for (size_t k = 0; k < kWidth; ++k) {
    const size_t from = i + k < count ? i + k : count - 1;
    last_a[k] = a[kVariesA ? from : 0];
    last_b[k] = Row::kArity < 2 ? 0 : b[kVariesB ? from : 0];
  }
  store(last_out, Row::of_vector(load(last_a), load(last_b)));
  for (size_t k = 0; i + k < count; ++k) out[i + k] = last_out[k];
}

template <class Row, bool kVariesA, bool kVariesB>
void run_as(double* out, const Operand* in, size_t count) {
  if constexpr (kIsVector<decltype(Row::of_vector(Vector{}, Vector{}))>) {
    vector_loop<Row, kVariesA, kVariesB>(out, in, count);
  } else {
    loop<Row, kVariesA, kVariesB>(out, in, count);
  }
}

template <class Row>
void run(double* out, const Operand* in, size_t count) {
  if constexpr (Row::kArity == 1) {
    run_as<Row, true, false>(out, in, count);
  } else if (in[0].varies) {
    in[1].varies ? run_as<Row, true, true>(out, in, count)
                 : run_as<Row, true, false>(out, in, count);
  } else {
    in[1].varies ? run_as<Row, false, true>(out, in, count)
                 : run_as<Row, false, false>(out, in, count);
  }
}

void sin_cos(double* sin, double* cos, const double* in, size_t count) {
  size_t i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const auto both = SLEEF(sincos, u10)(load(in + i));
    store(sin + i, both.x);
    store(cos + i, both.y);
  }
  if (i == count) return;
  double last[kWidth];  // padded with copies of the last number
  double last_sin[kWidth];
  double last_cos[kWidth];
  for (size_t k = 0; k < kWidth; ++k) last[k] = in[i + k < count ? i + k : count - 1];
  const auto both = SLEEF(sincos, u10)(load(last));
  store(last_sin, both.x);
  store(last_cos, both.y);
  for (size_t k = 0; i + k < count; ++k) {
    sin[i + k] = last_sin[k];
    cos[i + k] = last_cos[k];
  }
}

constexpr Kernel kLoops[] = {
    nullptr,  // Op::Constant
    nullptr,  // Op::Variable
    nullptr,  // Op::Hull
    nullptr,  // Op::Narrow
#define SADDLE_OP(id, ...) &run<id##Row>,
#include "formula/ops.def"
};

}  // namespace

const Kernels& SADDLE_LEVEL() {
  static constexpr Kernels kKernels = {kLoops, &sin_cos};
  return kKernels;
}

}  // namespace saddle
