// Normals at singular vertices, where each leaf sees a limit of its own.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/model/mesh_report.h"
#include "mesh/tree/leaf.h"
#include "surface/normal.h"

namespace saddle {

class CellTree;
struct Grid;

/// A cache of the last set of limits of normals. Most meshes have the same singular vertices when
/// they are validated and when they are finished.
class LastLimits {
 public:
  /// limits_in_cells().
  const std::vector<NormalLimit>& find(const Surface& surface, std::vector<Approach> approaches,
                                       unsigned threads);

 private:
  std::vector<Approach> approaches_;
  std::vector<NormalLimit> limits_;
};

/// The mesh corners of leaves at singular vertices. A regular vertex is one corner.
class SingularCorners {
 public:
  SingularCorners() = default;
  /// Gives each singular vertex of a sub-polygon the limit of the normal from inside, or the normal
  /// of the face where there is none. Adds corners to grid.mesh, and singular points to
  /// `report`.
  SingularCorners(std::span<const Leaf> leaves, const CellTree& tree, unsigned threads,
                  LastLimits& last, Grid& grid, MeshReport& report);

  /// `sub_polygon`: an index into sub_polygons() of the leaf.
  std::uint32_t corner(std::size_t leaf, std::size_t sub_polygon, std::uint32_t vertex) const;
  /// The leaves that have such corners, ascending.
  const std::vector<std::size_t>& leaves() const { return leaves_; }

 private:
  std::vector<std::size_t> leaves_;
  std::unordered_map<std::uint64_t, std::uint32_t> corners_;
};

}  // namespace saddle
