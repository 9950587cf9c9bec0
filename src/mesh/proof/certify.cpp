#include "mesh/proof/certify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "eval/enclose.h"
#include "formula/operations.h"

namespace saddle {

namespace {

/// Halvings of a leaf, both ways taken together: 1/64 of each side. Of few boxes more: 1/4096 finds
/// a peak that is narrower than anything that a picture shows.
constexpr int kMostHalvings = 12;
constexpr int kMaxDepthOfFew = 24;
/// Where a proof holds everywhere it takes a few boxes, or some thousands: a spike takes a
/// thousand, a tube around a knot five thousand of its 374 instructions. Where it does not, more
/// boxes tell no more. Steps are instructions of a box, 40 nanoseconds each.
constexpr std::size_t kMaxBoxes = 8'000;
constexpr std::size_t kMaxSteps = 2'500'000;
/// Second derivatives that are known to this factor hide nothing. If even so they are too large for
/// a proof, as they are along a surface that is flat but whose parameters are polar, halving boxes
/// does not make them smaller.
constexpr double kKnown = 4;
/// The same if they are known so well, and no less than is too much.
constexpr double kWellKnown = 1.1;
/// A box in which they are endless after so many halvings holds a point where they are.
constexpr int kMaxUnboundedDepth = 4;
/// Boxes along a line become twice as many when both their sides are halved, around a point as
/// many, and fewer where a proof comes nearer. Where they become this many times as many, and are
/// not few, there are no proofs to be found.
constexpr double kGrows = 1.5;
constexpr double kFewBoxes = 200;
/// What a special function takes in steps.
constexpr std::size_t kSpecialSteps = 600;

double magnitude(const Interval& a) {
  return std::max(std::fabs(a.low), std::fabs(a.high));
}
double length(std::span<const Interval> vector) {
  return std::hypot(magnitude(vector[0]), magnitude(vector[1]), magnitude(vector[2]));
}
double least_length(std::span<const Interval> vector) {
  const auto least = [](const Interval& a) { return std::max({a.low, -a.high, 0.0}); };
  return std::hypot(least(vector[0]), least(vector[1]), least(vector[2]));
}

/// Cells [first, end) of the root grid.
struct Cells {
  std::size_t first_u, end_u;
  std::size_t first_v, end_v;
  bool is_one() const { return end_u - first_u == 1 && end_v - first_v == 1; }
};

/// The patches of each cell of the root grid.
class PatchesOfCells {
 public:
  PatchesOfCells(std::size_t cells, std::span<const Patch> patches)
      : first_(cells + 1, 0), patches_(patches.size()) {
    for (const Patch& patch : patches) ++first_[patch.root_cell + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < patches.size(); ++k) patches_[next[patches[k].root_cell]++] = k;
  }
  std::span<const std::uint32_t> of(std::size_t cell) const {
    return std::span(patches_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> patches_;
};

class Certifier {
 public:
  Certifier(const Surface& surface, const RootLines& root, std::span<const Patch> patches,
            ProofBudget& budget)
      : root_(root),
        cells_u_(root.u.size() - 1),
        cells_v_(root.v.size() - 1),
        patches_(patches),
        budget_(budget),
        enclosure_(surface.bounds),
        outputs_(surface.bounds.outputs.size()),
        patches_of_(cells_u_ * cells_v_, patches) {}

  Certification run() {
    gather_demands();
    prove_cells();
    prove_parts();
    return std::move(result_);
  }

 private:
  /// A part of a patch, halved so many times.
  struct Part {
    std::uint32_t patch;
    int depth;
    ParameterBox box;
    dvec2 bend;
    GapReason why = GapReason::Work;  ///< what its last try has met
  };

  /// The demands of some patches: sizes and tolerances, from the smallest to the largest.
  struct Demand {
    dvec2 largest{0};
    double eps = std::numeric_limits<double>::infinity();
    dvec2 smallest{std::numeric_limits<double>::infinity()};
    double largest_eps = 0;

    void add(const Demand& other) {
      largest = glm::max(largest, other.largest);
      eps = std::min(eps, other.eps);
      smallest = glm::min(smallest, other.smallest);
      largest_eps = std::max(largest_eps, other.largest_eps);
    }
  };
  Demand demand(std::uint32_t patch) const {
    const dvec2 size = patches_[patch].box.size();
    return {size, patches_[patch].allowed, size, patches_[patch].allowed};
  }
  Demand demand(const Cells& cells) const {
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
      for (const std::uint32_t patch : patches_of_.of(cell)) of_cells_[cell].add(demand(patch));
    }
  }

  enum class Proof { LocatedDiscontinuity, Open, Endless, Unresolvable, PointSingularity };

  /// Whether leaves of a size are near enough wherever they are in the box, second derivatives are
  /// endless, no halving can prove anything, or the surface is not defined at all there. Of a box
  /// that nobody looks at any more nothing is known.
  Proof prove(const ParameterBox& box, const Demand& of) {
    --budget_.boxes;
    enclosure_(range_between(box.low.x, box.high.x), range_between(box.low.y, box.high.y),
               outputs_);
    // r, r_u, r_v, then r_uu, r_uv, r_vv.
    const std::span<const Interval> all(outputs_);
    for (const Interval& a : all.first(3)) {
      if (a.defined == Defined::No) {
        why_ = GapReason::Undefined;
        return Proof::PointSingularity;
      }
      if (a.defined != Defined::Yes) return open(GapReason::Undefined);
      if (!a.continuous) return open(GapReason::Discontinuous);
    }
    for (const Interval& a : all.subspan(3)) {
      const bool is_second = &a >= &all[9];
      if (a.defined != Defined::Yes || (!is_second && !a.continuous))
        return open(GapReason::Nonsmooth);
    }
    why_ = GapReason::Wide;
    const auto bound = [&all](const dvec2& size, double (*length)(std::span<const Interval>)) {
      return size.x * size.x * length(all.subspan(9, 3)) +
             2 * size.x * size.y * length(all.subspan(12, 3)) +
             size.y * size.y * length(all.subspan(15, 3));
    };
    constexpr double kLimit = 8 * kProofFactor;
    if (bound(of.largest, length) <= kLimit * of.eps)
      return Proof::LocatedDiscontinuity;  // not so for NaN
    const double least = bound(of.smallest, least_length);
    const double most = bound(of.smallest, length);
    if (!std::isfinite(most)) {
      why_ = GapReason::Nonsmooth;
      return Proof::Endless;
    }
    const bool is_unresolvable =
        most > kLimit * of.largest_eps &&
        most <= (least > kLimit * of.largest_eps ? kKnown : kWellKnown) * least;
    return is_unresolvable ? Proof::Unresolvable : Proof::Open;
  }

  Proof open(GapReason why) {
    why_ = why;
    return Proof::Open;
  }

  void add_gap(GapReason why, const ParameterBox& box) {
    result_.proof_gaps.push_back({why, box.low, box.high});
  }

  /// Cells of the root grid, many at a time. The patches of cells without a proof remain.
  void prove_cells() {
    std::vector<Cells> level = {{0, cells_u_, 0, cells_v_}};
    std::vector<Cells> next;
    while (!level.empty()) {
      next.clear();
      for (const Cells& cells : level) {
        const ParameterBox box = box_of(cells);
        if (budget_.boxes == 0) {
          add_gap(GapReason::Work, box);
          continue;
        }
        const Proof proof = prove(box, demand(cells));
        if (proof == Proof::LocatedDiscontinuity) continue;
        if (proof == Proof::Unresolvable) {
          add_gap(GapReason::Wide, box);
        } else if (cells.is_one()) {
          add_patches(cells);
        } else {
          halve(cells, next);
        }
      }
      if (goes_beyond_budget(level.size(), next.size())) {
        for (const Cells& cells : next) add_gap(GapReason::Work, box_of(cells));
        return;
      }
      level.swap(next);
    }
  }

  /// Whether boxes that become more as those of this level do will not come down to single cells:
  /// above those nothing is found that samples did not show.
  bool goes_beyond_budget(std::size_t level, std::size_t next) const {
    if (next < static_cast<std::size_t>(kFewBoxes)) return false;
    const auto count = static_cast<double>(next);
    const double growth = count / static_cast<double>(level);
    const double generations = std::log2(static_cast<double>(cells_u_ * cells_v_) / count);
    return count * std::pow(growth, generations) > static_cast<double>(budget_.boxes);
  }

  ParameterBox box_of(const Cells& cells) const {
    return {{root_.u[cells.first_u], root_.v[cells.first_v]},
            {root_.u[cells.end_u], root_.v[cells.end_v]}};
  }

  static void halve(const Cells& cells, std::vector<Cells>& to) {
    Cells a = cells;
    Cells b = cells;
    if (cells.end_u - cells.first_u >= cells.end_v - cells.first_v) {
      a.end_u = b.first_u = (cells.first_u + cells.end_u) / 2;
    } else {
      a.end_v = b.first_v = (cells.first_v + cells.end_v) / 2;
    }
    to.push_back(a);
    to.push_back(b);
  }

  void add_patches(const Cells& cells) {
    for (const std::uint32_t k : patches_of_.of(cell(cells.first_u, cells.first_v))) {
      const Patch& patch = patches_[k];
      if (patch.cut_by) {
        add_gap(*patch.cut_by, patch.box);
      } else {
        parts_.push_back({k, 0, patch.box, dvec2(0)});
      }
    }
  }

  /// Parts of patches, all of a size before any of the next: when there are no proofs to be found,
  /// or no boxes to find them with, all places without one have been narrowed down alike.
  void prove_parts() {
    std::vector<Part> next;
    constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();
    std::array<std::size_t, 2> before = {kUnknown, kUnknown};  // one level, and two
    while (!parts_.empty()) {
      next.clear();
      const bool grows = static_cast<double>(parts_.size()) >
                         std::max(kFewBoxes, kGrows * static_cast<double>(before[1]));
      for (Part& part : parts_) {
        if (grows || budget_.boxes == 0) {
          leave_unproved(part);
        } else {
          prove(part, next);
        }
      }
      before = {parts_.size(), before[0]};
      parts_.swap(next);
    }
  }

  void prove(Part& part, std::vector<Part>& next) {
    const Proof proof = prove(part.box, demand(part.patch));
    if (proof == Proof::LocatedDiscontinuity) return;
    part.why = why_;
    if (proof == Proof::Unresolvable) return add_gap(GapReason::Wide, part.box);
    if (proof == Proof::PointSingularity) return leave_unproved(part, true);
    if (part.depth < max_depth(proof)) return halve(part, next);
    const std::span<const Interval> second = std::span(outputs_).subspan(9);
    part.bend = {length(second.first(3)), length(second.subspan(6, 3))};
    leave_unproved(part);
  }

  int max_depth(Proof proof) const {
    if (proof == Proof::Endless) return kMaxUnboundedDepth;
    return static_cast<double>(parts_.size()) <= kFewBoxes ? kMaxDepthOfFew : kMostHalvings;
  }

  void leave_unproved(const Part& part, bool is_undefined = false) {
    const bool may_jump = part.why == GapReason::Discontinuous;
    result_.unproved_boxes.push_back(
        {part.patch, part.box.middle(), part.box.size(), part.bend, is_undefined, may_jump});
    add_gap(part.why, part.box);
  }

  static void halve(const Part& part, std::vector<Part>& to) {
    Part a = part;
    Part b = part;
    const int axis = part.depth % 2;
    a.depth = b.depth = part.depth + 1;
    a.box.high[axis] = b.box.low[axis] = part.box.middle()[axis];
    to.push_back(a);
    to.push_back(b);
  }

  std::size_t cell(std::size_t i, std::size_t j) const { return j * cells_u_ + i; }

  RootLines root_;
  std::size_t cells_u_, cells_v_;
  std::span<const Patch> patches_;
  ProofBudget& budget_;
  Enclosure enclosure_;
  std::vector<Interval> outputs_;
  PatchesOfCells patches_of_;
  std::vector<Demand> of_cells_;  // of the root grid
  std::vector<Part> parts_;
  GapReason why_ = GapReason::Work;  // of the last box without a proof
  Certification result_;
};

}  // namespace

ProofBudget::ProofBudget(const Tape& tape) {
  std::size_t steps = 1;
  for (const auto& part : {tape.of_u, tape.of_v, tape.of_both}) {
    for (const Instruction& instruction : part) {
      steps += is_special(instruction.op) ? kSpecialSteps : 1;
    }
  }
  boxes = std::min(kMaxBoxes, kMaxSteps / steps);
}

Certification certify(const Surface& surface, const RootLines& root, std::span<const Patch> patches,
                      ProofBudget& budget) {
  return Certifier(surface, root, patches, budget).run();
}

}  // namespace saddle
