// Three columns into an array of vectors. This file is compiled once for each CPU level, with
// SADDLE_LEVEL naming the level (see eval/kernel_loops.cpp for what it may use).
#include "eval/interleave.h"

namespace saddle {
namespace {

/// Vectors per round: three columns of it stay in the fastest cache.
constexpr size_t kBlock = 256;

/// A column that can be read like any other, also where one number stands for all of it.
class Column {
 public:
  Column(const Operand& numbers, size_t count) : data_(numbers.data), varies_(numbers.varies) {
    if (varies_) return;
    for (size_t i = 0; i < kBlock && i < count; ++i) copies_[i] = *data_;
  }
  const double* from(size_t i) const { return varies_ ? data_ + i : copies_; }

 private:
  const double* data_;
  bool varies_;
  double copies_[kBlock];
};

/// The compiler shuffles whole vectors if all three columns vary.
template <class Real>
void interleave(const Operand& x, const Operand& y, const Operand& z, size_t count, Real* to) {
  const Column columns[] = {{x, count}, {y, count}, {z, count}};
  for (size_t begin = 0; begin < count; begin += kBlock) {
    const size_t size = count - begin < kBlock ? count - begin : kBlock;
    const double* const a = columns[0].from(begin);
    const double* const b = columns[1].from(begin);
    const double* const c = columns[2].from(begin);
    Real* const out = to + 3 * begin;
#pragma GCC ivdep  // the columns are no part of the array
    for (size_t i = 0; i < size; ++i) {
      out[3 * i] = static_cast<Real>(a[i]);
      out[3 * i + 1] = static_cast<Real>(b[i]);
      out[3 * i + 2] = static_cast<Real>(c[i]);
    }
  }
}

constexpr InterleaveLoops kLoops = {&interleave<double>, &interleave<float>};

}  // namespace

const InterleaveLoops& SADDLE_LEVEL() {
  return kLoops;
}

}  // namespace saddle
