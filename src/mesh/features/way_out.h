// Where lines leave the part of a surface that is defined and within a box.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "base/numbers.h"
#include "mesh/features/bisect_together.h"

namespace saddle {

/// A line from a place that is seen, which is where the surface is defined and within a box, to one
/// that is not. A chord finds the face of the box that it crosses in a few rounds; elsewhere the
/// line is halved.
class WayOut {
 public:
  /// The way ends after so many looks, or once less of it is left than so many halvings leave.
  WayOut(const Line& line, int halvings, const std::optional<Bounds>& box);

  /// The place to look at next.
  dvec2 next() const;

  /// Takes the position at next(). Returns whether the way ends, at the latest where there are no
  /// doubles between its ends.
  bool narrow(const dvec2& place, const dvec3& position);

  /// The last place that is known to be seen.
  const dvec2& last_seen() const { return line_[0]; }

 private:
  Line line_;
  std::optional<Bounds> box_;
  int looks_left_;
  double part_;                                  // of the whole line, at which it ends
  int axis_;                                     // along which the line is longer
  std::array<double, 2> beyond_ = {kNan, kNan};  // how far the ends are beyond the box
  bool is_first_known_ = false;                  // whether the first end has been looked at
  double width_ = 1;                             // what is left, in parts of the whole line
  double widest_ = 16;                           // what halving would have left four rounds before
};

/// The last places that are seen on ways.
std::vector<dvec2> leave(const Surface& surface, std::span<const WayOut> ways, unsigned threads);

}  // namespace saddle
