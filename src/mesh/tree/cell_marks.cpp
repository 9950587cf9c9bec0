#include "mesh/tree/cell_marks.h"
#include "mesh/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace saddle {

CellMarks::CellMarks(const Grid& grid) : cells_u_(grid.cells_u), cells_v_(grid.cells_v) {}

void CellMarks::add(const dvec2& place, std::uint32_t mark) {
  if (marks_.empty()) marks_.resize(cells_u_ * cells_v_, 0);
  const dvec2 cells = place / static_cast<double>(kCellUnit);
  const auto range = [](double at, std::size_t count) {
    const auto low = static_cast<std::size_t>(std::max(std::ceil(at) - 1, 0.0));
    const auto high = std::min(static_cast<std::size_t>(at), count - 1);
    return std::pair(low, high);
  };
  const auto [low_u, high_u] = range(cells.x, cells_u_);
  const auto [low_v, high_v] = range(cells.y, cells_v_);
  for (std::size_t j = low_v; j <= high_v; ++j) {
    for (std::size_t i = low_u; i <= high_u; ++i) marks_[j * cells_u_ + i] = mark;
  }
}

}  // namespace saddle
