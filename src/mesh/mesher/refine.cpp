#include "mesh/mesher/refine.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/error/judge.h"
#include "mesh/error/judge_many.h"
#include "mesh/mesher/crossings.h"
#include "mesh/mesher/oscillation.h"
#include "mesh/tree/outline.h"

namespace saddle {

namespace {

/// A score falls to a quarter when a smooth arc is halved, to half at a kink, to 0.71 at a vertical
/// tangent; where it stays above this share, so many times in a row, halving is in vain.
constexpr double kHelps = 0.8;
constexpr std::uint8_t kMaxInVain = 14;
/// The same for normals: around a point where sheets meet they turn however small the leaf, until
/// it is too small to see.
constexpr std::uint8_t kMaxTurnedInVain = 12;
/// After every so many halvings in vain, of distances and of normals, a leaf's sides are looked at
/// for jumps and creases. A leaf halved the wrong way once is no better for it, either.
constexpr std::uint8_t kLookAfter = 3;
constexpr std::uint8_t kLookAfterTurned = 2;
/// Halvings of a root cell that the rim crosses, to begin with, and of one in which a cut is more
/// than one line, at most.
constexpr int kRimHalvings = 4;
constexpr int kMostCutHalvings = 14;
/// As many again along a pole as it took to come near it.
constexpr int kMostHalvingsBesidePole = 2 * kMostCutHalvings;
/// Halvings of a root cell, at most, that lead to where the surface is defined, and from there on
/// those that follow its rim: at a corner of two rims with upright tangents it takes that many.
/// Where rims cross at a pole, more than those of a cut would do no good.
constexpr int kMostSeekHalvings = 24;
constexpr int kMostRimHalvings = 24;

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
  std::vector<std::uint32_t> witnesses;  ///< against it
  double parent_distance;
  double parent_turn;
};

std::uint8_t count_in_vain(std::uint8_t before, double score, double parent_score) {
  return score <= std::max(kHelps * parent_score, 1.0) ? std::uint8_t{0}
                                                       : static_cast<std::uint8_t>(before + 1);
}

/// A candidate that was judged.
struct Judged {
  Candidate candidate;
  Verdict verdict;
};

class Refiner {
 public:
  Refiner(std::span<const Witness> witnesses, const RefineOptions& options, const Grid& grid,
          Oscillation known, Lattice& lattice)
      : witnesses_(witnesses),
        options_(options),
        lattice_(lattice),
        judge_(options, grid, lattice),
        known_(std::move(known)),
        oscillation_(grid, options.share) {}

  /// Judges a generation, and puts the next one in its place.
  void advance(std::vector<Candidate>& candidates) {
    std::vector<Leaf> leaves;
    leaves.reserve(candidates.size());
    for (Candidate& candidate : candidates) {
      request_samples(candidate.leaf, lattice_);
      leaves.push_back(candidate.leaf);
    }
    lattice_.evaluate(options_.threads);
    const Glances glances = judge_many(leaves, options_, judge_, lattice_);
    next_.clear();
    oscillation_.clear();
    std::vector<Judged> rims;
    std::vector<Judged> doubtful;
    std::vector<Judged> others;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const Glance& glance = glances.leaves[k];
      if (glance.passes && candidates[k].witnesses.empty()) {
        keep_good(leaves[k], glance.distance);
        continue;
      }
      const int defined = glance.is_known ? 9 : count_defined(lattice_, leaves[k]);
      if (defined == 0) {
        seek(candidates[k]);
        continue;
      }
      if (defined < 9) {
        if (!keep_oscillating_rim(leaves[k])) rims.push_back({candidates[k], {}});
        continue;
      }
      Judged judged = judge(std::move(candidates[k]), glances.verdict(glance));
      const Leaf& leaf = judged.candidate.leaf;
      if (!leaf.leads_to_pole) {
        oscillation_.add(leaf, judged.verdict.distance, lattice_);
      }
      const bool is_open = judged.verdict.is_folded || judged.verdict.may_jump || is_doubtful(leaf);
      (is_open ? doubtful : others).push_back(std::move(judged));
    }
    std::erase_if(doubtful, [&](const Judged& judged) {
      const Leaf& leaf = judged.candidate.leaf;
      const bool is_hopeless =
          oscillates(leaf) || known_.splits_foreseen_u(leaf, lattice_).has_value();
      if (is_hopeless) others.push_back(judged);
      return is_hopeless;
    });
    for (const Judged& judged : others) settle(judged);
    judge_rims(rims);
    look_for_cuts(doubtful);
    std::swap(candidates, next_);
  }

  Refinement take() { return std::move(result_); }

 private:
  void keep_good(Leaf leaf, float distance) {
    leaf.in_vain = leaf.turned_in_vain = 0;
    leaf.given_up = false;
    leaf.known_error = distance;
    result_.leaves.push_back(leaf);
  }

  /// Halves a leaf that is cut until the cut is nearly straight in it; what remains to be done
  /// fresh samples tell. The halves do not know yet what cuts them.
  void judge_cut(const Judged& judged, Leaf leaf, bool across_u, int wanted_halvings) {
    const int done = halvings(leaf);
    const auto halves = done < wanted_halvings ? halve_if_allowed(leaf, across_u) : std::nullopt;
    if (!halves) {
      leaf.given_up = done >= (leaf.on_rim ? most_rim_halvings(leaf) : kMostCutHalvings) ||
                      lattice_.is_full(options_.max_triangles);
      result_.leaves.push_back(leaf);
      return;
    }
    for (Leaf half : *halves) {
      half.on_rim = false;
      push(half, judged.candidate, judged.candidate.parent_distance, judged.candidate.parent_turn);
    }
  }

  /// Halves a leaf that is defined at none of its samples until it is, if it is known to be
  /// defined somewhere.
  void seek(const Candidate& candidate) {
    const Leaf& leaf = candidate.leaf;
    const bool is_known = !candidate.witnesses.empty() || has_defined_corner(leaf, lattice_);
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
  bool keep_oscillating_rim(Leaf leaf) {
    if (!known_.contains(leaf, lattice_)) return false;
    leaf.on_rim = true;
    note_oscillation(leaf);
    result_.leaves.push_back(leaf);
    return true;
  }

  void note_oscillation(Leaf& leaf) {
    leaf.oscillates = true;
    known_.add(leaf, lattice_);
    if (!result_.oscillates) result_.oscillates = lattice_.parameters(leaf.middle());
  }

  /// Leaves on the rim. Where the surface goes to infinity there, they are halved until what is cut
  /// off with the rim is clipped anyway.
  void judge_rims(std::span<const Judged> rims) {
    std::vector<Leaf> fine;
    for (const Judged& rim : rims) {
      const bool is_fine = halvings(rim.candidate.leaf) >= kRimHalvings;
      if (is_fine && options_.clip && !judge_.is_outside(rim.candidate.leaf))
        fine.push_back(rim.candidate.leaf);
    }
    look_at(fine);
    for (const Judged& rim : rims) {
      Leaf leaf = rim.candidate.leaf;
      leaf.on_rim = true;
      // A pole that cut the whole may be its rim.
      if (leaf.leads_to_pole) leaf.is_split = leaf.leads_to_pole = false;
      const bool goes_far =
          options_.clip && !judge_.is_outside(leaf) && has_cut(Cut::Pole, leaf, lattice_);
      judge_cut(rim, leaf, judge_.splits_rim_u(leaf),
                goes_far || is_torn(leaf.samples) ? kMostCutHalvings : rim_halvings(leaf));
    }
  }

  /// Whether one of the samples has no limit: what of the leaf it is a corner of is left out.
  bool is_torn(const SampleVertices& samples) const {
    const auto has_none = [this](std::uint32_t vertex) {
      return lattice_.hole(vertex) == Hole::Kind::NoLimit;
    };
    return std::ranges::any_of(samples.corner, has_none) ||
           std::ranges::any_of(samples.side, has_none) || has_none(samples.centre);
  }

  /// Halvings of a leaf that the rim crosses: one more for each time that fresh samples found it to
  /// be twice as far off as allowed.
  int rim_halvings(const Leaf& leaf) const {
    return std::min(kRimHalvings + std::ilogb(leaf.strictness), most_rim_halvings(leaf));
  }
  int most_rim_halvings(const Leaf& leaf) const {
    const bool goes_far = has_cut(Cut::Pole, leaf, lattice_) || has_cut(Cut::Face, leaf, lattice_);
    return goes_far ? kMostCutHalvings : kMostRimHalvings;
  }

  /// Halvings of a leaf that is cut. A pole is cut like a rim.
  static int wanted_halvings(const CutCount& cuts) {
    if (!cuts.is_through()) return kMostCutHalvings;
    return cuts.leads_to_pole ? kRimHalvings : 0;
  }

  /// Whether a leaf's sides are to be looked at.
  static bool is_doubtful(const Leaf& leaf) {
    const auto is_due = [](std::uint8_t in_vain, std::uint8_t period) {
      return in_vain > 0 && in_vain % period == 0;
    };
    return leaf.is_split || is_due(leaf.in_vain, kLookAfter) ||
           is_due(leaf.turned_in_vain, kLookAfterTurned);
  }

  /// Looks at the sides of leaves for what cuts them.
  void look_at(std::span<const Leaf> leaves) {
    const std::vector<Side> sides = unsearched(leaves);
    if (!sides.empty()) find_crossings(sides, crossing_options(), lattice_);
  }

  std::vector<Side> unsearched(std::span<const Leaf> leaves) const {
    std::vector<Side> sides;
    for (const Leaf& leaf : leaves) append_unsearched(leaf, lattice_, sides);
    sort_sides(sides);
    return sides;
  }

  CrossingOptions crossing_options() const {
    return {options_.tolerance, false, options_.threads, options_.clip, options_.max_triangles};
  }

  /// An arc that is no small one may jump; only normals that are opposed, or never agree, tell of a
  /// crease.
  void look_for_cuts(std::span<Judged> doubtful) {
    std::vector<Leaf> bent;
    std::vector<Leaf> others;
    for (const Judged& judged : doubtful) {
      const Leaf& leaf = judged.candidate.leaf;
      const bool may_crease = judged.verdict.is_folded || is_doubtful(leaf);
      (may_crease ? others : bent).push_back(leaf);
    }
    look_at(others);
    find_jumps(unsearched(bent), crossing_options(), lattice_);
    // Before halves put new vertices on the sides.
    std::vector<CutCount> cuts_of(doubtful.size());
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      Leaf& leaf = doubtful[k].candidate.leaf;
      const CutCount cuts = count_cuts(leaf, lattice_);
      leaf.leads_to_pole = cuts.leads_to_pole;
      if (leaf.leads_to_pole) doubtful[k].verdict.distance = doubtful[k].verdict.gap;
      cuts_of[k] = cuts;
      leaf.is_split = cuts.crossings > 0 || (doubtful[k].verdict.is_folded && cuts.is_through());
    }
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      Leaf& leaf = doubtful[k].candidate.leaf;
      const bool is_clear = cuts_of[k].is_through();
      if (leaf.is_split && !is_clear && judge_.is_too_small_to_see(leaf)) {
        leaf.given_up = true;
        result_.leaves.push_back(leaf);
      } else if (leaf.is_split) {
        judge_cut(doubtful[k], leaf, cuts_of[k].is_parted_across_u(leaf),
                  wanted_halvings(cuts_of[k]));
      } else {
        settle(doubtful[k]);
      }
    }
  }

  /// What the samples say of a leaf. `known`: that, or nullptr.
  Judged judge(Candidate candidate, const Verdict* known) const {
    Judged judged{std::move(candidate), {}};
    Leaf& leaf = judged.candidate.leaf;
    if (judge_.is_clipped(leaf)) return judged;
    judged.verdict = known != nullptr ? *known : judge_.score(leaf);
    if (leaf.leads_to_pole) judged.verdict.distance = judged.verdict.gap;
    const double distance = judged.verdict.distance.worst() * leaf.strictness;
    const double turn = judged.verdict.turn.worst() * leaf.turn_strictness;
    const auto& [whole, witnesses, parent_distance, parent_turn] = judged.candidate;
    leaf.in_vain = count_in_vain(leaf.in_vain, distance, parent_distance);
    leaf.turned_in_vain = count_in_vain(leaf.turned_in_vain, turn, parent_turn);
    return judged;
  }

  /// Keeps a leaf, or goes on with its halves.
  void settle(const Judged& judged) {
    Leaf leaf = judged.candidate.leaf;
    const Verdict& verdict = judged.verdict;
    const double distance = verdict.distance.worst() * leaf.strictness;
    const bool turn_counts = !lattice_.has_many(allowed_for_normals(options_.max_triangles));
    const double turn = turn_counts ? verdict.turn.worst() * leaf.turn_strictness : 0;
    // Toward a pole errors grow as leaves shrink: there is always more to do. Beside it, where the
    // surface comes back into sight, there is not.
    const int enough = verdict.may_jump ? kMostCutHalvings : kMostHalvingsBesidePole;
    const bool is_cut_off =
        leaf.leads_to_pole && (halvings(leaf) >= enough || judge_.is_outside(leaf));
    const bool is_far = distance > 1 && leaf.in_vain <= kMaxInVain && !is_cut_off;
    const bool is_turned = turn > 1 && leaf.turned_in_vain <= kMaxTurnedInVain && !is_cut_off;
    const Scores scores = !is_turned ? verdict.distance
                          : !is_far  ? verdict.turn
                                     : worse(verdict.distance, verdict.turn);
    const bool passes = !is_far && !is_turned;
    const Witness* const missed = passes ? missed_witness(judged) : nullptr;
    std::optional<std::array<Leaf, 2>> halves;
    if (!passes || missed != nullptr) {
      halves = halves_of(
          leaf, missed != nullptr ? judge_.splits_u(leaf, *missed) : judge_.splits_u(leaf, scores));
    }
    if (!halves) {
      leaf.given_up = distance > 1 || turn > 1;
      leaf.known_error = static_cast<float>(verdict.distance.worst());
      result_.leaves.push_back(leaf);
      return;
    }
    for (const Leaf& half : *halves) push(half, judged.candidate, distance, turn);
  }

  bool oscillates(const Leaf& leaf) const {
    return oscillation_.contains(leaf, lattice_) || known_.contains(leaf, lattice_);
  }

  /// Nothing where the limit is reached, or the surface oscillates.
  std::optional<std::array<Leaf, 2>> halves_of(Leaf& leaf, bool across_u) {
    leaf.oscillates = false;
    if (oscillates(leaf)) {
      note_oscillation(leaf);
      return std::nullopt;
    }
    return halve_if_allowed(leaf, known_.splits_foreseen_u(leaf, lattice_).value_or(across_u));
  }

  /// Nothing where the limit is reached.
  std::optional<std::array<Leaf, 2>> halve_if_allowed(const Leaf& leaf, bool across_u) {
    const bool full = lattice_.is_full(options_.max_triangles);
    result_.reached_limit = result_.reached_limit || full;
    return full ? std::nullopt : halve(leaf, across_u, lattice_);
  }

  /// Leaves a candidate's half with the witnesses that are in it.
  void push(const Leaf& half, const Candidate& whole, double distance, double turn) {
    Candidate candidate{half, {}, distance, turn};
    if (!whole.witnesses.empty()) {
      const dvec2 low = lattice_.parameters(half.low);
      const dvec2 size = lattice_.parameters(half.high) - low;
      for (const std::uint32_t witness : whole.witnesses) {
        const dvec2 part = (witnesses_[witness].uv - low) / size;
        const bool is_inside = part.x >= 0 && part.x <= 1 && part.y >= 0 && part.y <= 1;
        if (is_inside) candidate.witnesses.push_back(witness);
      }
    }
    next_.push_back(std::move(candidate));
  }

  /// The first witness that a leaf misses.
  const Witness* missed_witness(const Judged& judged) const {
    const auto& [leaf, witnesses, parent_distance, parent_turn] = judged.candidate;
    for (const std::uint32_t witness : witnesses) {
      if (judge_.misses(leaf, witnesses_[witness])) return &witnesses_[witness];
    }
    return nullptr;
  }

  std::span<const Witness> witnesses_;
  const RefineOptions& options_;
  Lattice& lattice_;
  Judge judge_;
  std::vector<Candidate> next_;
  Oscillation known_;        // among leaves that are not halved any more
  Oscillation oscillation_;  // of this generation
  Refinement result_;
};

}  // namespace

bool has_defined_corner(const Leaf& leaf, const Lattice& lattice) {
  bool has = false;
  for_sides(leaf, lattice,
            [&](std::uint32_t a, std::uint32_t) { has = has || lattice.is_defined(a); });
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

std::optional<std::array<Leaf, 2>> halve(const Leaf& leaf, bool across_u, Lattice& lattice) {
  if ((across_u ? leaf.size_u() : leaf.size_v()) < 2) return std::nullopt;
  const LatticePlace middle = leaf.middle();
  std::array<Leaf, 2> halves = {leaf, leaf};
  for (Leaf& half : halves) half.followed = 0;
  halves[0].samples = leaf.samples.of_half(across_u, true);
  halves[1].samples = leaf.samples.of_half(across_u, false);
  if (across_u) {
    halves[0].high.u = halves[1].low.u = middle.u;
  } else {
    halves[0].high.v = halves[1].low.v = middle.v;
  }
  const std::size_t first = across_u ? 0 : 1;
  for (const std::size_t k : {first, first + 2}) lattice.use_middle(leaf, k);
  return halves;
}

Refinement refine(std::span<const Leaf> active, std::span<const Witness> witnesses,
                  Oscillation known, const RefineOptions& options, const Grid& grid,
                  Lattice& lattice) {
  Refiner refiner(witnesses, options, grid, std::move(known), lattice);
  std::vector<Candidate> candidates;
  candidates.reserve(active.size());
  for (const Leaf& leaf : active) {
    constexpr double kNotKnown = std::numeric_limits<double>::infinity();
    candidates.push_back({leaf, {}, kNotKnown, kNotKnown});
    candidates.back().leaf.followed = 0;
  }
  for (std::uint32_t k = 0; k < witnesses.size(); ++k) {
    candidates[witnesses[k].cell].witnesses.push_back(k);
  }
  // A generation past the one that finds poles, which may be on a few cells' sides only.
  for (bool has_poles = false; !candidates.empty(); has_poles = lattice.has_poles()) {
    refiner.advance(candidates);
    if (options.until == Until::OneGeneration || (options.until == Until::Poles && has_poles)) {
      break;
    }
  }
  return refiner.take();
}

}  // namespace saddle
