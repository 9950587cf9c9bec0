#include "mesh/mesher/subdivide.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/error/error_indicator.h"
#include "mesh/error/estimate_many.h"
#include "mesh/mesher/edge_features.h"
#include "mesh/mesher/oscillation.h"
#include "mesh/tree/cell_polygon.h"

namespace saddle {

namespace {

/// A score falls to a quarter when a smooth arc is halved, to half at a kink, to 0.71 at a vertical
/// tangent; where it stays above this share, so many times in a row, halving is in vain.
constexpr double kHelps = 0.8;
constexpr std::uint8_t kMaxStagnation = 14;
/// The same for normals: around a point where sheets meet they turn however small the leaf, until
/// it is too small to see.
constexpr std::uint8_t kMaxNormalStagnation = 12;
/// After every so many halvings in vain, of distances and of normals, a leaf's sides are looked at
/// for jumps and creases. A leaf halved the wrong way once is no better for it, either.
constexpr std::uint8_t kLookAfter = 3;
constexpr std::uint8_t kLookAfterTurned = 2;
/// Halvings of a root cell that the boundary crosses, to begin with, and of one in which a cut is
/// more than one line, at most.
constexpr int kBoundaryHalvings = 4;
constexpr int kMostCutHalvings = 14;
/// As many again along a pole as it took to come near it.
constexpr int kMostHalvingsBesidePole = 2 * kMostCutHalvings;
/// Halvings of a root cell, at most, that lead to where the surface is defined, and from there on
/// those that follow its boundary: at a corner of two boundaries with upright tangents it takes
/// that many. Where boundaries cross at a pole, more than those of a cut would do no good.
constexpr int kMostSeekHalvings = 24;
constexpr int kMostBoundaryHalvings = 24;

/// Halvings of the root cell that the leaf came from.
int halvings_of_root(const Leaf& leaf) {
  return std::countr_zero(kCellUnit / leaf.size_u()) + std::countr_zero(kCellUnit / leaf.size_v());
}
/// The same without those that led to what is defined.
int halvings(const Leaf& leaf) {
  return halvings_of_root(leaf) - leaf.sought;
}

/// A leaf that is still to be judged, and how bad the one was that it is a half of.
struct Candidate {
  Leaf leaf;
  std::vector<std::uint32_t> counterexamples;  ///< against it
  double parent_distance;
  double parent_turn;
};

std::uint8_t count_stagnation(std::uint8_t before, double estimate, double parent_ratio) {
  return estimate <= std::max(kHelps * parent_ratio, 1.0) ? std::uint8_t{0}
                                                          : static_cast<std::uint8_t>(before + 1);
}

/// A candidate that was judged.
struct Estimated {
  Candidate candidate;
  CellError error;
};

class Subdivider {
 public:
  Subdivider(std::span<const Counterexample> counterexamples, const RefineOptions& limits,
             const SubdivisionGoal& goal, const Grid& grid, Oscillation known, CellTree& tree)
      : counterexamples_(counterexamples),
        limits_(limits),
        goal_(goal),
        tree_(tree),
        indicator_(limits, grid, tree),
        known_(std::move(known)),
        oscillation_(grid, limits.share) {}

  /// Judges a generation, and puts the next one in its place.
  void advance(std::vector<Candidate>& candidates) {
    std::vector<Leaf> leaves;
    leaves.reserve(candidates.size());
    for (Candidate& candidate : candidates) {
      request_samples(candidate.leaf, tree_);
      leaves.push_back(candidate.leaf);
    }
    tree_.geometry().evaluate(limits_.threads);
    const FastCellErrors fast_errors = estimate_many(leaves, limits_, indicator_, tree_);
    next_.clear();
    oscillation_.clear();
    std::vector<Estimated> boundaries;
    std::vector<Estimated> doubtful;
    std::vector<Estimated> others;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const FastCellError& fast = fast_errors.leaves[k];
      if (fast.passes && candidates[k].counterexamples.empty()) {
        keep_good(leaves[k], fast.distance);
        continue;
      }
      const int defined = fast.is_known ? 9 : count_defined(tree_, leaves[k]);
      if (defined == 0) {
        seek(candidates[k]);
        continue;
      }
      if (defined < 9) {
        if (!keep_oscillating_boundary(leaves[k])) boundaries.push_back({candidates[k], {}});
        continue;
      }
      Estimated estimated = judge(std::move(candidates[k]), fast_errors.error(fast));
      const Leaf& leaf = estimated.candidate.leaf;
      if (!leaf.state.leads_to_pole()) {
        oscillation_.add(leaf, estimated.error.distance, tree_);
      }
      const bool is_open =
          estimated.error.is_folded || estimated.error.may_jump || is_doubtful(leaf);
      (is_open ? doubtful : others).push_back(std::move(estimated));
    }
    std::erase_if(doubtful, [&](const Estimated& estimated) {
      const Leaf& leaf = estimated.candidate.leaf;
      const bool is_unresolvable =
          oscillates(leaf) || known_.splits_predicted_u(leaf, tree_).has_value();
      if (is_unresolvable) others.push_back(estimated);
      return is_unresolvable;
    });
    for (const Estimated& estimated : others) settle(estimated);
    estimate_boundaries(boundaries);
    look_for_cuts(doubtful);
    std::swap(candidates, next_);
  }

  Subdivision take() { return std::move(result_); }

 private:
  void keep_good(Leaf leaf, float distance) {
    leaf.stagnation = leaf.normal_stagnation = 0;
    leaf.known_error = distance;
    result_.leaves.push_back(leaf);
  }

  /// Halves a leaf that is cut until the cut is nearly straight in it; what remains to be done
  /// fresh samples tell. The halves do not know yet what cuts them.
  void estimate_cut(const Estimated& estimated, Leaf leaf, bool across_u, int wanted_halvings) {
    const int done = halvings(leaf);
    const auto halves = done < wanted_halvings ? halve_if_allowed(leaf, across_u) : std::nullopt;
    if (!halves) {
      const int most =
          leaf.state.is_on_boundary() ? most_boundary_halvings(leaf) : kMostCutHalvings;
      if (done >= most || tree_.budget().is_full(goal_.max_triangles)) leaf.state.freeze();
      result_.leaves.push_back(leaf);
      return;
    }
    for (Leaf half : *halves) {
      half.state.forget_boundary();
      push(half, estimated.candidate, estimated.candidate.parent_distance,
           estimated.candidate.parent_turn);
    }
  }

  /// Halves a leaf that is defined at none of its samples until it is, if it is known to be
  /// defined somewhere.
  void seek(const Candidate& candidate) {
    const Leaf& leaf = candidate.leaf;
    const bool is_known = !candidate.counterexamples.empty() || has_defined_corner(leaf, tree_);
    const auto halves = is_known && halvings_of_root(leaf) < kMostSeekHalvings
                            ? halve_if_allowed(leaf, leaf.size_u() >= leaf.size_v())
                            : std::nullopt;
    if (!halves) {
      result_.empty.push_back(leaf);
      return;
    }
    for (Leaf half : *halves) {
      half.sought = static_cast<std::uint8_t>(halvings_of_root(half));
      push(half, candidate, candidate.parent_distance, candidate.parent_turn);
    }
  }

  /// Keeps a leaf that waves are foreseen to cut more often than it could show. False if it is
  /// none.
  bool keep_oscillating_boundary(Leaf leaf) {
    if (!known_.contains(leaf, tree_)) return false;
    leaf.state.cross_boundary();
    note_oscillation(leaf);
    result_.leaves.push_back(leaf);
    return true;
  }

  void note_oscillation(Leaf& leaf) {
    leaf.state.stop_at_oscillation();
    known_.add(leaf, tree_);
    if (!result_.oscillates) result_.oscillates = tree_.vertices().parameters(leaf.middle());
  }

  /// Leaves on the boundary. Where the surface goes to infinity there, they are halved until what
  /// is cut off with the boundary is clipped anyway.
  void estimate_boundaries(std::span<const Estimated> boundaries) {
    std::vector<Leaf> fine;
    for (const Estimated& boundary : boundaries) {
      const bool is_fine = halvings(boundary.candidate.leaf) >= kBoundaryHalvings;
      if (is_fine && limits_.clip && !indicator_.is_outside(boundary.candidate.leaf))
        fine.push_back(boundary.candidate.leaf);
    }
    look_at(fine);
    for (const Estimated& boundary : boundaries) {
      Leaf leaf = boundary.candidate.leaf;
      leaf.state.take_pole_for_boundary();
      const bool goes_far =
          limits_.clip && !indicator_.is_outside(leaf) && has_cut(FeatureKind::Pole, leaf, tree_);
      estimate_cut(
          boundary, leaf, indicator_.splits_boundary_u(leaf),
          goes_far || has_no_limit(leaf.samples) ? kMostCutHalvings : boundary_halvings(leaf));
    }
  }

  /// Whether one of the samples has no limit: what of the leaf it is a corner of is left out.
  bool has_no_limit(const SampleVertices& samples) const {
    const auto has_none = [this](std::uint32_t vertex) {
      return tree_.geometry().singularity(vertex) == PointSingularity::Kind::NoLimit;
    };
    return std::ranges::any_of(samples.corner, has_none) ||
           std::ranges::any_of(samples.side, has_none) || has_none(samples.centre);
  }

  /// Halvings of a leaf that the boundary crosses: one more for each time that fresh samples found
  /// it to be twice as far off as allowed.
  int boundary_halvings(const Leaf& leaf) const {
    return std::min(kBoundaryHalvings + std::ilogb(leaf.safety), most_boundary_halvings(leaf));
  }
  int most_boundary_halvings(const Leaf& leaf) const {
    const bool goes_far =
        has_cut(FeatureKind::Pole, leaf, tree_) || has_cut(FeatureKind::Face, leaf, tree_);
    return goes_far ? kMostCutHalvings : kMostBoundaryHalvings;
  }

  /// Halvings of a leaf that is cut. A pole is cut like a boundary.
  static int wanted_halvings(const FeatureCount& cuts) {
    if (!cuts.is_through()) return kMostCutHalvings;
    return cuts.leads_to_pole ? kBoundaryHalvings : 0;
  }

  /// Whether a leaf's sides are to be looked at.
  static bool is_doubtful(const Leaf& leaf) {
    const auto is_due = [](std::uint8_t stagnation, std::uint8_t period) {
      return stagnation > 0 && stagnation % period == 0;
    };
    return leaf.state.is_cut_by_feature() || is_due(leaf.stagnation, kLookAfter) ||
           is_due(leaf.normal_stagnation, kLookAfterTurned);
  }

  /// Looks at the sides of leaves for what cuts them.
  void look_at(std::span<const Leaf> leaves) {
    const std::vector<Side> sides = unsearched(leaves);
    if (!sides.empty()) trace_features(sides, trace_options(), tree_);
  }

  std::vector<Side> unsearched(std::span<const Leaf> leaves) const {
    std::vector<Side> sides;
    for (const Leaf& leaf : leaves) append_unsearched(leaf, tree_, sides);
    sort_sides(sides);
    return sides;
  }

  TraceOptions trace_options() const {
    return {limits_.tolerance, false, limits_.threads, limits_.clip, goal_.max_triangles};
  }

  /// An arc that is no small one may jump; only normals that are opposed, or never agree, tell of a
  /// crease.
  void look_for_cuts(std::span<Estimated> doubtful) {
    std::vector<Leaf> bent;
    std::vector<Leaf> others;
    for (const Estimated& estimated : doubtful) {
      const Leaf& leaf = estimated.candidate.leaf;
      const bool may_crease = estimated.error.is_folded || is_doubtful(leaf);
      (may_crease ? others : bent).push_back(leaf);
    }
    look_at(others);
    find_jumps(unsearched(bent), trace_options(), tree_);
    // Before halves put new vertices on the sides.
    std::vector<FeatureCount> cuts_of(doubtful.size());
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      Leaf& leaf = doubtful[k].candidate.leaf;
      const FeatureCount cuts = count_features(leaf, tree_);
      if (cuts.leads_to_pole) doubtful[k].error.distance = doubtful[k].error.gap;
      cuts_of[k] = cuts;
      const bool is_creased = doubtful[k].error.is_folded && cuts.is_through();
      leaf.state.set_features(cuts.features > 0 || is_creased, cuts.leads_to_pole);
    }
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      Leaf& leaf = doubtful[k].candidate.leaf;
      const bool is_clear = cuts_of[k].is_through();
      const bool is_cut = leaf.state.is_cut_by_feature();
      if (is_cut && !is_clear && indicator_.is_too_small_to_see(leaf)) {
        leaf.state.freeze();
        result_.leaves.push_back(leaf);
      } else if (is_cut) {
        estimate_cut(doubtful[k], leaf, cuts_of[k].is_parted_across_u(leaf),
                     wanted_halvings(cuts_of[k]));
      } else {
        settle(doubtful[k]);
      }
    }
  }

  /// What the samples say of a leaf. `known`: that, or nullptr.
  Estimated judge(Candidate candidate, const CellError* known) const {
    Estimated estimated{std::move(candidate), {}};
    Leaf& leaf = estimated.candidate.leaf;
    if (indicator_.is_clipped(leaf)) return estimated;
    estimated.error = known != nullptr ? *known : indicator_.estimate(leaf);
    if (leaf.state.leads_to_pole()) estimated.error.distance = estimated.error.gap;
    const double distance = estimated.error.distance.worst() * leaf.safety;
    const double turn = estimated.error.turn.worst() * leaf.normal_safety;
    const auto& [whole, counterexamples, parent_distance, parent_turn] = estimated.candidate;
    leaf.stagnation = count_stagnation(leaf.stagnation, distance, parent_distance);
    leaf.normal_stagnation = count_stagnation(leaf.normal_stagnation, turn, parent_turn);
    return estimated;
  }

  /// Keeps a leaf, or goes on with its halves.
  void settle(const Estimated& estimated) {
    Leaf leaf = estimated.candidate.leaf;
    const CellError& error = estimated.error;
    const double distance = error.distance.worst() * leaf.safety;
    const bool turn_counts = !tree_.budget().has_many(allowed_for_normals(goal_.max_triangles));
    const double turn = turn_counts ? error.turn.worst() * leaf.normal_safety : 0;
    // Toward a pole errors grow as leaves shrink: there is always more to do. Beside it, where the
    // surface comes back into sight, there is not.
    const int enough = error.may_jump ? kMostCutHalvings : kMostHalvingsBesidePole;
    const bool is_cut_off =
        leaf.state.leads_to_pole() && (halvings(leaf) >= enough || indicator_.is_outside(leaf));
    const bool is_far = distance > 1 && leaf.stagnation <= kMaxStagnation && !is_cut_off;
    const bool is_turned =
        turn > 1 && leaf.normal_stagnation <= kMaxNormalStagnation && !is_cut_off;
    const ErrorRatios ratios = !is_turned ? error.distance
                               : !is_far  ? error.turn
                                          : worse(error.distance, error.turn);
    const bool passes = !is_far && !is_turned;
    const Counterexample* const missed = passes ? missed_counterexample(estimated) : nullptr;
    std::optional<std::array<Leaf, 2>> halves;
    if (!passes || missed != nullptr) {
      halves = halves_of(leaf, missed != nullptr ? indicator_.splits_u(leaf, *missed)
                                                 : indicator_.splits_u(leaf, ratios));
    }
    if (!halves) {
      if (distance > 1 || turn > 1) leaf.state.freeze();
      leaf.known_error = static_cast<float>(error.distance.worst());
      result_.leaves.push_back(leaf);
      return;
    }
    for (const Leaf& half : *halves) push(half, estimated.candidate, distance, turn);
  }

  bool oscillates(const Leaf& leaf) const {
    return oscillation_.contains(leaf, tree_) || known_.contains(leaf, tree_);
  }

  /// Nothing where the limit is reached, or the surface oscillates.
  std::optional<std::array<Leaf, 2>> halves_of(Leaf& leaf, bool across_u) {
    if (oscillates(leaf)) {
      note_oscillation(leaf);
      return std::nullopt;
    }
    return halve_if_allowed(leaf, known_.splits_predicted_u(leaf, tree_).value_or(across_u));
  }

  /// Nothing where the limit is reached.
  std::optional<std::array<Leaf, 2>> halve_if_allowed(const Leaf& leaf, bool across_u) {
    const bool full = tree_.budget().is_full(goal_.max_triangles);
    result_.reached_limit = result_.reached_limit || full;
    return full ? std::nullopt : halve(leaf, across_u, tree_);
  }

  /// Leaves a candidate's half with the counterexamples that are in it.
  void push(const Leaf& half, const Candidate& whole, double distance, double turn) {
    Candidate candidate{half, {}, distance, turn};
    if (!whole.counterexamples.empty()) {
      const dvec2 low = tree_.vertices().parameters(half.low);
      const dvec2 size = tree_.vertices().parameters(half.high) - low;
      for (const std::uint32_t counterexample : whole.counterexamples) {
        const dvec2 part = (counterexamples_[counterexample].uv - low) / size;
        const bool is_inside = part.x >= 0 && part.x <= 1 && part.y >= 0 && part.y <= 1;
        if (is_inside) candidate.counterexamples.push_back(counterexample);
      }
    }
    next_.push_back(std::move(candidate));
  }

  /// The first counterexample that a leaf misses.
  const Counterexample* missed_counterexample(const Estimated& estimated) const {
    const auto& [leaf, counterexamples, parent_distance, parent_turn] = estimated.candidate;
    for (const std::uint32_t counterexample : counterexamples) {
      if (indicator_.misses(leaf, counterexamples_[counterexample]))
        return &counterexamples_[counterexample];
    }
    return nullptr;
  }

  std::span<const Counterexample> counterexamples_;
  const RefineOptions& limits_;
  SubdivisionGoal goal_;
  CellTree& tree_;
  ErrorIndicator indicator_;
  std::vector<Candidate> next_;
  Oscillation known_;        // among leaves that are not halved any more
  Oscillation oscillation_;  // of this generation
  Subdivision result_;
};

}  // namespace

bool has_defined_corner(const Leaf& leaf, const CellTree& tree) {
  bool has = false;
  for_sides(leaf, tree,
            [&](std::uint32_t a, std::uint32_t) { has = has || tree.geometry().is_defined(a); });
  return has;
}

std::vector<Leaf> root_leaves(const Grid& grid) {
  std::vector<Leaf> leaves;
  leaves.reserve(grid.cell_count());
  for (std::uint32_t j = 0; j < grid.cells_v; ++j) {
    for (std::uint32_t i = 0; i < grid.cells_u; ++i) {
      leaves.push_back(
          {{i * kCellUnit, j * kCellUnit}, {(i + 1) * kCellUnit, (j + 1) * kCellUnit}});
    }
  }
  return leaves;
}

std::optional<std::array<Leaf, 2>> halve(const Leaf& leaf, bool across_u, CellTree& tree) {
  if ((across_u ? leaf.size_u() : leaf.size_v()) < 2) return std::nullopt;
  const DyadicPoint middle = leaf.middle();
  std::array<Leaf, 2> halves = {leaf, leaf};
  for (Leaf& half : halves) half.bisected = 0;
  halves[0].samples = leaf.samples.of_half(across_u, true);
  halves[1].samples = leaf.samples.of_half(across_u, false);
  if (across_u) {
    halves[0].high.u = halves[1].low.u = middle.u;
  } else {
    halves[0].high.v = halves[1].low.v = middle.v;
  }
  const std::size_t first = across_u ? 0 : 1;
  for (const std::size_t k : {first, first + 2}) tree.use_middle(leaf, k);
  return halves;
}

Subdivision subdivide(std::span<const Leaf> active, std::span<const Counterexample> counterexamples,
                      Oscillation known, const RefineOptions& limits, const SubdivisionGoal& goal,
                      const Grid& grid, CellTree& tree) {
  Subdivider subdivider(counterexamples, limits, goal, grid, std::move(known), tree);
  std::vector<Candidate> candidates;
  candidates.reserve(active.size());
  for (const Leaf& leaf : active) {
    constexpr double kNotKnown = std::numeric_limits<double>::infinity();
    candidates.push_back({leaf, {}, kNotKnown, kNotKnown});
    candidates.back().leaf.bisected = 0;
  }
  for (std::uint32_t k = 0; k < counterexamples.size(); ++k) {
    candidates[counterexamples[k].cell].counterexamples.push_back(k);
  }
  // A generation past the one that finds poles, which may be on a few cells' sides only.
  for (bool has_poles = false; !candidates.empty(); has_poles = tree.has_poles()) {
    subdivider.advance(candidates);
    if (goal.until == Until::OneGeneration || (goal.until == Until::Poles && has_poles)) {
      break;
    }
  }
  return subdivider.take();
}

}  // namespace saddle
