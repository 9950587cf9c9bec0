// Vectors for the loops that are compiled once for each CPU level. Everything here is static: the
// linker would keep one copy of a shared function, perhaps one for a CPU level that is not there.
#pragma once

#include <stddef.h>

namespace saddle {

struct LoopVector {
  double x, y, z;
};

static inline LoopVector minus(LoopVector a, LoopVector b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline LoopVector plus(LoopVector a, LoopVector b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline LoopVector times(double factor, LoopVector a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
static inline double dot(LoopVector a, LoopVector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline LoopVector cross(LoopVector a, LoopVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The i-th position and unit normal of LeafVertices or a Strip.
template <class Columns>
static inline LoopVector position_at(const Columns& columns, size_t i) {
  return {columns.x[i], columns.y[i], columns.z[i]};
}
template <class Columns>
static inline LoopVector normal_at(const Columns& columns, size_t i) {
  return {columns.n_x[i], columns.n_y[i], columns.n_z[i]};
}

/// `yes` where `condition` is more than 0.
static inline double choose(double condition, double yes, double no) {
  return condition > 0 ? yes : no;
}
static inline LoopVector choose(double condition, LoopVector yes, LoopVector no) {
  return {condition > 0 ? yes.x : no.x, condition > 0 ? yes.y : no.y, condition > 0 ? yes.z : no.z};
}
static inline double larger_of(double a, double b) {
  return b > a ? b : a;
}
static inline double smaller_of(double a, double b) {
  return b < a ? b : a;
}

}  // namespace saddle
