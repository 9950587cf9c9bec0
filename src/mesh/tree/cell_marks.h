// In which cells of the root grid there is something.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/tree/leaf.h"

namespace saddle {

/// Marks on cells of the root grid: numbers, 0 for none.
class CellMarks {
 public:
  explicit CellMarks(const Grid& grid)
      : cells_u_(grid.cells_u), cells_v_(grid.cells_v), marks_(grid.cell_count(), 0) {}

  /// Marks the cells that a place, in units, is in or on the border of.
  void add(const dvec2& place, std::uint32_t mark = 1);
  /// The last mark of the cell that a leaf is in.
  std::uint32_t of(const Leaf& leaf) const {
    return marks_[leaf.low.v / kCellUnit * cells_u_ + leaf.low.u / kCellUnit];
  }
  /// Whether that is marked.
  bool contains(const Leaf& leaf) const { return of(leaf) != 0; }

 private:
  std::size_t cells_u_, cells_v_;
  std::vector<std::uint32_t> marks_;
};

}  // namespace saddle
