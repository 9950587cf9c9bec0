// The nearest of many triangles: a tree of boxes around triangles that follow each other, as those
// of neighbouring leaves do. In a large tree the smallest boxes, which are most, are made when they
// are asked for.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, chapter 6.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/grid/grid.h"

namespace saddle {

struct NearestTriangle {
  Triangle triangle = {};
  dvec3 point{0};
  double distance = std::numeric_limits<double>::infinity();
};

/// The point of a triangle that is nearest to a position.
NearestTriangle nearest_point(const Grid& grid, const Triangle& triangle, const dvec3& position);

class NearestTriangles {
 public:
  /// The tree refers to its arguments.
  NearestTriangles(const Grid& grid, std::span<const Triangle> triangles);

  /// A triangle within `enough` of a position; if there is none, the nearest, or `known`, if that
  /// is nearer. Adds the nodes that it visits to `visited`.
  NearestTriangle nearest(const dvec3& position, double enough, NearestTriangle known,
                          std::size_t& visited) const;

 private:
  std::span<const Triangle> triangles_of(std::size_t node) const;
  Bounds box_of(std::size_t node) const;
  /// In local units.
  double square_of_distance(std::size_t node, const dvec3& position) const;

  const Grid& grid_;
  std::span<const Triangle> triangles_;
  /// A heap: node k is around nodes 2 k + 1 and 2 k + 2; the last leaves_ nodes hold triangles.
  std::size_t leaves_;
  std::vector<Bounds> boxes_;  // of the nodes above the last levels
};

}  // namespace saddle
