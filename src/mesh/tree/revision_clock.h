// Revisions of a cell tree, and the root cells that changed in each.
#pragma once

#include <cstdint>

#include "mesh/tree/cell_marks.h"

namespace saddle {

/// Tells whether the cell polygon of a leaf may have changed since a revision. The unit is a root
/// cell: a change in one counts for all of its leaves.
class RevisionClock {
 public:
  explicit RevisionClock(const Grid& grid) : changed_(grid) {}

  /// Before all revisions: everything has changed since.
  static constexpr std::uint32_t kNever = 0;

  /// Begins a revision: changes from here on are later than those before.
  std::uint32_t next() { return ++now_; }
  /// Something at a place, in units, changes: a vertex goes into use, becomes singular or one point
  /// with others, or a side there is cut.
  void mark(const dvec2& place) { changed_.add(place, now_); }
  bool has_changed(const Leaf& leaf, std::uint32_t since) const {
    return changed_.of(leaf) >= since;
  }

 private:
  CellMarks changed_;  // the last revision that changed a root cell
  std::uint32_t now_ = 1;
};

}  // namespace saddle
