// How the loops over many cells or leaves read vertices: each coordinate in an array of its own.
#pragma once

#include <cstddef>

#include "base/vec.h"
#include "mesh/grid/loop_vectors.h"

namespace saddle {

inline LoopVector loop_vector(const dvec3& v) {
  return {v.x, v.y, v.z};
}

/// Makes a position and its unit normal the i-th of `columns`, which are LeafVertices or a Strip.
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
