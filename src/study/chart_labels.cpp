#include "study/chart_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace saddle {
namespace {

constexpr double kSpacing = 4;  ///< of obstacles along a curve
constexpr double kGap = 9;      ///< between an anchor and its text
/// A text that finds no room beside its anchor goes farther away, up to so many heights.
constexpr int kRings = 4;
constexpr double kFarther = 2;     ///< what each height is worse
constexpr double kLater = 0.4;     ///< what each anchor is worse than the one before
constexpr double kOutside = 1e6;   ///< per unit of length that a text sticks out
constexpr double kOnText = 20;     ///< per unit of length of an overlap with another text
constexpr double kOnObstacle = 3;  ///< for each

/// Directions from an anchor to its text, in half sizes of the text.
constexpr std::array<dvec2, 8> kSides = {dvec2(1, 0),  dvec2(-1, 0),  dvec2(1, 1), dvec2(1, -1),
                                         dvec2(-1, 1), dvec2(-1, -1), dvec2(0, 1), dvec2(0, -1)};

double overlap(double low_a, double high_a, double low_b, double high_b) {
  return std::max(0.0, std::min(high_a, high_b) - std::max(low_a, low_b));
}

}  // namespace

void LabelPlacer::avoid_curve(const std::vector<dvec2>& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const dvec2 next = points[std::min(k + 1, points.size() - 1)];
    const int steps = std::max(1, static_cast<int>(glm::distance(points[k], next) / kSpacing));
    for (int i = 0; i < steps; ++i) {
      obstacles_.push_back(points[k] + (next - points[k]) * (static_cast<double>(i) / steps));
    }
  }
}

double LabelPlacer::cost(const Rectangle& text) const {
  double sum = 0;
  for (int k = 0; k < 2; ++k) {
    sum += kOutside * std::max(0.0, panel_.low[k] - text.low[k]);
    sum += kOutside * std::max(0.0, text.high[k] - panel_.high[k]);
  }
  for (const Rectangle& other : texts_) {
    const double w = overlap(text.low.x, text.high.x, other.low.x, other.high.x);
    const double h = overlap(text.low.y, text.high.y, other.low.y, other.high.y);
    if (w > 0 && h > 0) sum += kOnText * (w + h);
  }
  for (const dvec2& p : obstacles_) {
    const bool inside =
        text.low.x <= p.x && p.x <= text.high.x && text.low.y <= p.y && p.y <= text.high.y;
    if (inside) sum += kOnObstacle;
  }
  return sum;
}

dvec2 LabelPlacer::place(const std::vector<dvec2>& anchors, dvec2 size) {
  Rectangle best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    for (std::size_t way = 0; way < kRings * kSides.size(); ++way) {
      const std::size_t rings = way / kSides.size();
      const auto ring = static_cast<double>(rings);
      const dvec2 side = kSides[way % kSides.size()];
      const dvec2 middle =
          anchors[k] + side * (0.5 * size + kGap) + dvec2(0, ring * size.y * side.y);
      const Rectangle text = {middle - 0.5 * size, middle + 0.5 * size};
      const double worse = cost(text) + kLater * static_cast<double>(k) + kFarther * ring +
                           0.1 * kLater * static_cast<double>(way % kSides.size());
      if (worse >= least) continue;
      least = worse;
      best = text;
    }
  }
  texts_.push_back(best);
  return best.low;
}

}  // namespace saddle
