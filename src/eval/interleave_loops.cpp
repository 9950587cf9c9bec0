// Three columns into an array of vectors. This file is compiled once for each CPU level, with
// SADDLE_LEVEL naming the level (see eval/kernel_loops.cpp for what it may use).
#include "eval/interleave.h"

namespace saddle {
namespace {

/// With each column's kind known at compile time the compiler shuffles whole vectors.
template <class Real, bool kVariesX, bool kVariesY, bool kVariesZ>
void loop(const double* x, const double* y, const double* z, size_t count, Real* to) {
#pragma GCC ivdep  // the columns are no part of the array
  for (size_t i = 0; i < count; ++i) {
    to[3 * i] = static_cast<Real>(x[kVariesX ? i : 0]);
    to[3 * i + 1] = static_cast<Real>(y[kVariesY ? i : 0]);
    to[3 * i + 2] = static_cast<Real>(z[kVariesZ ? i : 0]);
  }
}

template <class Real, bool kVariesX, bool kVariesY>
void choose_z(const Operand& x, const Operand& y, const Operand& z, size_t count, Real* to) {
  z.varies ? loop<Real, kVariesX, kVariesY, true>(x.data, y.data, z.data, count, to)
           : loop<Real, kVariesX, kVariesY, false>(x.data, y.data, z.data, count, to);
}

template <class Real, bool kVariesX>
void choose_y(const Operand& x, const Operand& y, const Operand& z, size_t count, Real* to) {
  y.varies ? choose_z<Real, kVariesX, true>(x, y, z, count, to)
           : choose_z<Real, kVariesX, false>(x, y, z, count, to);
}

template <class Real>
void interleave(const Operand& x, const Operand& y, const Operand& z, size_t count, Real* to) {
  x.varies ? choose_y<Real, true>(x, y, z, count, to) : choose_y<Real, false>(x, y, z, count, to);
}

constexpr InterleaveLoops kLoops = {&interleave<double>, &interleave<float>};

}  // namespace

const InterleaveLoops& SADDLE_LEVEL() {
  return kLoops;
}

}  // namespace saddle
