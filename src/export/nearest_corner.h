// The corner of a mesh that is nearest to a point on it, by cells of space.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

class NearestCorner {
 public:
  /// It refers to the mesh, which has a corner.
  explicit NearestCorner(const Mesh& mesh);

  /// The nearest corner in the cells around the point, or around the nearest cell that has some.
  std::size_t to(const dvec3& p) const;

 private:
  using Cell = std::uint64_t;
  struct Entry {
    Cell cell;
    std::uint32_t corner;
  };
  /// The number of the cell `steps` cells off the one of a point, along each axis.
  Cell cell_of(const dvec3& p, const std::array<int, 3>& steps = {}) const;

  const Mesh& mesh_;
  dvec3 scale_;
  std::vector<Entry> entries_;  // by cell
};

}  // namespace saddle
