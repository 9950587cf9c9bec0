// The edges of a mesh: which sides of triangles lie between the same two points, and belong
// together. By counting sort: millions of sides, and no hash table.
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

/// A side of a triangle, without the smaller one of its points.
struct HalfEdge {
  std::uint32_t to;    ///< the larger point
  std::uint32_t side;  ///< 3 t + k: of triangle t, from its corner k to the next
  bool downward;       ///< it runs from the larger to the smaller point

  std::uint32_t triangle() const { return side / 3; }
};

/// All sides of triangles, sorted by their smaller and then by their larger point. Sides whose
/// smaller point is p begin at `begin[p]`.
struct HalfEdges {
  std::vector<std::size_t> begin;
  Array<HalfEdge> all;
};

HalfEdges half_edges(const Mesh& mesh);

/// Calls visit(p, sides) for each pair of points that have sides between them: p is the smaller.
template <class Visit>
void for_each_pair(const HalfEdges& edges, Visit visit) {
  for (std::uint32_t p = 0; p + 1 < edges.begin.size(); ++p) {
    for (std::size_t first = edges.begin[p], last = first; first < edges.begin[p + 1];
         first = last) {
      while (last < edges.begin[p + 1] && edges.all[last].to == edges.all[first].to) ++last;
      visit(p, std::span(edges.all).subspan(first, last - first));
    }
  }
}

/// The sides between two points, parted into edges. Two sides with the same corners are an edge of
/// their own: leaves around a point may have chords to the same neighbour, which lie on each other.
std::vector<std::vector<HalfEdge>> edges_between(const Mesh& mesh, std::span<const HalfEdge> sides);

}  // namespace saddle
