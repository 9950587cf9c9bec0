// Marks on root cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/tree/leaf.h"

namespace saddle {

struct Grid;

/// A number for each root cell; 0 is no mark.
class CellMarks {
 public:
  explicit CellMarks(const Grid& grid);

  /// Marks the root cells that contain a place, in units. A place on a line is in both cells.
  void add(const dvec2& place, std::uint32_t mark = 1);
  /// The last mark of a leaf's root cell.
  std::uint32_t of(const Leaf& leaf) const {
    if (marks_.empty()) return 0;
    return marks_[leaf.low.v / kCellUnit * cells_u_ + leaf.low.u / kCellUnit];
  }
  /// Whether a leaf's root cell has a mark.
  bool contains(const Leaf& leaf) const { return of(leaf) != 0; }

 private:
  std::size_t cells_u_, cells_v_;
  std::vector<std::uint32_t> marks_;  // none before the first
};

}  // namespace saddle
