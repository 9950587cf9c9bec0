#include "study/extremes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"
#include "study/climb.h"
#include "surface/conditioning.h"
#include "surface/curvature_enclosure.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// kWellConditioned for values of a sequence, of which only the growth matters.
constexpr double kRoughlyConditioned = 1e-7;
/// A Gauss curvature below this part of the squared mean one is a difference of rounding errors.
constexpr double kKnownGauss = 1e-9;

/// Boxes that may be bounded: some milliseconds.
constexpr std::size_t kMostBoxes = 3600;
/// Bounds this close to a value that was found, as a part of the values' size, are not refined.
constexpr double kClose = 0.01;
/// In each round those boxes are halved whose bounds exceed the found values by at least this part
/// of the largest excess.
constexpr double kWorstExcess = 0.25;
/// Halvings of a box without bounds, both ways taken together: 128 boxes along a singular line.
constexpr int kEndlessHalvings = 14;

/// Curvatures times the diagonal that have no bounds: such a radius is within the rounding of
/// coordinates.
constexpr double kLargestCurvature = 1e16;

/// Boxes without bounds from which a singular place is sought, for each of three ways to choose.
constexpr std::size_t kSeeds = 6;
/// Halvings of such a box: its sides come to 2^-50 of the ranges.
constexpr int kSeedHalvings = 100;
/// A search that multiplies the best sample's value by this has climbed toward a singular place.
constexpr double kClimbed = 1.25;
/// Sequences approach a place from 2^-3 to 2^-20 of the ranges, far more than 2^-50.
constexpr int kWidestExponent = 3;
constexpr int kClosestExponent = 20;
/// A sequence diverges if its last values grow each time, by increments that do not shrink below
/// this part of the last one, and all together by this part of the first of them. 1/t^0.1 and ln(t)
/// do; a value that is off by t^0.1 or more does not.
constexpr std::ptrdiff_t kLastValues = 10;
constexpr double kIncrement = 0.95;
constexpr double kGrowth = 0.5;

constexpr std::array<dvec2, 12> kApproaches = {
    dvec2(1, 0),  dvec2(1, 1),  dvec2(0, 1),   dvec2(-1, 1),   dvec2(-1, 0),    dvec2(-1, -1),
    dvec2(0, -1), dvec2(1, -1), dvec2(1, 0.6), dvec2(-0.6, 1), dvec2(-1, -0.6), dvec2(0.6, -1)};

using Values = std::array<double, kQuantities>;

constexpr Values kNoValues = {kNan, kNan, kNan, kNan, kNan};

/// The growing end of a sequence of values diverges.
bool diverges(std::span<const double> values, double sign) {
  if (std::ssize(values) < kLastValues) return false;
  const auto last = values.last(kLastValues);
  double before = 0;
  for (std::size_t k = 1; k < last.size(); ++k) {
    const double increment = sign * (last[k] - last[k - 1]);
    if (!(increment > 0) || increment < kIncrement * before) return false;
    before = increment;
  }
  return sign * (last.back() - last.front()) > kGrowth * std::fabs(last.front());
}

struct BoundedBox {
  ParameterBox box;
  std::array<Interval, kQuantities> bounds;
  Values middle;
  int halvings = 0;
};

class ExtremesSearch {
 public:
  ExtremesSearch(const Surface& surface, const std::optional<Bounds>& within, double share,
                 unsigned threads)
      : surface_(surface),
        within_(within),
        most_boxes_(static_cast<std::size_t>(share * kMostBoxes)),
        threads_(threads),
        enclosure_(surface) {}

  ValueRanges run(std::span<const dvec2> places) {
    const std::vector<SurfacePoint> points = evaluate(surface_, places, threads_);
    usual_u_ = usual_length(points, &SurfacePoint::r_u);
    usual_v_ = usual_length(points, &SurfacePoint::r_v);
    Bounds extents;
    for (const SurfacePoint& p : points) {
      if (is_finite(p.position)) extents.add(p.position);
    }
    diagonal_ = extents.diagonal();
    take(places, values(places, kWellConditioned));
    branch_and_bound();
    climb_from_best();
    find_divergence();
    return ranges_;
  }

 private:
  std::vector<Values> values(std::span<const dvec2> uv, double conditioned) const {
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
    const std::vector<Curvature> curvatures = evaluate_curvature(surface_, uv, threads_);
    const double shortest = conditioned < kWellConditioned ? 0 : kShortTangent;
    std::vector<Values> result(uv.size(), kNoValues);
    for (std::size_t k = 0; k < uv.size(); ++k) {
      const SurfacePoint& p = points[k];
      if (!is_finite(p.position) || (within_ && !within_->contains(p.position))) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result[k][axis] = p.position[static_cast<int>(axis)];
      }
      const double size_u = safe_length(p.r_u);
      const double size_v = safe_length(p.r_v);
      const dvec3 across = glm::cross(p.r_u / size_u, p.r_v / size_v);
      const bool usable = glm::length(across) > conditioned && size_u >= shortest * usual_u_ &&
                          size_v >= shortest * usual_v_;
      if (!usable || !std::isfinite(curvatures[k].gauss) || !std::isfinite(curvatures[k].mean)) {
        continue;
      }
      result[k][kMean] = curvatures[k].mean;
      const double least = kKnownGauss * curvatures[k].mean * curvatures[k].mean;
      const bool is_known =
          conditioned == kWellConditioned || std::fabs(curvatures[k].gauss) > least;
      result[k][kGauss] = is_known ? curvatures[k].gauss : kNan;
    }
    return result;
  }

  /// Adds samples to the ranges.
  void take(std::span<const dvec2> uv, const std::vector<Values>& samples) {
    for (std::size_t k = 0; k < uv.size(); ++k) {
      for (std::size_t q = 0; q < kQuantities; ++q) {
        const double x = samples[k][q];
        if (x < ranges_[q].low) lowest_[q] = {uv[k], ranges_[q].low = x};
        if (x > ranges_[q].high) highest_[q] = {uv[k], ranges_[q].high = x};
      }
    }
  }

  /// The sizes that excesses are compared with. A Gauss curvature is the product of two.
  Values sizes() const {
    const auto size = [](const ValueRange& range) {
      return range.empty() ? 0 : std::max(std::fabs(range.low), std::fabs(range.high));
    };
    Values result;
    result[kX] = result[kY] = result[kZ] = diagonal_;
    result[kMean] =
        std::max({size(ranges_[kMean]), std::sqrt(size(ranges_[kGauss])), kClose / diagonal_});
    result[kGauss] = std::max(size(ranges_[kGauss]), result[kMean] * result[kMean]);
    return result;
  }

  bool is_outside(const std::array<Interval, kQuantities>& bounds) const {
    if (!within_) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<int>(axis);
      if (bounds[axis].high < within_->low[k] || bounds[axis].low > within_->high[k]) return true;
    }
    return false;
  }

  std::array<Interval, kQuantities> enclose(const ParameterBox& box) {
    const CurvatureBounds found = enclosure_.enclose(box);
    return {found.position[0], found.position[1], found.position[2], found.gauss, found.mean};
  }

  bool is_endless(const std::array<Interval, kQuantities>& bounds, std::size_t q) const {
    const Interval& b = bounds[q];
    return b.low <= b.high && !(std::max(-b.low, b.high) <= largest_[q]);
  }

  bool has_endless(const std::array<Interval, kQuantities>& bounds) const {
    return is_endless(bounds, kGauss) || is_endless(bounds, kMean);
  }

  /// By how much finite bounds exceed the found values, at the most.
  double excess(const BoundedBox& part, const Values& sizes) const {
    double most = 0;
    for (std::size_t q = 0; q < kQuantities; ++q) {
      const Interval& bounds = part.bounds[q];
      if (!(bounds.low <= bounds.high) || is_endless(part.bounds, q)) continue;
      const double over = std::max(bounds.high - ranges_[q].high, ranges_[q].low - bounds.low);
      most = std::max(most, over / sizes[q]);
    }
    return most;
  }

  /// Bounds and samples the halves of some parts.
  std::vector<BoundedBox> halves(const std::vector<BoundedBox>& parts) {
    std::vector<BoundedBox> result;
    std::vector<dvec2> middles;
    for (const BoundedBox& part : parts) {
      for (const ParameterBox& box : halves_of(part.box, part.halvings % 2)) {
        BoundedBox half = {box, enclose(box), kNoValues, part.halvings + 1};
        ++boxes_;
        if (half.bounds[kX].defined == Defined::No || is_outside(half.bounds)) continue;
        middles.push_back(box.middle());
        result.push_back(half);
      }
    }
    const std::vector<Values> samples = values(middles, kWellConditioned);
    take(middles, samples);
    for (std::size_t k = 0; k < result.size(); ++k) result[k].middle = samples[k];
    return result;
  }

  void branch_and_bound() {
    largest_.fill(std::numeric_limits<double>::max());
    largest_[kMean] = kLargestCurvature / diagonal_;
    largest_[kGauss] = largest_[kMean] * largest_[kMean];
    BoundedBox whole = {box_of(surface_.domain), {}, kNoValues, 0};
    whole.bounds = enclose(whole.box);
    std::vector<BoundedBox> parts = {whole};
    while (boxes_ < most_boxes_) {
      std::vector<BoundedBox> worst = take_worst(parts);
      if (worst.empty()) break;
      std::ranges::move(halves(worst), std::back_inserter(parts));
    }
    for (std::size_t q = 0; q < kQuantities; ++q) {
      for (const BoundedBox& part : parts) {
        const Extremes bounds = {part.bounds[q].low, part.bounds[q].high};
        if (bounds.empty()) continue;
        ranges_[q].bounds.add(is_endless(part.bounds, q) ? Extremes{-kInfinity, kInfinity}
                                                         : bounds);
      }
    }
    std::ranges::copy_if(parts, std::back_inserter(endless_),
                         [this](const BoundedBox& part) { return has_endless(part.bounds); });
  }

  std::vector<BoundedBox> take_worst(std::vector<BoundedBox>& parts) const {
    const Values scale = sizes();
    std::vector<double> excesses;
    double most = kClose;
    for (const BoundedBox& part : parts) {
      excesses.push_back(excess(part, scale));
      most = std::max(most, excesses.back());
    }
    std::vector<BoundedBox> worst;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool is_bad = excesses[k] > std::max(kClose, kWorstExcess * most) ||
                          (has_endless(parts[k].bounds) && parts[k].halvings < kEndlessHalvings);
      if (is_bad && boxes_ + 2 * worst.size() < most_boxes_) {
        worst.push_back(parts[k]);
      } else {
        parts[kept++] = parts[k];
      }
    }
    parts.resize(kept);
    return worst;
  }

  void climb_from_best() {
    for (std::size_t q = 0; q < kQuantities; ++q) {
      if (ranges_[q].empty()) continue;
      for (const double sign : {1.0, -1.0}) {
        const Peak& best = sign > 0 ? highest_[q] : lowest_[q];
        const ValuesAt value = [&](std::span<const dvec2> uv) {
          std::vector<double> numbers;
          for (const Values& sample : values(uv, kWellConditioned)) {
            numbers.push_back(sign * sample[q]);
          }
          return numbers;
        };
        const Peak peak = climb(surface_.domain, {best.uv, sign * best.value}, value);
        ranges_[q].add(sign * peak.value);
        const bool has_climbed = std::fabs(peak.value) > kClimbed * std::fabs(best.value);
        if (q >= kGauss && has_climbed) ends_.push_back(worst_conditioned(peak.uv));
      }
    }
  }

  /// The place of the worst conditioned tangents that a search from `start` on finds.
  dvec2 worst_conditioned(const dvec2& start) const {
    const ValuesAt value = [this](std::span<const dvec2> uv) {
      std::vector<double> numbers;
      for (const SurfacePoint& p : evaluate(surface_, uv, threads_)) {
        numbers.push_back(-safe_length(glm::cross(p.r_u, p.r_v)) / (usual_u_ * usual_v_));
      }
      return numbers;
    };
    const std::array<dvec2, 1> at = {start};
    return climb(surface_.domain, {start, value(at)[0]}, value).uv;
  }

  /// Boxes without bounds: those with the largest curvatures at their middles, and some others.
  std::vector<BoundedBox> seeds() const {
    std::vector<BoundedBox> chosen;
    for (const Quantity q : {kGauss, kMean}) {
      std::vector<BoundedBox> sorted = endless_;
      const auto size = [q](const BoundedBox& part) {
        return std::isnan(part.middle[q]) ? 0 : -std::fabs(part.middle[q]);
      };
      std::ranges::stable_sort(sorted, {}, size);
      sorted.resize(std::min(sorted.size(), kSeeds));
      std::ranges::move(sorted, std::back_inserter(chosen));
    }
    for (std::size_t k = 0; k < kSeeds && k < endless_.size(); ++k) {
      chosen.push_back(endless_[k * endless_.size() / std::min(kSeeds, endless_.size())]);
    }
    return chosen;
  }

  /// A place of a box in each neighbourhood of which curvatures have no bounds, or nothing.
  std::optional<dvec2> endless_place(BoundedBox part) {
    for (int k = 0; k < kSeedHalvings; ++k) {
      const auto parts = halves_of(part.box, part.halvings++ % 2);
      const auto found = std::ranges::find_if(
          parts, [this](const ParameterBox& half) { return has_endless(enclose(half)); });
      if (found == parts.end()) return std::nullopt;
      part.box = *found;
    }
    // A place that is a corner of boxes, such as 0, is found exactly.
    const auto& [low, high] = part.box;
    for (const dvec2& corner : {low, high, dvec2(low.x, high.y), dvec2(high.x, low.y)}) {
      if (has_endless(enclose({corner, corner}))) return corner;
    }
    return part.box.middle();
  }

  void find_divergence() {
    for (const BoundedBox& seed : seeds()) {
      const auto place = endless_place(seed);
      if (place && std::ranges::find(ends_, *place) == ends_.end()) ends_.push_back(*place);
    }
    for (const dvec2& end : ends_) {
      for (const dvec2& direction : kApproaches) approach(end, direction);
    }
  }

  void approach(const dvec2& end, const dvec2& direction) {
    const Domain& d = surface_.domain;
    const dvec2 size = direction * dvec2(d.u1 - d.u0, d.v1 - d.v0);
    std::vector<dvec2> uv;
    for (int k = kWidestExponent; k <= kClosestExponent; ++k) {
      const dvec2 place = end + std::ldexp(1.0, -k) * size;
      const bool is_inside = place.x >= std::min(d.u0, d.u1) && place.x <= std::max(d.u0, d.u1) &&
                             place.y >= std::min(d.v0, d.v1) && place.y <= std::max(d.v0, d.v1);
      if (is_inside) uv.push_back(place);
    }
    if (std::ssize(uv) < kLastValues) return;
    const std::vector<Values> samples = values(uv, kRoughlyConditioned);
    for (const Quantity q : {kGauss, kMean}) {
      std::vector<double> sequence;
      sequence.reserve(samples.size());
      for (const Values& sample : samples) sequence.push_back(sample[q]);
      while (!sequence.empty() && std::isnan(sequence.back())) sequence.pop_back();
      for (const double sign : {1.0, -1.0}) {
        if (!diverges(sequence, sign)) continue;
        ValueRange& range = ranges_[q];
        (sign > 0 ? range.high : range.low) = sign * kInfinity;
        std::optional<dvec2>& toward = sign > 0 ? range.grows_toward : range.falls_toward;
        if (!toward) toward = end;
      }
    }
  }

  const Surface& surface_;
  const std::optional<Bounds>& within_;
  std::size_t most_boxes_;
  unsigned threads_;
  CurvatureEnclosure enclosure_;
  double usual_u_ = 0;  // lengths of tangents
  double usual_v_ = 0;
  double diagonal_ = 0;
  Values largest_{};  // that bounds may be
  std::size_t boxes_ = 0;
  ValueRanges ranges_;
  std::array<Peak, kQuantities> lowest_{}, highest_{};
  std::vector<BoundedBox> endless_;
  std::vector<dvec2> ends_;  // places toward which values may diverge
};

}  // namespace

ValueRanges find_extremes(const Surface& surface, std::span<const dvec2> places,
                          const std::optional<Bounds>& within, double share, unsigned threads) {
  return ExtremesSearch(surface, within, share, threads).run(places);
}

}  // namespace saddle
