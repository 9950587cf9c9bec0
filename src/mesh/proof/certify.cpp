#include "mesh/proof/certify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "formula/operations.h"
#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Halvings of a patch, both ways taken together: 12 give 1/64 of each side. A level of at most
/// kFewBoxes boxes goes on to 24, 1/4096: narrower than any peak that a picture shows.
constexpr int kMaxPatchDepth = 12;
constexpr int kMaxDepthOfFew = 24;
/// Budget: 8,000 boxes, and fewer for long formulas, 2.5 million instructions of 40 nanoseconds. A
/// complete proof takes up to some thousand boxes: a spike 1,000, a tube around a knot 5,000.
constexpr std::size_t kMaxBoxes = 8'000;
constexpr std::size_t kMaxSteps = 2'500'000;
/// Bounds that are within a factor of 4 of each other hide no feature. If the upper one is too
/// large for a proof then, halving the box does not help: second derivatives along a surface are
/// large under polar parameters even where it is flat.
constexpr double kKnown = 4;
/// The factor where the lower bound does not exceed the limit itself.
constexpr double kWellKnown = 1.1;
/// A box whose second derivatives are unbounded after 4 halvings holds a point where they are
/// infinite.
constexpr int kMaxUnboundedDepth = 4;
/// Two levels double the boxes along a line, and keep the number of those around a point. A level
/// with more than 1.5 times the boxes of the one two levels before, and more than 200, is not
/// worth a proof.
constexpr double kGrows = 1.5;
constexpr double kFewBoxes = 200;
/// Cost of a special function, in steps.
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
        enclosure_(surface, Bounded::SecondDerivatives),
        patches_of_(cells_u_ * cells_v_, patches) {}

  Certification run() {
    gather_demands();
    prove_cells();
    prove_parts();
    return std::move(result_);
  }

 private:
  /// A part of a patch.
  struct Part {
    std::uint32_t patch;
    ParameterBox box;
    GapReason why = GapReason::Work;  ///< of the last box without a proof that held it
  };

  /// Sizes and tolerances of some patches, from the smallest to the largest.
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

  enum class Proof {
    Proved,        ///< patches of these sizes are within their tolerances anywhere in the box
    Open,          ///< halves of the box may be proved
    Unbounded,     ///< second derivatives have no bound
    Unresolvable,  ///< second derivatives are too large, and known too well for halving to help
    Undefined,     ///< the surface is defined nowhere in the box
  };

  Proof prove(const ParameterBox& box, const Demand& of) {
    --budget_.boxes;
    const std::span<const Interval> all = enclosure_.enclose(box);
    for (const Interval& a : all.first(3)) {
      if (a.defined == Defined::No) {
        why_ = GapReason::Undefined;
        return Proof::Undefined;
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
    const double largest = bound(of.largest, length);
    if (largest <= kLimit * of.eps) {  // false for NaN
      result_.bound = std::max(result_.bound, largest / 8);
      return Proof::Proved;
    }
    const double least = bound(of.smallest, least_length);
    const double most = bound(of.smallest, length);
    if (!std::isfinite(most)) {
      why_ = GapReason::Nonsmooth;
      return Proof::Unbounded;
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

  /// Proves many cells of the root grid at a time. Patches of single cells without a proof become
  /// parts_.
  void prove_cells() {
    BoxSubdivision<Cells> search({{0, cells_u_, 0, cells_v_}});
    while (!search.open().empty()) {
      const std::size_t level = search.open().size();
      search.test([this](const Cells& cells) { return prove(cells); });
      search.halve_each(halve);
      if (goes_beyond_budget(level, search.open().size())) {
        for (const Cells& cells : search.open()) add_gap(GapReason::Work, box_of(cells));
        return;
      }
    }
  }

  ProofOutcome prove(const Cells& cells) {
    const ParameterBox box = box_of(cells);
    if (budget_.boxes == 0) return refute(GapReason::Work, box);
    const Proof proof = prove(box, demand(cells));
    if (proof == Proof::Proved) return ProofOutcome::Proved;
    if (proof == Proof::Unresolvable) return refute(GapReason::Wide, box);
    if (!cells.is_one()) return ProofOutcome::Open;
    add_patches(cells);
    return ProofOutcome::Refuted;
  }

  ProofOutcome refute(GapReason why, const ParameterBox& box) {
    add_gap(why, box);
    return ProofOutcome::Refuted;
  }

  /// Extrapolates the growth from a level to the next down to single cells: whether the budget
  /// ends before. Boxes of many cells find nothing that samples did not show.
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
        parts_.push_back({k, patch.box});
      }
    }
  }

  /// Proves parts of patches, level by level: wherever the search ends, all unproved boxes have
  /// the same number of halvings, but for those that ended before.
  void prove_parts() {
    constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();
    std::array<std::size_t, 2> before = {kUnknown, kUnknown};  // one level before, and two
    BoxSubdivision<Part> search(std::move(parts_));
    while (!search.open().empty()) {
      const std::size_t level = search.open().size();
      const bool grows =
          static_cast<double>(level) > std::max(kFewBoxes, kGrows * static_cast<double>(before[1]));
      const int max_depth =
          static_cast<double>(level) <= kFewBoxes ? kMaxDepthOfFew : kMaxPatchDepth;
      search.test([&](Part& part) {
        if (grows || budget_.boxes == 0) return leave_unproved(part, {dvec2(0), false});
        return prove(part, search.depth(), max_depth);
      });
      before = {level, before[0]};
      search.halve_in_turn();
    }
  }

  ProofOutcome prove(Part& part, int depth, int max_depth) {
    const Proof proof = prove(part.box, demand(part.patch));
    if (proof == Proof::Proved) return ProofOutcome::Proved;
    part.why = why_;
    if (proof == Proof::Unresolvable) return refute(GapReason::Wide, part.box);
    if (proof == Proof::Undefined) return leave_unproved(part, {dvec2(0), true});
    if (depth < (proof == Proof::Unbounded ? kMaxUnboundedDepth : max_depth)) {
      return ProofOutcome::Open;
    }
    const std::span<const Interval> second = enclosure_.last().subspan(9);
    return leave_unproved(part, {{length(second.first(3)), length(second.subspan(6, 3))}, false});
  }

  /// Findings about a box without a proof.
  struct Known {
    dvec2 bend{0};
    bool is_undefined;
  };
  ProofOutcome leave_unproved(const Part& part, const Known& known) {
    const bool may_jump = part.why == GapReason::Discontinuous;
    result_.unproved_boxes.push_back(
        {part.patch, part.box.middle(), part.box.size(), known.bend, known.is_undefined, may_jump});
    return refute(part.why, part.box);
  }

  std::size_t cell(std::size_t i, std::size_t j) const { return j * cells_u_ + i; }

  RootLines root_;
  std::size_t cells_u_, cells_v_;
  std::span<const Patch> patches_;
  ProofBudget& budget_;
  SurfaceEnclosure enclosure_;
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
