// Whether a mesh may still grow: the limits of triangles and of effort.
#pragma once

#include <cstddef>

#include "base/run_limits.h"
#include "mesh/sizing/effort.h"

namespace saddle {

class DyadicVertices;
class EdgeTable;

/// The limit of triangles of a mesh. Only TriangleBudget interprets it.
struct TriangleLimit {
  std::size_t triangles = 4'000'000;
  /// false: root cells are not subdivided, so the limit counts as reached; searches for the edge
  /// features of root cells have no end then.
  bool is_refined = true;
  /// The effort that is allowed however few the triangles are, in places (mesh/sizing/effort.h).
  std::size_t least_effort = 1'000'000;

  /// A limit with a share of the triangles.
  TriangleLimit part(double share) const {
    return {static_cast<std::size_t>(share * static_cast<double>(triangles)), is_refined,
            least_effort};
  }
};

class TriangleBudget {
 public:
  TriangleBudget(const DyadicVertices& vertices, const EdgeTable& edges, const Effort& effort)
      : vertices_(vertices), edges_(edges), effort_(effort) {}

  /// Whether one more halving could make more triangles than the limit. A halving takes up to two
  /// vertices into use. A mesh has fewer than two triangles per vertex (Euler), and one more per
  /// vertex along which it is cut.
  bool has_many(const TriangleLimit& limit) const;
  /// Whether the effort is spent that the limit of triangles is worth, or all points are used up
  /// that the surface may be computed at, or the run is short of time or memory.
  bool is_spent(const TriangleLimit& limit) const {
    return limit.is_refined &&
           (effort_.total() > most_effort(limit.triangles, limit.least_effort) ||
            effort_.is_used_up() || shortage() != Shortage::None);
  }
  /// Whether either limit is reached.
  bool is_full(const TriangleLimit& limit) const { return has_many(limit) || is_spent(limit); }
  /// Whether sides may be cut at faces of the clip box, which doubles their leaves' triangles.
  bool has_room_for_faces(const TriangleLimit& limit) const {
    return !limit.is_refined || !has_many(limit);
  }

 private:
  const DyadicVertices& vertices_;
  const EdgeTable& edges_;
  const Effort& effort_;
};

}  // namespace saddle
