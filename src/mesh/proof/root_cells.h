// Patches of the interval proof, and blocks of cells of the root grid that hold them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "mesh/model/proof_gap.h"
#include "surface/parameter_box.h"

namespace saddle {

/// Values of u (axis 0) or v (axis 1), mostly neighbouring doubles, between which a surface jumps.
struct JumpLine {
  int axis;
  double below, above;
};

/// A box of parameters and what its triangles must keep.
struct Patch {
  ParameterBox box;
  double allowed;                   ///< distance from the surface, in units of length
  std::size_t root_cell;            ///< number of the root cell that holds the box; u is inner
  std::optional<GapReason> cut_by;  ///< feature in the box: no proof is tried
  /// The triangles do not cover the box with corners in it: distances are measured everywhere.
  bool is_measured = false;
  std::optional<JumpLine> jump_line =
      {};  ///< all that cuts it: both sides have proofs of their own
};

/// Patches by their numbers. They are made when asked for: all of a fine mesh would take as much
/// memory as the mesh.
struct Patches {
  std::size_t count;
  std::function<Patch(std::size_t)> make;

  std::size_t size() const { return count; }
  Patch operator[](std::size_t number) const { return make(number); }
};

/// Lines of the root grid, whose cells are numbered with u inner.
struct RootLines {
  std::span<const double> u, v;
};

/// Cells [first, end) of the root grid.
struct RootCells {
  std::size_t first_u, end_u;
  std::size_t first_v, end_v;

  bool is_one() const { return end_u - first_u == 1 && end_v - first_v == 1; }
  ParameterBox box_in(const RootLines& root) const {
    return {{root.u[first_u], root.v[first_v]}, {root.u[end_u], root.v[end_v]}};
  }
};

/// Halves cells across the side of more cells.
inline void halve_cells(const RootCells& cells, std::vector<RootCells>& to) {
  RootCells a = cells;
  RootCells b = cells;
  if (cells.end_u - cells.first_u >= cells.end_v - cells.first_v) {
    a.end_u = b.first_u = (cells.first_u + cells.end_u) / 2;
  } else {
    a.end_v = b.first_v = (cells.first_v + cells.end_v) / 2;
  }
  to.push_back(a);
  to.push_back(b);
}

/// The patches of each cell of the root grid.
class PatchesOfCells {
 public:
  PatchesOfCells(std::size_t cells, const Patches& patches)
      : first_(cells + 1, 0), patches_(patches.size()) {
    std::vector<std::uint32_t> cell_of;
    for (std::size_t k = 0; k < patches.size(); ++k)
      cell_of.push_back(static_cast<std::uint32_t>(patches[k].root_cell));
    for (const std::uint32_t cell : cell_of) ++first_[cell + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < patches.size(); ++k) patches_[next[cell_of[k]]++] = k;
  }
  std::span<const std::uint32_t> of(std::size_t cell) const {
    return std::span(patches_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> patches_;
};

}  // namespace saddle
