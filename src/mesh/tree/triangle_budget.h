// Whether a mesh may still grow: the limits of triangles and of effort.
#pragma once

#include "mesh/sizing/effort.h"

namespace saddle {

class DyadicVertices;
class EdgeTable;

class TriangleBudget {
 public:
  TriangleBudget(const DyadicVertices& vertices, const EdgeTable& edges, const Effort& effort)
      : vertices_(vertices), edges_(edges), effort_(effort) {}

  /// Whether one more halving could make more triangles than these. A halving takes up to two
  /// vertices into use. A mesh has fewer than two triangles per vertex (Euler), and one more per
  /// vertex along which it is cut.
  bool has_many(std::size_t triangles) const;
  /// Whether the effort was made that so many triangles are worth.
  bool is_spent(std::size_t max_triangles) const {
    return effort_.total() > most_effort(max_triangles);
  }
  /// Whether either limit is reached.
  bool is_full(std::size_t max_triangles) const {
    return has_many(max_triangles) || is_spent(max_triangles);
  }

 private:
  const DyadicVertices& vertices_;
  const EdgeTable& edges_;
  const Effort& effort_;
};

}  // namespace saddle
