// Lines of jumps that go through a leaf side by side, told from where they cross the leaf's sides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// A jump on a side of a leaf, on the way around the leaf.
struct JumpCrossing {
  std::uint32_t before, after;  ///< the vertices beside it
  std::size_t corner;           ///< number of the vertex of the cell polygon before it
  std::size_t side;             ///< number of the leaf's side, 0 to 3
};

/// Two or more lines of jumps that go through a leaf and do not meet in it. Lines go from one side
/// of the leaf to another. If they cross two or three of its sides, the numbers of crossings on
/// these say which belong together.
class JumpLines {
 public:
  /// Finds none in a leaf that other features cross, too.
  JumpLines(const Leaf& leaf, const CellTree& tree);

  /// How many go through the leaf; 0 if their crossings do not belong together.
  std::size_t count() const { return partners_.size() / 2; }
  /// Whether each goes from the same side to the same other one.
  bool cross_two_sides() const { return cross_two_sides_; }
  /// Whether a side of the leaf has several jumps as one feature.
  bool have_strips() const { return have_strips_; }

  /// All jumps on the sides of the leaf.
  const std::vector<JumpCrossing>& crossings() const { return crossings_; }
  /// The number of the crossing at the other end of a line.
  std::size_t partner(std::size_t crossing) const { return partners_[crossing]; }

 private:
  void join();
  bool is_plausible(const CellTree& tree) const;

  std::vector<JumpCrossing> crossings_;
  std::vector<std::size_t> partners_;
  bool cross_two_sides_ = false;
  bool have_strips_ = false;
};

}  // namespace saddle
