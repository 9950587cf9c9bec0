// The work of proofs, limited by that of their mesh.
#pragma once

#include <cstddef>
#include <memory>

#include "base/run_limits.h"
#include "surface/surface.h"

namespace saddle {

/// The work that proofs may still take, in places (mesh/sizing/effort.h).
class ProofBudget {
 public:
  /// `share`: of the work that does not grow with the mesh.
  explicit ProofBudget(const Tape& bounds, double share = 1);

  /// Allows the work that a mesh of this effort is worth, for all proofs together.
  void allow_for(std::size_t effort);
  /// Whether no box is left for a level of boxes, no point of the surface, or no time; a short one
  /// may take more.
  bool is_spent(bool is_short) const {
    return spent_ >= (is_short ? most_of_short_ : most_) || (count_ && count_->is_used_up()) ||
           shortage() == Shortage::Time;
  }
  /// The boxes of a level that is_spent() leaves, if they take no points; none if no time is left.
  std::size_t boxes_left(bool is_short) const;
  void take_boxes(std::size_t count);
  void take_points(std::size_t count);
  /// Nodes of a tree of triangles; these have as much work to themselves as short levels.
  void take_visits(std::size_t count) { visited_ += count; }
  bool may_visit() const;

  /// Places that a box takes.
  std::size_t of_box() const { return of_box_; }
  /// The boxes that were taken.
  std::size_t boxes() const { return boxes_; }
  /// The boxes of a search for single places, up to 4,000.
  std::size_t boxes_of_search() const { return boxes_of_search_; }

 private:
  std::shared_ptr<const PointCount> count_;  ///< the tape's
  double share_;
  std::size_t of_box_, boxes_of_search_;
  std::size_t most_ = 0, most_of_short_ = 0;
  std::size_t spent_ = 0;
  std::size_t visited_ = 0;
  std::size_t boxes_ = 0;
};

}  // namespace saddle
