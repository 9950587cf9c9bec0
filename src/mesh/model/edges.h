// The edges of a mesh: which sides of triangles lie between the same two points, and belong
// together. By counting sort: millions of corners, and no hash table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

/// Two points or corners, in order.
using IndexPair = std::pair<std::uint32_t, std::uint32_t>;

/// A side of a triangle, as one of its points sees it.
struct HalfEdge {
  std::uint32_t to;    ///< the other point
  std::uint32_t side;  ///< 3 t + k: of triangle t, from its corner k to the next
  bool arrives;        ///< it runs from the other point to this one

  std::uint32_t triangle() const { return side / 3; }
};

/// The corners of triangles by their points; 3 t + k: corner k of triangle t. Four bytes a corner,
/// as writers of files have little memory.
struct CornersOfPoints {
  std::vector<std::uint32_t> begin;  ///< those of point p are from begin[p] to begin[p + 1]
  Array<std::uint32_t> all;          ///< of a point in increasing order

  std::span<const std::uint32_t> of(std::uint32_t p) const {
    return std::span(all).subspan(begin[p], begin[p + 1] - begin[p]);
  }
};

CornersOfPoints corners_of_points(const Mesh& mesh);

/// The sides that end at a point, by the other point and then by their numbers. `corners`: of the
/// point. A side between corners of one point is there once. `sides` is used again, for speed.
void find_sides(const Mesh& mesh, std::span<const std::uint32_t> corners,
                std::vector<HalfEdge>& sides);

/// Calls visit(sides) for those of each other point.
template <class Visit>
void for_each_neighbour(std::span<const HalfEdge> sides, Visit visit) {
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].to == sides[first].to) ++last;
    visit(sides.subspan(first, last - first));
  }
}

/// Calls visit(p, sides) for each pair of points that have sides between them: p is the smaller.
template <class Visit>
void for_each_pair(const Mesh& mesh, Visit visit) {
  const CornersOfPoints corners = corners_of_points(mesh);
  std::vector<HalfEdge> sides;
  for (std::uint32_t p = 0; p < mesh.point_count; ++p) {
    find_sides(mesh, corners.of(p), sides);
    for_each_neighbour(sides, [&](std::span<const HalfEdge> shared) {
      if (shared[0].to >= p) visit(p, shared);
    });
  }
}

/// The sides between two points, parted into edges. Two sides with the same corners are an edge of
/// their own: leaves around a point may have chords to the same neighbour, which lie on each other.
std::vector<std::vector<HalfEdge>> edges_between(const Mesh& mesh, std::span<const HalfEdge> sides);

}  // namespace saddle
