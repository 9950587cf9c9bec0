// Where texts go in a panel of points and curves so that they cover little of it.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace saddle {

/// An upright rectangle, in units of the picture, y up.
struct Rectangle {
  dvec2 low;
  dvec2 high;
};

/// Finds places one after the other, away from points, curves and texts that have one.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Rectangle& panel) : panel_(panel) {}

  /// Adds a curve that texts should not cover.
  void avoid_curve(const std::vector<dvec2>& points);

  /// The lower left corner of a text of that size beside one of the anchors, of which the first are
  /// preferred; taken from then on.
  dvec2 place(const std::vector<dvec2>& anchors, dvec2 size);

 private:
  double cost(const Rectangle& text) const;

  Rectangle panel_;
  std::vector<dvec2> obstacles_;
  std::vector<Rectangle> texts_;
};

}  // namespace saddle
