// Patches of the interval proof, and blocks of cells of the root grid that hold them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers.h"
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
  /// The number of the root cell that holds a patch; u is inner.
  std::function<std::size_t(std::size_t)> root_cell;

  std::size_t size() const { return count; }
  Patch operator[](std::size_t number) const { return make(number); }
};

/// Lines of the root grid, whose cells are numbered with u inner.
struct RootLines {
  std::span<const double> u, v;
};

/// Cells [first, end) of the root grid.
struct RootCells {
  std::uint32_t first_u, end_u;
  std::uint32_t first_v, end_v;

  bool is_one() const { return end_u - first_u == 1 && end_v - first_v == 1; }
  ParameterBox box_in(const RootLines& root) const {
    return {{root.u[first_u], root.v[first_v]}, {root.u[end_u], root.v[end_v]}};
  }
};

inline RootCells all_cells(const RootLines& root) {
  return {0, static_cast<std::uint32_t>(root.u.size() - 1), 0,
          static_cast<std::uint32_t>(root.v.size() - 1)};
}

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

/// The largest size and the strictest tolerance of some patches.
struct Demand {
  dvec2 size{0};
  double allowed = kInfinity;

  void add(const Demand& other) {
    size = glm::max(size, other.size);
    allowed = std::min(allowed, other.allowed);
  }
  bool is_none() const { return size == dvec2(0); }
};

/// The patches of each cell of the root grid, and the demands that were added for them.
class DemandsOfCells {
 public:
  DemandsOfCells(const RootLines& root, const Patches& patches)
      : cells_u_(root.u.size() - 1),
        first_(cells_u_ * (root.v.size() - 1) + 1, 0),
        patches_(patches.size()) {
    sort_patches(patches);
    demands_.resize(first_.size() - 1);
  }

  std::size_t count() const { return demands_.size(); }
  std::span<const std::uint32_t> patches_of(std::size_t cell) const {
    return std::span(patches_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }
  std::span<const std::uint32_t> patches_of(std::size_t i, std::size_t j) const {
    return patches_of(j * cells_u_ + i);
  }
  void add(std::size_t cell, const Demand& demand) { demands_[cell].add(demand); }
  Demand demand(const RootCells& cells) const {
    Demand demand;
    for (std::size_t j = cells.first_v; j < cells.end_v; ++j) {
      for (std::size_t i = cells.first_u; i < cells.end_u; ++i)
        demand.add(demands_[j * cells_u_ + i]);
    }
    return demand;
  }

 private:
  void sort_patches(const Patches& patches) {
    std::vector<std::uint32_t> cell_of(patches.size());
    for (std::size_t k = 0; k < patches.size(); ++k) {
      cell_of[k] = static_cast<std::uint32_t>(patches.root_cell(k));
      ++first_[cell_of[k]];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    // From the ends of the cells' ranges back to their beginnings.
    for (std::size_t k = patches.size(); k-- > 0;)
      patches_[--first_[cell_of[k]]] = static_cast<std::uint32_t>(k);
  }

  std::size_t cells_u_;
  std::vector<Demand> demands_;
  std::vector<std::uint32_t> first_;  // in patches_, of each cell and past the last
  std::vector<std::uint32_t> patches_;
};

}  // namespace saddle
