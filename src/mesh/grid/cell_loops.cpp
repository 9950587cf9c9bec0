#include "mesh/grid/cell_loops.h"

namespace saddle {

// A copy of cut_cells.cpp each.
void cut_cells_sse2(const Strip&, const Strip&, std::size_t, double, Cuts&);
void cut_cells_avx2(const Strip&, const Strip&, std::size_t, double, Cuts&);
void cut_cells_avx512(const Strip&, const Strip&, std::size_t, double, Cuts&);

CutCells cell_loop(CpuLevel level) {
  return of_level(level, cut_cells_sse2, cut_cells_avx2, cut_cells_avx512);
}

}  // namespace saddle
