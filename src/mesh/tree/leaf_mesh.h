// From leaves to triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
class SingularCorners;
struct Grid;

/// The triangles of some leaves.
struct LeafTriangles {
  /// The triangles of one leaf.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t expected : 30 = 0;        ///< the count if all had an area
    bool is_plain : 1 = false;              ///< two triangles of a leaf that nothing cuts
    bool has_flat_sub_polygon : 1 = false;  ///< a sub-polygon is a side of the leaf: is_flat()

    /// No triangle is missing because it has no area. Between two sides that are points there is
    /// none at all.
    bool is_complete() const { return count > 0 && count >= expected; }
  };
  Array<Triangle> all;
  std::vector<Range> ranges;

  std::span<const Triangle> of(std::size_t k) const {
    return std::span(all).subspan(ranges[k].first, ranges[k].count);
  }
  std::size_t expected() const;
  /// Appends the triangles of other leaves.
  void append(const LeafTriangles& others);
  /// Takes a triangle from those of its leaf, which is not complete any more. It stays in `all`.
  void remove(std::size_t leaf, const Triangle& triangle);
};

/// The triangles of leaves next to each other in LeafTriangles, which must outlive this.
class PartOfTriangles {
 public:
  PartOfTriangles(const LeafTriangles& of, std::size_t first, std::size_t count)
      : of_(of), ranges_(std::span(of.ranges).subspan(first, count)) {}

  std::span<const Triangle> of(std::size_t k) const {
    return std::span(of_.all).subspan(ranges_[k].first, ranges_[k].count);
  }
  const LeafTriangles::Range& range(std::size_t k) const { return ranges_[k]; }

 private:
  const LeafTriangles& of_;
  std::span<const LeafTriangles::Range> ranges_;
};

/// Triangulates the cell polygons of the leaves `which`, in that order, on so many threads (0:
/// all).
LeafTriangles triangulate_leaves(std::span<const Leaf> leaves, std::span<const std::size_t> which,
                                 const SingularCorners& singular, const Grid& grid,
                                 const CellTree& tree, unsigned threads);

}  // namespace saddle
