#include "mesh/proof/certify.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/box_bounds.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// A level is short with at most a quarter as many boxes as there are patches. While a proof has no
/// gap, levels of up to kMaxBrokenDepth halvings count as short: they may complete it.
constexpr std::size_t kShort = 4;
/// Halvings of a patch where the surface may be undefined or jump, both ways taken together: 12
/// give 1/64 of each side. A level of at most kFewBoxes boxes goes on to kHalvingsOfSecondOrder
/// each way.
constexpr int kMaxBrokenDepth = 12;
constexpr std::size_t kFewBoxes = 100;
/// A level of root cells helps if one in 8 is proved. After one level that does not help, another
/// is not tested; after two in a row, two, and so on.
constexpr std::size_t kHopeless = 8;
/// In tolerances: a box is measured if the surface is no farther from its points, or without such
/// bounds if the sphere around its box in space is no larger. That leaves one for their distances.
constexpr double kReach = kProofFactor - 1;
/// A box is halved twice at once if its bound is more than 256 times too large.
constexpr double kHalvedTwice = 256;

/// Where the work ends, up to kInBatch patches are ranked by their bounds, and the worst places of
/// kFirstSearched of them are looked for, by halvings of each. Each of the two takes up to 5,000
/// places.
constexpr std::size_t kPlacesOfDescents = 5'000;

class Certifier {
 public:
  Certifier(const Surface& surface, const RootLines& root, const Patches& patches,
            const std::optional<Bounds>& clip, const MeasureBoxes& measure, ProofBudget& budget)
      : root_(root),
        cells_u_(root.u.size() - 1),
        cells_v_(root.v.size() - 1),
        patches_(patches),
        clip_(clip),
        measure_(measure),
        budget_(budget),
        enclosure_(surface, Bounded::SecondDerivatives),
        patches_of_(cells_u_ * cells_v_, patches) {
    result_.proved.assign(patches.size(), 1);
    result_.rough.assign(patches.size(), 0);
  }

  Certification run() {
    gather_demands();
    prove_cells();
    prove_parts();
    for (const auto& [patch, gap] : gaps_) {
      if (!is_refuted(patch)) result_.proof_gaps.push_back(gap);
    }
    for (std::uint32_t k = 0; k < refuted_.size(); ++k) {
      if (!is_refuted(k)) continue;
      const Patch patch = patches_[k];
      result_.proof_gaps.push_back(
          {patch.cut_by.value_or(GapReason::Wide), patch.box.low, patch.box.high});
    }
    return std::move(result_);
  }

 private:
  /// A part of a patch.
  struct Part {
    std::uint32_t patch;
    ParameterBox box;
    GapReason why = GapReason::Work;  ///< of the last box without a proof that held it
    /// Bounds over a box that holds it, narrow enough: only its points decide.
    std::optional<BoxBounds> known = {};
  };

  /// The largest size and the strictest tolerance of some patches.
  struct Demand {
    dvec2 size{0};
    double eps = kInfinity;

    void add(const Demand& other) {
      size = glm::max(size, other.size);
      eps = std::min(eps, other.eps);
    }
    bool is_none() const { return size == dvec2(0); }
  };
  Demand demand(const RootCells& cells) const {
    Demand demand;
    for (std::size_t j = cells.first_v; j < cells.end_v; ++j) {
      for (std::size_t i = cells.first_u; i < cells.end_u; ++i) {
        demand.add(of_cells_[cell(i, j)]);
      }
    }
    return demand;
  }
  void gather_demands() {
    of_cells_.resize(cells_u_ * cells_v_);
    for (std::size_t cell = 0; cell < of_cells_.size(); ++cell) {
      for (const std::uint32_t k : patches_of_.of(cell)) {
        const Patch patch = patches_[k];
        if (patch.cut_by) {
          if (!patch.jump_line || !append_sides_of_jump(k)) add_gap(*patch.cut_by, k, patch.box);
        } else if (patch.is_measured) {
          parts_.push_back({k, patch.box});
        } else {
          of_cells_[cell].add({patch.box.size(), patch.allowed});
        }
      }
    }
  }

  /// Makes the two sides of a jump parts_: from the double on at which bounds prove the surface to
  /// be continuous on both. Beside 0 doubles are closer than what tells jumps from slopes.
  bool append_sides_of_jump(std::uint32_t k) {
    const Patch patch = patches_[k];
    const auto& [axis, below, above] = *patch.jump_line;
    const auto& [low, high] = patch.box;
    const ParameterBox whole = {glm::min(low, high), glm::max(low, high)};
    for (const double cut :
         {above, std::nextafter(below, kInfinity), 0.0, std::nextafter(0.0, kInfinity)}) {
      if (!(below < cut && cut <= above)) continue;
      std::array<ParameterBox, 2> sides = {whole, whole};
      sides[0].high[axis] = std::nextafter(cut, -kInfinity);
      sides[1].low[axis] = cut;
      std::array<ParameterBox, 2> beside = sides;  // the jump
      beside[0].low[axis] = below;
      beside[1].high[axis] = above;
      if (bounds_over(beside[0]).broken || bounds_over(beside[1]).broken) continue;
      for (const ParameterBox& side : sides) parts_.push_back({k, side});
      return true;
    }
    return false;
  }

  BoxBounds bounds_over(const ParameterBox& box) {
    budget_.take_box();
    return BoxBounds(enclosure_.enclose(box));
  }

  /// Whether a bound of the distance from triangles is small enough. Notes it if so.
  bool is_proved(double arc, double allowed) {
    if (!(arc <= kProofFactor * allowed)) return false;  // true for NaN
    result_.bound = std::max(result_.bound, arc);
    return true;
  }

  bool is_unseen(const BoxBounds& bounds) const {
    return clip_ && !bounds.broken &&
           is_beyond(*clip_, std::array{bounds.hull.low, bounds.hull.high});
  }

  void add_gap(GapReason why, std::uint32_t patch, const ParameterBox& box) {
    gaps_.push_back({patch, {why, box.low, box.high}});
    result_.proved[patch] = 0;
  }

  /// Proves many cells of the root grid at a time. Patches of single cells without a proof become
  /// parts_.
  void prove_cells() {
    BoxSubdivision<RootCells> search({{0, cells_u_, 0, cells_v_}});
    int tested = 0;   // levels in a row of which little was proved
    int skipped = 0;  // levels since
    while (!search.open().empty()) {
      const std::size_t level = search.open().size();
      const bool is_tested = skipped >= tested;
      search.test([&](const RootCells& cells) { return prove(cells, is_tested); });
      const bool helps = kHopeless * (level - search.open().size()) >= level;
      if (is_tested) tested = helps ? 0 : tested + 1;
      skipped = is_tested ? 0 : skipped + 1;
      search.halve_each(halve_cells);
    }
  }

  ProofOutcome prove(const RootCells& cells, bool is_tested) {
    const Demand of = demand(cells);
    if (of.is_none()) return ProofOutcome::Proved;
    const bool is_last = cells.is_one();
    const bool is_patch = is_last && patches_of_.of(cell(cells.first_u, cells.first_v)).size() == 1;
    if (!budget_.is_spent(true) && is_tested && !is_patch) {
      const BoxBounds bounds = bounds_over(cells.box_in(root_));
      if (!bounds.broken && is_proved(bounds.arc(of.size), of.eps)) return ProofOutcome::Proved;
      if (is_unseen(bounds)) return ProofOutcome::Proved;
    }
    if (!is_last) return ProofOutcome::Open;
    for (const std::uint32_t k : patches_of_.of(cell(cells.first_u, cells.first_v))) {
      const Patch patch = patches_[k];
      if (!patch.cut_by && !patch.is_measured) parts_.push_back({k, patch.box});
    }
    return ProofOutcome::Refuted;
  }

  /// Proves parts of patches, level by level: wherever the search ends, all unproved boxes have
  /// about the same number of halvings, but for those that ended before.
  void prove_parts() {
    for (depth_ = 0; !parts_.empty(); ++depth_) {
      is_short_ = depth_ == 0 || kShort * parts_.size() <= patches_.size() ||
                  (depth_ <= kMaxBrokenDepth && gaps_.empty());
      next_.clear();
      bounded_.clear();
      measured_parts_.clear();
      const int most_halvings = broken_ <= kFewBoxes ? 2 * kHalvingsOfSecondOrder : kMaxBrokenDepth;
      broken_ = 0;
      for (Part& part : parts_) prove(part, most_halvings);
      const std::vector<ProofOutcome> measured = measure_(bounded_);
      for (std::size_t k = 0; k < measured.size(); ++k) {
        const Part& part = measured_parts_[k];
        if (measured[k] == ProofOutcome::Refuted) refute(part);
        if (measured[k] == ProofOutcome::Proved)
          result_.bound = std::max(result_.bound, kProofFactor * patches_[part.patch].allowed);
        if (measured[k] == ProofOutcome::Open) {
          halve(part, part.known->slope * part.box.size(), 1);
        }
      }
      std::erase_if(next_, [this](const Part& part) { return is_refuted(part.patch); });
      parts_.swap(next_);
    }
    descend();
  }

  /// Bounds of up to `ranked` untested parts, negative and in tolerances, with the parts' numbers:
  /// the largest bounds first.
  std::vector<std::pair<double, std::size_t>> worst_untested(std::size_t ranked) {
    std::vector<std::pair<double, std::size_t>> worst;
    for (std::size_t k = 0; k < ranked; ++k) {
      const std::size_t number = k * untested_.size() / ranked;
      const Part& part = untested_[number];
      const BoxBounds bounds = bounds_over(part.box);
      if (bounds.broken || patches_[part.patch].cut_by) continue;
      const double arc = bounds.arc(part.box.size());
      worst.emplace_back(std::isnan(arc) ? 0 : -arc / patches_[part.patch].allowed, number);
    }
    std::ranges::sort(worst);
    return worst;
  }

  /// Looks for the worst places of some patches for whose boxes no work is left: halves a box of
  /// each, and goes on with the half whose bounds are farther from its corner.
  void descend() {
    const std::size_t boxes = kPlacesOfDescents / budget_.of_box();
    const std::size_t descents = std::min(kFirstSearched, boxes / (2UL * kHalvingsToNearly) + 1);
    const std::size_t ranked = std::min({kInBatch, boxes, untested_.size()});
    const auto worst = worst_untested(ranked);
    for (std::size_t k = 0; k < std::min(descents, worst.size()); ++k) {
      Part part = untested_[worst[k].second];
      const Bounds corner = bounds_over({part.box.low, part.box.low}).hull;
      BoxBounds bounds = bounds_over(part.box);
      for (int depth = 0; depth < kHalvingsToNearly && !bounds.is_undefined; ++depth) {
        const dvec2 way = bounds.slope * part.box.size();
        const bool is_known = std::isfinite(way.x + way.y) && way.x != way.y;
        const auto halves = halves_of(part.box, is_known ? (way.x > way.y ? 0 : 1) : depth % 2);
        const BoxBounds first = bounds_over(halves[0]);
        const BoxBounds second = bounds_over(halves[1]);
        const bool is_second = second.farthest(corner.low) > first.farthest(corner.low);
        part.box = halves[is_second ? 1 : 0];
        bounds = is_second ? second : first;
        if (bounds.extent() <= patches_[part.patch].allowed) break;
      }
      const dvec2 bend(bounds.bend.x, bounds.bend.z);
      result_.unproved_boxes.push_back(
          {part.patch, part.box.middle(), part.box.size(), bend, false, false});
    }
  }

  /// `most_halvings`: where the surface may be undefined or jump.
  void prove(Part& part, int most_halvings) {
    if (is_refuted(part.patch)) return;
    if (budget_.is_spent(is_short_)) {
      if (untested_.empty() || untested_.back().patch != part.patch) untested_.push_back(part);
      return leave_unproved(part, {dvec2(0), false});
    }
    if (part.known && measure_later(part, *part.known)) return;
    const BoxBounds bounds = bounds_over(part.box);
    const dvec2 bend(bounds.bend.x, bounds.bend.z);
    if (bounds.is_undefined) {
      part.why = GapReason::Undefined;
      return leave_unproved(part, {dvec2(0), true});
    }
    if (bounds.broken) {
      part.why = *bounds.broken;
      if (measure_later(part, bounds)) return;
      ++broken_;
      if (depth_ >= most_halvings) return leave_unproved(part, {bend, false});
      return halve_along(part, depth_ % 2, 1);
    }
    const Patch patch = patches_[part.patch];
    const dvec2 size = part.box.size();
    const double arc = bounds.arc(size);
    if (depth_ == 0 && !patch.is_measured && !patch.cut_by && is_proved(arc, patch.allowed)) return;
    if (is_unseen(bounds)) return;
    part.why = bounds.is_smooth    ? GapReason::Wide
               : bounds.may_crease ? GapReason::Crease
                                   : GapReason::Nonsmooth;
    if (measure_later(part, bounds)) return;
    if (depth_ >= kAllHalvings) return leave_unproved(part, {bend, false});
    const int times = arc > kHalvedTwice * patch.allowed && std::isfinite(arc) ? 2 : 1;
    halve(part, bounds.contributions(size), times);
  }

  /// Puts a part on the list of boxes whose points are measured, if its bounds are narrow enough.
  bool measure_later(const Part& part, const BoxBounds& bounds) {
    const bool may_have_hole = bounds.broken == GapReason::Undefined;
    // A box in which the surface may be undefined is no longer than two tolerances, so that a hole
    // in it is one deep. Distances of the surface say nothing about its holes.
    const double tolerance = patches_[part.patch].allowed;
    const double allowed = may_have_hole ? tolerance : kReach * tolerance;
    const dvec2 size = part.box.size();
    const dvec2 bend(bounds.bend.x, bounds.bend.z);
    if (const auto cells = bounds.cells_within(size, allowed)) {
      budget_.take_points(std::size_t{(*cells)[0] + 1} * ((*cells)[1] + 1));
      bounded_.push_back({part.patch, part.box, *cells, bounds.reach(size, *cells), bend});
    } else if (const double radius = 0.5 * bounds.extent(); radius <= allowed) {
      budget_.take_points(1);
      bounded_.push_back({part.patch, part.box, {0, 0}, radius, bend, bounds.hull.centre()});
    } else {
      return false;
    }
    if (!bounds.is_smooth) result_.rough[part.patch] = 1;
    measured_parts_.push_back(part);
    measured_parts_.back().known = bounds;
    return true;
  }

  /// Halves a part along the axis that contributes more.
  void halve(const Part& part, const dvec2& contributions, int times) {
    const auto& [u, v] = std::pair(contributions.x, contributions.y);
    const int axis = u > v ? 0 : u < v ? 1 : depth_ % 2;  // the last for NaN
    halve_along(part, axis, times);
  }

  void halve_along(const Part& part, int axis, int times) {
    for (const ParameterBox& half : halves_of(part.box, axis)) {
      Part next = part;
      next.box = half;
      if (times > 1) {
        halve_along(next, axis, times - 1);
      } else {
        next_.push_back(next);
      }
    }
  }

  bool is_refuted(std::uint32_t patch) const { return !refuted_.empty() && refuted_[patch] != 0; }
  void refute(const Part& part) {
    refuted_.resize(patches_.size(), 0);
    refuted_[part.patch] = 1;
    result_.proved[part.patch] = 0;
  }

  /// Findings about a box without a proof.
  struct Known {
    dvec2 bend{0};
    bool is_undefined;
  };
  void leave_unproved(const Part& part, const Known& known) {
    if (const auto why = patches_[part.patch].cut_by) return add_gap(*why, part.patch, part.box);
    const bool may_jump = part.why == GapReason::Discontinuous;
    result_.unproved_boxes.push_back(
        {part.patch, part.box.middle(), part.box.size(), known.bend, known.is_undefined, may_jump});
    add_gap(part.why, part.patch, part.box);
  }

  std::size_t cell(std::size_t i, std::size_t j) const { return j * cells_u_ + i; }

  RootLines root_;
  std::size_t cells_u_, cells_v_;
  const Patches& patches_;
  const std::optional<Bounds>& clip_;
  const MeasureBoxes& measure_;
  ProofBudget& budget_;
  SurfaceEnclosure enclosure_;
  PatchesOfCells patches_of_;
  std::vector<Demand> of_cells_;  // of the root grid
  std::vector<Part> parts_, next_;
  std::vector<Part> untested_;  // of patches, for which no work is left
  std::vector<BoundedBox> bounded_;
  std::vector<Part> measured_parts_;   // of bounded_
  std::vector<std::uint8_t> refuted_;  // 1 for each patch that is; empty: none is
  int depth_ = 0;
  bool is_short_ = true;    // this level
  std::size_t broken_ = 0;  // boxes of this level where the surface may be undefined or jump
  std::vector<std::pair<std::uint32_t, ProofGap>> gaps_;  // of patches
  Certification result_;
};

}  // namespace

Certification certify(const Surface& surface, const RootLines& root, const Patches& patches,
                      const std::optional<Bounds>& clip, const MeasureBoxes& measure,
                      ProofBudget& budget) {
  return Certifier(surface, root, patches, clip, measure, budget).run();
}

}  // namespace saddle
