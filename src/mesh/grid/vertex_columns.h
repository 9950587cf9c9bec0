// Vertices in the form that vector loops read: each coordinate in an array of its own.
#pragma once

#include <cstddef>

#include "base/vec.h"
#include "mesh/grid/loop_vectors.h"

namespace saddle {

inline LoopVector loop_vector(const dvec3& v) {
  return {v.x, v.y, v.z};
}

/// Stores a position and its unit normal as the i-th of `columns`, LeafVertices or a Strip.
template <class Columns>
void put_vertex(const dvec3& position, const dvec3& normal, std::size_t i, Columns& columns) {
  columns.x[i] = position.x;
  columns.y[i] = position.y;
  columns.z[i] = position.z;
  columns.n_x[i] = normal.x;
  columns.n_y[i] = normal.y;
  columns.n_z[i] = normal.z;
}

}  // namespace saddle
