#include "mesh/proof/landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/box_groups.h"
#include "mesh/proof/certify.h"
#include "mesh/proof/slivers.h"
#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Halvings after which a box whose samples show both sides of a feature is done: 1/128 of each
/// range. Cells are not much smaller.
constexpr int kSettledHalvings = 14;
/// In boxes: a hole whose edges are closer is measured from edge to edge.
constexpr double kThinHole = 4;
/// In differences of the other samples: the middle of a box that is farther from their mean shows
/// a jump or a bend.
constexpr double kStep = 0.2;
/// A group of boxes that is 16 times longer than wide lies along a line of constant u or v.
constexpr double kLong = 16;

/// Samples of a box, in shares of its sides: four beside the corners, and the middle. They avoid
/// dyadic places, at which formulas have values of their own, as sign(u) at 0, and the diagonals
/// through the corners of boxes, as of sign(u + v).
constexpr std::array<std::array<double, 2>, 5> kSamplesOfBox = {
    {{0.0417, 0.0731}, {0.9371, 0.0589}, {0.9523, 0.9277}, {0.0653, 0.9461}, {0.5129, 0.4873}}};

/// An open part of the domain.
struct OpenBox {
  ParameterBox box;
  bool is_bounded = false;  ///< points beside a pole are no landmarks
  std::uint32_t group = 0;  ///< of boxes that touched when boxes were first left out
};

class LandmarkSearch {
 public:
  LandmarkSearch(const Surface& surface, unsigned threads)
      : surface_(surface),
        threads_(threads),
        budget_(ProofBudget(surface.bounds).boxes_of_search()),
        enclosure_(surface, Bounded::Position),
        search_({{box_of(surface.domain)}}) {}

  Landmarks run() {
    while (!search_.open().empty()) {
      search_.test([this](OpenBox& open) { return test(open); });
      const bool is_full = search_.open().size() > (thinned_ ? kMostFollowed : kMostOpen);
      const bool is_last = budget_ == 0 || search_.depth() == 2 * kHalvingsToNearly;
      if (is_full || is_last || search_.depth() >= kSettledHalvings) settle(is_last);
      if (is_last) break;
      if (search_.open().size() > (thinned_ ? kMostFollowed : kMostOpen)) thin_out();
      search_.halve_in_turn();
    }
    return std::move(result_);
  }

 private:
  ProofOutcome test(OpenBox& open) {
    const ParameterBox& box = open.box;
    if (budget_ == 0) return ProofOutcome::Open;
    --budget_;
    const std::span<const Interval> position = enclosure_.enclose(box);
    if (least_defined(position) == Defined::No) {
      add_hole(box, rim_of_box(box.size()));
      return ProofOutcome::Refuted;
    }
    open.is_bounded = std::ranges::all_of(
        position, [](const Interval& a) { return std::isfinite(a.low) && std::isfinite(a.high); });
    return are_continuous(position) ? ProofOutcome::Proved : ProofOutcome::Open;
  }

  void add_hole(const ParameterBox& box, const HoleRim& rim) {
    if (holes_ == kMostOpen) return;
    ++holes_;
    result_.places.push_back({box.middle(), dvec3(std::numeric_limits<double>::quiet_NaN()),
                              box.size(), dvec2(0), dvec2(0), rim});
  }

  /// A box around an undefined place in which bounds prove the surface to be undefined. `size`: of
  /// the open box that holds the place.
  std::optional<ParameterBox> hole_around(const dvec2& uv, const dvec2& size) {
    dvec2 half = 0.5 * size;
    for (int k = 0; k < kHalvingsToSight && budget_ > 0; ++k) {
      half *= 0.5;
      --budget_;
      const ParameterBox around = {uv - half, uv + half};
      if (least_defined(enclosure_.enclose(around)) == Defined::No) return around;
    }
    return std::nullopt;
  }

  /// Adds holes at undefined places of open boxes, which have one size: from rim to rim where they
  /// are thinner than a few boxes. Larger ones hold such boxes.
  void add_holes(std::span<const dvec2> undefined, const dvec2& size) {
    const dvec2 range = box_of(surface_.domain).size();
    const dvec2 share = size / range;
    const dvec2 reach = kThinHole * std::max(share.x, share.y) * range;
    const auto thin = thin_holes(surface_, undefined, reach, threads_);
    for (std::size_t k = 0; k < undefined.size(); ++k) {
      const auto around = hole_around(thin[k] ? thin[k]->middle : undefined[k], size);
      if (around) add_hole(*around, thin[k] ? thin[k]->rim : rim_of_box(around->size()));
    }
  }

  /// Whether the surface is continuous inside of a box of the first level that settles: a jump
  /// along its edge stays there, and halvings show no more of it.
  bool is_continuous_inside(const ParameterBox& box) {
    if (search_.depth() != kSettledHalvings || budget_ == 0) return false;
    --budget_;
    const ParameterBox inside = {glm::mix(box.low, box.high, kSame),
                                 glm::mix(box.high, box.low, kSame)};
    return are_continuous(enclosure_.enclose(inside));
  }

  /// Ends the search in boxes whose samples show both sides of a feature, and in all boxes if this
  /// is the last level.
  void settle(bool is_last) {
    const std::vector<OpenBox>& open = search_.open();
    if (std::ranges::none_of(open, &OpenBox::is_bounded)) return;
    std::vector<dvec2> uv;
    for (const OpenBox& box : open) {
      for (const auto& [part_u, part_v] : kSamplesOfBox)
        uv.push_back(glm::mix(box.box.low, box.box.high, dvec2(part_u, part_v)));
    }
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
    std::vector<Sides> sides;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const std::size_t first = kSamplesOfBox.size() * k;
      sides.push_back(sides_of(std::span(points).subspan(first, kSamplesOfBox.size()), first));
    }
    drop_slopes(uv, points, sides);
    drop_slivers(uv, points, sides);
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (!open[k].is_bounded) sides[k] = {};
    }
    const std::vector<dvec2> across = lines_across();
    const auto add = [&](std::size_t k, std::size_t sample) {
      const SurfacePoint& point = points[sample];
      result_.places.push_back({uv[sample],
                                point.position,
                                dvec2(0),
                                across[k],
                                {glm::length(point.r_u), glm::length(point.r_v)}});
    };
    std::vector<dvec2> undefined;
    const dvec2 size = open.front().box.size();
    std::size_t k = 0;
    search_.test([&](const OpenBox& box) {
      const Sides& of = sides[k];
      const bool is_done = of.is_shown() || is_last || is_continuous_inside(box.box);
      if (of.is_pole) {
        result_.highest_step = std::numeric_limits<double>::infinity();
      } else {
        if (of.defined && is_done) {
          add(k, *of.defined);
          const auto& [low, high] = box.box;
          result_.around = {glm::min(result_.around.low, glm::min(low, high)),
                            glm::max(result_.around.high, glm::max(low, high))};
        }
        if (of.other) {
          add(k, *of.other);
          const double step =
              glm::distance(points[*of.defined].position, points[*of.other].position);
          result_.highest_step = std::max(result_.highest_step, step);
        }
        if (of.undefined) {
          result_.has_boundary = true;
          undefined.push_back(uv[*of.undefined]);
        }
      }
      ++k;
      return is_done ? ProofOutcome::Refuted : ProofOutcome::Open;
    });
    add_holes(undefined, size);
  }

  /// Samples of a box, by their numbers: on the two sides of a step, or of a boundary.
  struct Sides {
    std::optional<std::size_t> defined, other, undefined;
    bool is_pole = false;  ///< the step grows as it is bisected
    bool is_shown() const { return other || undefined; }
  };
  /// `first`: number of the first of the points.
  static Sides sides_of(std::span<const SurfacePoint> points, std::size_t first) {
    Sides sides;
    std::optional<std::size_t> undefined;
    for (std::size_t k = 0; k < points.size(); ++k)
      (is_finite(points[k].position) ? sides.defined : undefined) = first + k;
    if (!sides.defined) return sides;
    sides.undefined = undefined;
    if (undefined) return sides;
    const auto distance = [&](std::size_t a, std::size_t b) {
      return glm::distance(points[a].position, points[b].position);
    };
    std::pair<std::size_t, std::size_t> farthest = {0, 1};
    dvec3 mean(0);
    for (std::size_t a = 0; a < points.size(); ++a) {
      if (a + 1 < points.size()) mean += points[a].position / 4.0;
      for (std::size_t b = 0; b < a; ++b) {
        if (distance(a, b) > distance(farthest.first, farthest.second)) farthest = {b, a};
      }
    }
    const double width = distance(farthest.first, farthest.second);
    if (glm::distance(points.back().position, mean) > kStep * width) {
      sides.defined = first + farthest.first;
      sides.other = first + farthest.second;
    }
    return sides;
  }

  /// Lines between the two sides of steps, and the boxes that these are in.
  struct Steps {
    std::vector<std::size_t> boxes;
    std::vector<SheetStep> lines;
  };
  static Steps steps_of(std::span<const dvec2> uv, std::span<const SurfacePoint> points,
                        std::span<const Sides> sides) {
    Steps steps;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (!sides[k].other) continue;
      const std::size_t a = *sides[k].defined;
      const std::size_t b = *sides[k].other;
      steps.boxes.push_back(k);
      steps.lines.push_back({{uv[a], uv[b]}, {points[a].position, points[b].position}});
    }
    return steps;
  }

  /// Bisects the lines between the sides of steps, and drops the steps that shrink with them. One
  /// that stays as high, within kStays, is no slope or cusp of the size of its box. One that grows
  /// is a pole: points beside it are no landmarks.
  void drop_slopes(std::span<const dvec2> uv, std::span<const SurfacePoint> points,
                   std::span<Sides> sides) const {
    auto [boxes, steps] = steps_of(uv, points, sides);
    if (steps.empty()) return;
    for (int k = 0; k < kHalvingsToNearly; ++k) {
      std::vector<dvec2> middles;
      middles.reserve(steps.size());
      for (const SheetStep& step : steps) middles.push_back(0.5 * (step.line[0] + step.line[1]));
      const std::vector<SurfacePoint> found = evaluate(surface_, middles, threads_);
      for (std::size_t i = 0; i < steps.size(); ++i) {
        SheetStep& step = steps[i];
        const dvec3& p = found[i].position;
        const std::size_t nearer =
            glm::distance(step.at_ends[0], p) < glm::distance(p, step.at_ends[1]) ? 0 : 1;
        step.line[nearer] = middles[i];
        step.at_ends[nearer] = p;
      }
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
      Sides& of = sides[boxes[i]];
      const double width = glm::distance(points[*of.defined].position, points[*of.other].position);
      const double left = glm::distance(steps[i].at_ends[0], steps[i].at_ends[1]);
      of.is_pole = !(left <= kStays * width);  // true for NaN
      if (left <= width / kStays) of.other.reset();
    }
  }

  /// Drops the sides of steps that are in slivers.
  void drop_slivers(std::span<const dvec2> uv, std::span<const SurfacePoint> points,
                    std::span<Sides> sides) const {
    const auto [boxes, steps] = steps_of(uv, points, sides);
    const auto in_slivers = are_in_slivers(surface_, steps, threads_);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      Sides& of = sides[boxes[i]];
      if (in_slivers[i][0]) of.defined = of.other;
      if (in_slivers[i][0] || in_slivers[i][1]) of.other.reset();
    }
  }

  /// The groups of the open boxes.
  std::vector<std::uint32_t> groups() const {
    std::vector<std::uint32_t> groups;
    std::vector<ParameterBox> boxes;
    for (const OpenBox& open : search_.open()) {
      groups.push_back(open.group);
      boxes.push_back(open.box);
    }
    return thinned_ ? groups : groups_of(boxes);
  }

  /// Landmark::across of the open boxes, by the shapes of their groups.
  std::vector<dvec2> lines_across() const {
    const std::vector<OpenBox>& open = search_.open();
    const std::vector<std::uint32_t> group = groups();
    std::map<std::uint32_t, ParameterBox> extents;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const auto& [low, high] = open[k].box;
      ParameterBox& extent = extents.try_emplace(group[k], open[k].box).first->second;
      extent = {glm::min(extent.low, glm::min(low, high)),
                glm::max(extent.high, glm::max(low, high))};
    }
    std::vector<dvec2> across;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const dvec2 boxes = glm::round(extents[group[k]].size() / open[k].box.size());
      across.push_back(
          {boxes.y >= kLong * boxes.x ? 1.0 : 0.0, boxes.x >= kLong * boxes.y ? 1.0 : 0.0});
    }
    return across;
  }

  /// Keeps as many boxes of each group, evenly spread over it: a small feature loses none of its
  /// boxes to a long curve.
  void thin_out() {
    std::vector<OpenBox>& open = search_.open();
    if (!thinned_) {
      const std::vector<std::uint32_t> group = groups();
      for (std::size_t k = 0; k < open.size(); ++k) open[k].group = group[k];
      thinned_ = true;
    }
    std::ranges::stable_sort(open, {}, &OpenBox::group);
    std::vector<std::size_t> firsts;
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (k == 0 || open[k].group != open[k - 1].group) firsts.push_back(k);
    }
    firsts.push_back(open.size());
    const std::size_t groups = firsts.size() - 1;
    // An even share of the groups is followed where they are too many.
    const std::size_t step = (groups + kMostFollowed - 1) / kMostFollowed;
    const std::size_t most = std::max<std::size_t>(1, kMostFollowed * step / groups);
    std::vector<OpenBox> kept;
    for (std::size_t g = 0; g < groups; g += step) {
      const std::size_t size = firsts[g + 1] - firsts[g];
      const std::size_t count = std::min(size, most);
      // One anywhere in each stretch: along a diagonal every third box alone is on it.
      for (std::size_t k = 0; k < count; ++k) {
        const double place = (static_cast<double>(k) + random_unit(k)) / static_cast<double>(count);
        kept.push_back(
            open[firsts[g] + static_cast<std::size_t>(place * static_cast<double>(size))]);
      }
    }
    open = std::move(kept);
  }

  const Surface& surface_;
  unsigned threads_;
  std::size_t budget_;
  SurfaceEnclosure enclosure_;
  BoxSubdivision<OpenBox> search_;
  bool thinned_ = false;
  std::size_t holes_ = 0;
  Landmarks result_;
};

}  // namespace

Landmarks find_landmarks(const Surface& surface, unsigned threads) {
  return LandmarkSearch(surface, threads).run();
}

}  // namespace saddle
