#include "mesh/grid/cell_loops.h"

namespace saddle {

// One copy of cut_cells.cpp and of check_row.cpp each.
void cut_cells_sse2(const Strip&, const Strip&, std::size_t, double, Cuts&);
void cut_cells_avx2(const Strip&, const Strip&, std::size_t, double, Cuts&);
void cut_cells_avx512(const Strip&, const Strip&, std::size_t, double, Cuts&);
void check_row_sse2(const Strip&, const Strip&, const RowPlaces&, std::size_t, RowErrors&);
void check_row_avx2(const Strip&, const Strip&, const RowPlaces&, std::size_t, RowErrors&);
void check_row_avx512(const Strip&, const Strip&, const RowPlaces&, std::size_t, RowErrors&);

CutCells cell_loop(CpuLevel level) {
  constexpr std::array kLevels = {cut_cells_sse2, cut_cells_avx2, cut_cells_avx512};
  return kLevels[static_cast<std::size_t>(level)];
}

CheckRow check_loop(CpuLevel level) {
  constexpr std::array kLevels = {check_row_sse2, check_row_avx2, check_row_avx512};
  return kLevels[static_cast<std::size_t>(level)];
}

}  // namespace saddle
