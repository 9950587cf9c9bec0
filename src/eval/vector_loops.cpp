// Vectors of columns, made unit and interleaved. This file is compiled once for each CPU level,
// with SADDLE_LEVEL naming the level (see eval/kernel_loops.cpp for what it may use).
#include <math.h>

#include "eval/vectors.h"

namespace saddle {
namespace {

/// Vectors per round: six columns of it stay in the fastest cache.
constexpr size_t kBlock = 256;

/// A column that can be read like any other, also where one number stands for all of it.
class Column {
 public:
  Column(const Operand& numbers, size_t count) : data_(numbers.data), varies_(numbers.varies) {
    if (varies_) return;
    const double number = *data_;
    const size_t copies = count < kBlock ? count : kBlock;
    for (size_t i = 0; i < copies; ++i) copies_[i] = number;
  }
  const double* from(size_t i) const { return varies_ ? data_ + i : copies_; }

 private:
  const double* data_;
  bool varies_;
  double copies_[kBlock];
};

/// The three columns of vectors.
class Columns {
 public:
  Columns(const Operand* of, size_t count) : x_(of[0], count), y_(of[1], count), z_(of[2], count) {}
  struct Block {
    const double *x, *y, *z;
  };
  Block from(size_t i) const { return {x_.from(i), y_.from(i), z_.from(i)}; }

 private:
  Column x_, y_, z_;
};

/// Squares of lengths beyond these have lost digits, or everything, to the ends of the range of
/// doubles; components times kShrink or kGrow have squares with all their digits.
constexpr double kLargeSquare = 0x1p+1000;
constexpr double kSmallSquare = 0x1p-900;
constexpr double kShrink = 0x1p-550;
constexpr double kGrow = 0x1p+550;

/// A power of two that the components are multiplied by before they are squared, and its inverse.
/// Written so that the compiler makes choices of whole vectors of it.
static inline double scale_for(double square) {
  const double grow = square < kSmallSquare ? kGrow : 1.0;
  return square > kLargeSquare ? kShrink : grow;
}
static inline double unscale_for(double square) {
  const double shrink = square < kSmallSquare ? 1 / kGrow : 1.0;
  return square > kLargeSquare ? 1 / kShrink : shrink;
}

static inline double square_of(double x, double y, double z) {
  return x * x + y * y + z * z;
}

size_t block_size(size_t begin, size_t count) {
  return count - begin < kBlock ? count - begin : kBlock;
}

void interleave(const Operand* vectors, size_t count, double* to) {
  const Columns columns(vectors, count);
  for (size_t begin = 0; begin < count; begin += kBlock) {
    const size_t size = block_size(begin, count);
    const auto [x, y, z] = columns.from(begin);
    double* const out = to + 3 * begin;
#pragma GCC ivdep  // the columns are no part of the array
    for (size_t i = 0; i < size; ++i) {
      out[3 * i] = x[i];
      out[3 * i + 1] = y[i];
      out[3 * i + 2] = z[i];
    }
  }
}

/// One division and three products take half the time of three divisions.
void normalize(const Operand* vectors, size_t count, double sign, double* const* units,
               double* lengths) {
  const Columns columns(vectors, count);
  for (size_t begin = 0; begin < count; begin += kBlock) {
    const size_t size = block_size(begin, count);
    const auto [x, y, z] = columns.from(begin);
    double* const unit_x = units[0] + begin;
    double* const unit_y = units[1] + begin;
    double* const unit_z = units[2] + begin;
    double* const length = lengths + begin;
#pragma GCC ivdep  // a column that is written is read at the same place, if at all
    for (size_t i = 0; i < size; ++i) {
      const double square = square_of(x[i], y[i], z[i]);
      const double scale = scale_for(square);
      const double a = scale * x[i], b = scale * y[i], c = scale * z[i];
      const double root = sqrt(square_of(a, b, c));
      const double part = sign / root;
      length[i] = root * unscale_for(square);
      unit_x[i] = a * part;
      unit_y[i] = b * part;
      unit_z[i] = c * part;
    }
  }
}

void floats(const Operand* positions, const Operand* normals, size_t count, float* position,
            float* normal) {
  const Columns points(positions, count);
  const Columns directions(normals, count);
  for (size_t begin = 0; begin < count; begin += kBlock) {
    const size_t size = block_size(begin, count);
    const auto [x, y, z] = points.from(begin);
    const auto [n_x, n_y, n_z] = directions.from(begin);
    float* const r = position + 3 * begin;
    float* const n = normal + 3 * begin;
#pragma GCC ivdep  // the columns are no part of the arrays
    for (size_t i = 0; i < size; ++i) {
      const double scale = scale_for(square_of(n_x[i], n_y[i], n_z[i]));
      const double a = scale * n_x[i], b = scale * n_y[i], c = scale * n_z[i];
      const double part = 1 / sqrt(square_of(a, b, c));
      r[3 * i] = static_cast<float>(x[i]);
      r[3 * i + 1] = static_cast<float>(y[i]);
      r[3 * i + 2] = static_cast<float>(z[i]);
      n[3 * i] = static_cast<float>(a * part);
      n[3 * i + 1] = static_cast<float>(b * part);
      n[3 * i + 2] = static_cast<float>(c * part);
    }
  }
}

constexpr VectorLoops kLoops = {&interleave, &normalize, &floats};

}  // namespace

const VectorLoops& SADDLE_LEVEL() {
  return kLoops;
}

}  // namespace saddle
