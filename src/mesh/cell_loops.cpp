#include "mesh/cell_loops.h"

namespace saddle {

// One copy of cut_cells.cpp each.
void cut_cells_sse2(const Strip&, const Strip&, std::size_t, double, Cuts&);
void cut_cells_avx2(const Strip&, const Strip&, std::size_t, double, Cuts&);
void cut_cells_avx512(const Strip&, const Strip&, std::size_t, double, Cuts&);

CutCells cell_loop(CpuLevel level) {
  switch (level) {
    case CpuLevel::Sse2:
      return cut_cells_sse2;
    case CpuLevel::Avx2:
      return cut_cells_avx2;
    case CpuLevel::Avx512:
      return cut_cells_avx512;
  }
  return cut_cells_sse2;
}

}  // namespace saddle
