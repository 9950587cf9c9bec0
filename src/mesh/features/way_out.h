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
  explicit WayOut(const Line& line, const std::optional<Bounds>& box = {});

  /// The place to look at next.
  dvec2 next() const;

  /// Takes the position at next(). Returns whether the way ends: there were no doubles between the
  /// ends, or less than `part` of it is left.
  bool narrow(const dvec2& place, const dvec3& position, double part);

  /// The last place that is known to be seen.
  const dvec2& last_seen() const { return line_[0]; }

 private:
  Line line_;
  std::optional<Bounds> box_;
  int axis_;                                     // along which the line is longer
  std::array<double, 2> beyond_ = {kNan, kNan};  // how far the ends are beyond the box
  bool is_first_known_ = false;                  // whether the first end has been looked at
  double width_ = 1;                             // what is left, in parts of the whole line
  double widest_ = 16;                           // what halving would have left four rounds before
};

/// The last places that are seen on ways, after so many rounds. Each round leaves half of a way or
/// less; but chords may be four rounds behind.
std::vector<dvec2> leave(const Surface& surface, std::vector<WayOut> ways, const Rounds& rounds);

}  // namespace saddle
