#include "mesh/tree/triangle_budget.h"

#include "mesh/tree/dyadic_vertices.h"
#include "mesh/tree/edge_table.h"

namespace saddle {

bool TriangleBudget::has_many(const TriangleLimit& limit) const {
  if (!limit.is_refined) return true;
  return 2 * (vertices_.used_count() + 2) + edges_.vertex_count() > limit.triangles;
}

}  // namespace saddle
