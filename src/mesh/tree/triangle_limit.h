// The limit of triangles of a mesh.
#pragma once

#include <cstddef>

namespace saddle {

/// Only TriangleBudget interprets it.
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

}  // namespace saddle
