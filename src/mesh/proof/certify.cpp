#include "mesh/proof/certify.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "base/numbers.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/box_bounds.h"
#include "mesh/proof/sides_of_jump.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// A level is short with at most a quarter as many boxes as there are patches. While a proof has no
/// gap, levels of up to kMaxBrokenDepth halvings count as short: they may complete it.
constexpr std::size_t kShort = 4;
/// A level of at most kFewBoxes boxes goes on beyond kMaxBrokenDepth to kHalvingsOfSecondOrder each
/// way.
constexpr std::size_t kFewBoxes = 100;
/// A level of root cells helps if one in 8 is proved. After one level that does not help, another
/// is not tested; after two in a row, two, and so on.
constexpr std::size_t kHopeless = 8;
/// A box is halved twice at once if its bound is more than 256 times too large.
constexpr double kHalvedTwice = 256;

/// Where the work ends, up to kInBatch patches are ranked by their bounds, and the worst places of
/// kFirstSearched of them are looked for, by halvings of each. Each of the two takes up to 5,000
/// places.
constexpr std::size_t kPlacesOfDescents = 5'000;

class Certifier {
 public:
  Certifier(const Surface& surface, const RootLines& root, const Patches& patches,
            const std::optional<Bounds>& clip, const BoxHandlers& handlers, ProofBudget& budget)
      : root_(root),
        patches_(patches),
        clip_(clip),
        measure_(handlers.measure),
        budget_(budget),
        threads_(handlers.threads),
        enclosures_(surface, Bounded::SecondDerivatives),
        enclosure_(enclosures_.take()),
        unproved_(patches, handlers.take_unproved) {
    result_.proved.assign(patches.size(), 1);
    result_.rough.assign(patches.size(), 0);
  }

  Certification run() {
    gather_demands();
    prove_cells();
    prove_parts();
    descend();
    unproved_.pass_on();
    result_.proof_gaps.reserve(unproved_.gaps().size());
    for (const UnprovedParts::Gap& gap : unproved_.gaps()) {
      if (is_refuted(gap.patch)) continue;
      const ParameterBox box = unproved_.box_of(gap);
      result_.proof_gaps.push_back({gap.why, box.low, box.high});
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
    GapReason why;  ///< of the last box without a proof that held it
    bool is_whole;  ///< its box is that of the patch
    ParameterBox box;
    /// Bounds over a box that holds it, narrow enough: only its points decide.
    std::shared_ptr<const BoxBounds> known = {};
  };

  Part whole_part(std::uint32_t k) const { return {k, GapReason::Work, true, patches_[k].box}; }

  void gather_demands() {
    cells_.emplace(root_, patches_);
    for (std::size_t cell = 0; cell < cells_->count(); ++cell) {
      for (const std::uint32_t k : cells_->patches_of(cell)) {
        const Patch patch = patches_[k];
        if (patch.cut_by) {
          if (!patch.jump_line || !append_sides_of_jump(k)) add_gap(*patch.cut_by, k);
        } else if (patch.is_measured) {
          parts_.push_back(whole_part(k));
        } else {
          cells_->add(cell, {patch.box.size(), patch.allowed});
        }
      }
    }
  }

  /// Makes the two sides of a jump parts_, if bounds prove that nothing else is in its patch.
  bool append_sides_of_jump(std::uint32_t k) {
    const Patch patch = patches_[k];
    const auto sides = sides_of_jump(*patch.jump_line, patch.box, [this](const ParameterBox& box) {
      return bounds_over(box).broken.has_value();
    });
    if (!sides) return false;
    for (const ParameterBox& side : *sides) parts_.push_back({k, GapReason::Work, false, side});
    return true;
  }

  BoxBounds bounds_over(const ParameterBox& box) {
    budget_.take_boxes(1);
    return BoxBounds(enclosure_->enclose(box));
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

  void add_gap(GapReason why, std::uint32_t patch, const std::optional<ParameterBox>& part = {}) {
    unproved_.add_gap(why, patch, part);
    result_.proved[patch] = 0;
  }

  /// Proves many cells of the root grid at a time. Patches of single cells without a proof become
  /// whole_.
  void prove_cells() {
    BoxSubdivision<RootCells> search({all_cells(root_)});
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
    cells_.reset();
  }

  ProofOutcome prove(const RootCells& cells, bool is_tested) {
    const Demand of = cells_->demand(cells);
    if (of.is_none()) return ProofOutcome::Proved;
    const bool is_last = cells.is_one();
    const bool is_patch = is_last && cells_->patches_of(cells.first_u, cells.first_v).size() == 1;
    if (!budget_.is_spent(true) && is_tested && !is_patch) {
      const BoxBounds bounds = bounds_over(cells.box_in(root_));
      if (!bounds.broken && is_proved(bounds.arc(of.size), of.allowed)) return ProofOutcome::Proved;
      if (is_unseen(bounds)) return ProofOutcome::Proved;
    }
    if (!is_last) return ProofOutcome::Open;
    for (const std::uint32_t k : cells_->patches_of(cells.first_u, cells.first_v)) {
      const Patch patch = patches_[k];
      if (!patch.cut_by && !patch.is_measured) whole_.push_back(k);
    }
    return ProofOutcome::Refuted;
  }

  /// Proves parts of patches, level by level: wherever the search ends, all unproved boxes have
  /// about the same number of halvings, but for those that ended before.
  void prove_parts() {
    for (depth_ = 0; !parts_.empty() || !whole_.empty(); ++depth_) {
      is_short_ = depth_ == 0 || kShort * parts_.size() <= patches_.size() ||
                  (depth_ <= kMaxBrokenDepth && unproved_.gaps().empty());
      most_halvings_ = broken_ <= kFewBoxes ? 2 * kHalvingsOfSecondOrder : kMaxBrokenDepth;
      broken_ = 0;
      const std::vector<std::uint32_t> whole = std::exchange(whole_, {});
      const std::size_t parts = parts_.size();
      std::vector<Part> some;
      for (std::size_t k = 0; k < parts + whole.size(); ++k) {
        some.push_back(k < parts ? std::move(parts_[k]) : whole_part(whole[k - parts]));
        if (some.size() == kInBatch) prove_some(some);
      }
      prove_some(some);
      measure();
      parts_.clear();
      for (const std::uint32_t patch : newly_refuted_) refute(patch);
      newly_refuted_.clear();
      for (std::vector<Part>* const halves : {&next_, &next_of_measured_}) {
        std::ranges::copy_if(*halves, std::back_inserter(parts_),
                             [this](const Part& part) { return !is_refuted(part.patch); });
        halves->clear();
      }
    }
  }

  /// Proves parts of a level, and removes them from the list.
  void prove_some(std::vector<Part>& some) {
    const auto ahead = bounds_ahead(some);
    for (std::size_t k = 0; k < some.size(); ++k) {
      prove(some[k], patches_[some[k].patch], ahead[k]);
      if (bounded_.size() == kKeptAtATime) measure();
    }
    some.clear();
  }

  /// Bounds of the parts that are to be tested, as long as work is left.
  std::vector<std::optional<BoxBounds>> bounds_ahead(std::span<const Part> some) {
    std::vector<std::size_t> numbers;
    const std::size_t most = budget_.boxes_left(is_short_);
    for (std::size_t k = 0; k < some.size() && numbers.size() < most; ++k) {
      if (!some[k].known && !is_refuted(some[k].patch)) numbers.push_back(k);
    }
    std::vector<std::optional<BoxBounds>> ahead(some.size());
    enclosures_.in_chunks(numbers.size(), kSearchedTogether, threads_,
                          [&](SurfaceEnclosure& enclosure, std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i)
                              ahead[numbers[i]].emplace(enclosure.enclose(some[numbers[i]].box));
                          });
    return ahead;
  }

  /// Measures the points of bounded boxes. Patches that they refute stay in this level: its result
  /// does not depend on which boxes are measured together.
  void measure() {
    const std::vector<ProofOutcome> measured = measure_(bounded_);
    for (std::size_t k = 0; k < measured.size(); ++k) {
      const Part& part = measured_parts_[k];
      if (measured[k] == ProofOutcome::Refuted) newly_refuted_.push_back(part.patch);
      if (measured[k] == ProofOutcome::Proved)
        result_.bound = std::max(result_.bound, kProofFactor * patches_[part.patch].allowed);
      if (measured[k] == ProofOutcome::Open)
        halve(part, part.known->slope * part.box.size(), 1, next_of_measured_);
    }
    bounded_.clear();
    measured_parts_.clear();
  }

  /// Bounds of up to `ranked` untested parts, negative and in tolerances, with the numbers of their
  /// gaps: the largest bounds first.
  std::vector<std::pair<double, std::size_t>> worst_untested(std::size_t ranked) {
    std::vector<std::pair<double, std::size_t>> worst;
    for (std::size_t k = 0; k < ranked; ++k) {
      const std::size_t number = untested_[k * untested_.size() / ranked];
      const UnprovedParts::Gap& gap = unproved_.gaps()[number];
      const ParameterBox box = unproved_.box_of(gap);
      const BoxBounds bounds = bounds_over(box);
      if (bounds.broken || patches_[gap.patch].cut_by) continue;
      const double arc = bounds.arc(box.size());
      worst.emplace_back(std::isnan(arc) ? 0 : -arc / patches_[gap.patch].allowed, number);
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
      const UnprovedParts::Gap& gap = unproved_.gaps()[worst[k].second];
      const std::uint32_t patch = gap.patch;
      const auto bound = [this](const ParameterBox& box) { return bounds_over(box); };
      const auto& [box, bounds] =
          farthest_part(unproved_.box_of(gap), patches_[patch].allowed, bound);
      const dvec2 bend(bounds.bend.x, bounds.bend.z);
      unproved_.add_box({patch, box.middle(), box.size(), bend, false, false});
    }
  }

  /// `ahead`: the bounds, if they are known.
  void prove(Part& part, const Patch& patch, const std::optional<BoxBounds>& ahead) {
    if (is_refuted(part.patch)) return;
    if (budget_.is_spent(is_short_)) {
      if (untested_.empty() || unproved_.gaps()[untested_.back()].patch != part.patch)
        untested_.push_back(static_cast<std::uint32_t>(unproved_.gaps().size()));
      return leave_unproved(part, patch, dvec2(0));
    }
    if (part.known && measure_later(part, patch.allowed, *part.known)) return;
    if (ahead) budget_.take_boxes(1);
    const BoxBounds bounds = ahead ? *ahead : bounds_over(part.box);
    const dvec2 bend(bounds.bend.x, bounds.bend.z);
    if (bounds.is_undefined) {
      part.why = GapReason::Undefined;
      return leave_unproved(part, patch, dvec2(0), true);
    }
    if (bounds.broken) {
      part.why = *bounds.broken;
      if (measure_later(part, patch.allowed, bounds)) return;
      ++broken_;
      if (depth_ >= most_halvings_) return leave_unproved(part, patch, bend);
      return halve_along(part, depth_ % 2, 1, next_);
    }
    const dvec2 size = part.box.size();
    const double arc = bounds.arc(size);
    if (depth_ == 0 && !patch.is_measured && !patch.cut_by && is_proved(arc, patch.allowed)) return;
    if (is_unseen(bounds)) return;
    part.why = bounds.is_smooth    ? GapReason::Wide
               : bounds.may_crease ? GapReason::Crease
                                   : GapReason::Nonsmooth;
    if (measure_later(part, patch.allowed, bounds)) return;
    if (depth_ >= kAllHalvings) return leave_unproved(part, patch, bend);
    const int times = arc > kHalvedTwice * patch.allowed && std::isfinite(arc) ? 2 : 1;
    halve(part, bounds.contributions(size), times, next_);
  }

  /// Puts a part on the list of boxes whose points are measured, if its bounds are narrow enough.
  bool measure_later(const Part& part, double tolerance, const BoxBounds& bounds) {
    const auto box = bounded_box(part.patch, part.box, bounds, tolerance);
    if (!box) return false;
    budget_.take_points(box->count_points());
    bounded_.push_back(*box);
    if (!bounds.is_smooth) result_.rough[part.patch] = 1;
    measured_parts_.push_back(part);
    if (part.known.get() != &bounds)
      measured_parts_.back().known = std::make_shared<const BoxBounds>(bounds);
    return true;
  }

  /// Halves a part along the axis that contributes more.
  void halve(const Part& part, const dvec2& contributions, int times, std::vector<Part>& to) {
    const auto& [u, v] = std::pair(contributions.x, contributions.y);
    const int axis = u > v ? 0 : u < v ? 1 : depth_ % 2;  // the last for NaN
    halve_along(part, axis, times, to);
  }

  void halve_along(const Part& part, int axis, int times, std::vector<Part>& to) {
    for (const ParameterBox& half : halves_of(part.box, axis)) {
      Part next = part;
      next.box = half;
      next.is_whole = false;
      if (times > 1) {
        halve_along(next, axis, times - 1, to);
      } else {
        to.push_back(next);
      }
    }
  }

  bool is_refuted(std::uint32_t patch) const { return !refuted_.empty() && refuted_[patch] != 0; }
  void refute(std::uint32_t patch) {
    refuted_.resize(patches_.size(), 0);
    refuted_[patch] = 1;
    result_.proved[patch] = 0;
  }

  void leave_unproved(const Part& part, const Patch& patch, const dvec2& bend,
                      bool is_undefined = false) {
    if (const auto why = patch.cut_by) return add_gap(*why, part.patch, part.box);
    const bool may_jump = part.why == GapReason::Discontinuous;
    unproved_.add_box(
        {part.patch, part.box.middle(), part.box.size(), bend, is_undefined, may_jump});
    add_gap(part.why, part.patch, part.is_whole ? std::nullopt : std::optional(part.box));
  }

  RootLines root_;
  const Patches& patches_;
  const std::optional<Bounds>& clip_;
  const MeasureBoxes& measure_;
  ProofBudget& budget_;
  unsigned threads_;
  SurfaceEnclosures enclosures_;
  std::unique_ptr<SurfaceEnclosure> enclosure_;  // of this thread
  std::optional<DemandsOfCells> cells_;          // until they are proved
  std::vector<std::uint32_t> whole_;             // patches that follow the parts of the first level
  std::vector<Part> parts_;                      // of this level
  std::vector<Part> next_, next_of_measured_;    // of the next level, in this order
  std::vector<std::uint32_t> untested_;          // gaps of patches, for which no work is left
  std::vector<BoundedBox> bounded_;              // not measured yet
  std::vector<Part> measured_parts_;             // of bounded_
  std::vector<std::uint8_t> refuted_;            // 1 for each patch that is; empty: none is
  std::vector<std::uint32_t> newly_refuted_;     // in this level
  int depth_ = 0;
  int most_halvings_ = 0;   // where the surface may be undefined or jump
  bool is_short_ = true;    // this level
  std::size_t broken_ = 0;  // boxes of this level where the surface may be undefined or jump
  UnprovedParts unproved_;
  Certification result_;
};

}  // namespace

Certification certify(const Surface& surface, const RootLines& root, const Patches& patches,
                      const std::optional<Bounds>& clip, const BoxHandlers& handlers,
                      ProofBudget& budget) {
  return Certifier(surface, root, patches, clip, handlers, budget).run();
}

}  // namespace saddle
