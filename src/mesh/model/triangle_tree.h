// The distance of points from many triangles: a tree of boxes.
// Source: C. Ericson, "Real-time collision detection", 2005, 5.1.5 and chapter 6.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

class TriangleTree {
 public:
  /// The tree keeps references to its arguments.
  explicit TriangleTree(const Mesh& mesh) : TriangleTree(mesh.position, mesh.triangles) {}
  TriangleTree(std::span<const dvec3> position, std::span<const Triangle> triangles);

  /// The distance of the nearest triangle, or `known` if none is nearer.
  double distance(const dvec3& p, double known = std::numeric_limits<double>::infinity()) const;

 private:
  struct Node {
    Bounds box;
    std::uint32_t first =
        0;  ///< leaf: of its triangles; else: its second child (the first follows)
    std::uint32_t count = 0;  ///< leaf: triangles; else 0
  };
  /// A triangle and the sum of its corners.
  struct Item {
    dvec3 middle;
    std::uint32_t triangle;
  };
  void build(std::span<Item> items);

  std::span<const dvec3> position_;
  std::span<const Triangle> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace saddle
