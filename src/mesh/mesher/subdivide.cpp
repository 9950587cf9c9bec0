#include "mesh/mesher/subdivide.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "base/activity.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/error/error_indicator.h"
#include "mesh/error/estimate_many.h"
#include "mesh/grid/triangulate.h"
#include "mesh/mesher/edge_features.h"
#include "mesh/mesher/halving_limits.h"
#include "mesh/mesher/oscillation.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"
#include "mesh/tree/halve.h"
#include "mesh/tree/leaf_mesh.h"
#include "mesh/tree/place_thin_vertices.h"
#include "mesh/tree/singular_corners.h"

namespace saddle {

namespace {

/// Where an active leaf comes from.
struct Origin {
  std::vector<std::uint32_t> counterexamples;  ///< numbers of those in the leaf
  double parent_distance = kInfinity;          ///< error ratios of the leaf that it is a half of
  double parent_turn = kInfinity;
};

/// An active leaf without an error estimate.
struct Candidate {
  Leaf leaf;
  Origin origin;
};

/// Active leaves of a generation. Leaves stand apart, for loops over many of them.
struct Part {
  std::vector<Leaf> leaves;
  std::vector<Origin> origins;
};

/// A generation: one part, or several if samples may be forgotten.
using Generation = std::deque<Part>;

/// An active leaf with its error estimate.
struct Estimated {
  Candidate candidate;
  CellError error;
};

/// Subdivides active leaves generation by generation.
class Subdivider {
 public:
  Subdivider(const ActiveLeaves& active, const CellLimits& limits, const SubdivisionGoal& goal,
             const Grid& grid, Oscillation known_oscillation, CellTree& tree)
      : counterexamples_(active.counterexamples),
        may_forget_(active.are_roots),
        roots_(active.are_roots ? grid.cell_count() : 0),
        limits_(limits),
        goal_(goal),
        grid_(grid),
        tree_(tree),
        indicator_(limits, grid, tree),
        known_oscillation_(std::move(known_oscillation)),
        oscillation_(grid, limits.share) {
    if (!active.leaves.empty()) next_.push_back(part_of(active.leaves, 0));
  }

  bool has_active() const { return roots_ > 0 || !next_.empty(); }

  /// Estimates the errors of the active leaves and replaces them by the next generation: the halves
  /// of the leaves that fail. Where they are many, some are estimated at a time, and their samples
  /// forgotten.
  void advance() {
    const std::size_t roots = std::exchange(roots_, 0);
    Generation generation = std::exchange(next_, {});
    oscillation_.clear();
    const std::size_t at_a_time = limits_.leaves_at_a_time;
    forgets_ = roots > at_a_time || generation.size() > 1;
    result_.has_forgotten = result_.has_forgotten || forgets_;
    // Room that is not used costs no memory.
    const std::size_t count = result_.leaves.size() + roots + generation.size() * at_a_time;
    if (forgets_ && result_.leaves.capacity() < count) result_.leaves.reserve(2 * count);
    for (std::size_t first = 0; first < roots; first += at_a_time) {
      Part part = part_of(root_leaves(grid_, first, std::min(first + at_a_time, roots)), first);
      advance(part);
    }
    for (; !generation.empty(); generation.pop_front()) advance(generation.front());
  }

  Subdivision take_result() { return std::move(result_); }

 private:
  /// `first`: the number of the first leaf among the active ones, as counterexamples have them.
  Part part_of(std::vector<Leaf> leaves, std::size_t first) const {
    Part part{std::move(leaves), {}};
    part.origins.resize(part.leaves.size());
    for (Leaf& leaf : part.leaves) leaf.followed_at = 0;
    for (std::uint32_t k = 0; k < counterexamples_.size(); ++k) {
      const std::size_t cell = counterexamples_[k].cell;
      if (cell >= first && cell < first + part.leaves.size())
        part.origins[cell - first].counterexamples.push_back(k);
    }
    return part;
  }

  /// Adds a leaf to the next generation.
  void add_active(const Leaf& leaf, Origin origin) {
    const bool is_full =
        may_forget_ && !next_.empty() && next_.back().leaves.size() == limits_.leaves_at_a_time;
    if (next_.empty() || is_full) next_.emplace_back();
    next_.back().leaves.push_back(leaf);
    next_.back().origins.push_back(std::move(origin));
  }

  void keep_passing(Leaf leaf, float distance) {
    leaf.stagnation = leaf.normal_stagnation = 0;
    leaf.known_error = distance;
    if (forgets_) leaf.samples.forget_all_but_corners();
    result_.leaves.push_back(leaf);
  }

  /// Adds the halves of the leaves that fail to the next generation.
  void advance(Part& part) {
    auto& [leaves, origins] = part;
    for (Leaf& leaf : leaves) request_samples(leaf, tree_);
    const std::vector<std::uint32_t> samples = tree_.geometry().evaluate(limits_.threads);
    const std::size_t kept = result_.leaves.size();
    FastCellErrors fast_errors = estimate_many(leaves, limits_, indicator_, tree_);
    place_thin_vertices(leaves_with_thin_parts(part, fast_errors), limits_.tolerance,
                        limits_.threads, tree_);
    estimate_others(leaves, limits_, indicator_, tree_, fast_errors);
    const auto passing =
        static_cast<std::size_t>(std::ranges::count_if(fast_errors.leaves, &FastCellError::passes));
    // Leaves that grow by doubling would have room for up to twice as many.
    if (passing > result_.leaves.size()) result_.leaves.reserve(result_.leaves.size() + passing);
    Doubtful doubtful = keep_clear(part, fast_errors);
    std::erase_if(doubtful.to_search, [&](const Estimated& estimated) {
      const Leaf& leaf = estimated.candidate.leaf;
      const bool is_unresolvable =
          oscillates(leaf) || known_oscillation_.splits_predicted_u(leaf, tree_).has_value();
      if (is_unresolvable) doubtful.smooth.push_back(estimated);
      return is_unresolvable;
    });
    for (const Estimated& estimated : doubtful.smooth) keep_or_halve(estimated);
    halve_boundaries(doubtful.boundaries);
    search_features(doubtful.to_search);
    if (forgets_) forget(samples, std::span(result_.leaves).subspan(kept));
  }

  /// Leaves of which the loops of estimates do not say that they pass: on the boundary, with
  /// samples that show a feature, and others.
  struct Doubtful {
    std::vector<Estimated> boundaries, to_search, smooth;
  };

  /// Keeps leaves that pass at once, and returns the others. Leaves without defined samples are
  /// halved or left out.
  Doubtful keep_clear(Part& part, const FastCellErrors& fast_errors) {
    auto& [leaves, origins] = part;
    Doubtful doubtful;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      const FastCellError& fast = fast_errors.leaves[k];
      const bool is_thinly_cut = has_thin_vertex(leaves[k], tree_);
      if (fast.passes && origins[k].counterexamples.empty() && !is_thinly_cut) {
        keep_passing(leaves[k], fast.distance);
        continue;
      }
      Candidate candidate{leaves[k], std::move(origins[k])};
      const int defined = fast.is_known ? 9 : count_defined(tree_, leaves[k]);
      if (defined == 0 && !is_thinly_cut) {
        seek_defined(candidate);
      } else if (defined < 9 || is_thinly_cut) {
        if (!keep_oscillating_boundary(leaves[k]))
          doubtful.boundaries.push_back({std::move(candidate), {}});
      } else {
        Estimated estimated = estimate(std::move(candidate), fast_errors.error(fast));
        if (!estimated.candidate.leaf.state.leads_to_pole())
          oscillation_.add(estimated.candidate.leaf, estimated.error.distance, tree_);
        auto& to = needs_search(estimated) ? doubtful.to_search : doubtful.smooth;
        to.push_back(std::move(estimated));
      }
    }
    return doubtful;
  }

  bool needs_search(const Estimated& estimated) const {
    return shows_feature(estimated) || (has_landmark(estimated.candidate) &&
                                        missed_counterexample(estimated.candidate) != nullptr);
  }

  /// Forgets samples that none of these leaves has.
  void forget(std::span<const std::uint32_t> samples, std::span<const Leaf> leaves) {
    std::vector<std::uint32_t> needed;
    for (const Leaf& leaf : leaves)
      leaf.samples.for_middles([&](std::uint32_t vertex) { needed.push_back(vertex); });
    std::ranges::sort(needed);
    for (const std::uint32_t vertex : samples) {
      const bool is_needed = std::ranges::binary_search(needed, vertex);
      if (!is_needed && tree_.geometry().can_forget(vertex)) tree_.vertices().forget(vertex);
    }
  }

  /// Leaves that the surface's boundary is known to cross: by samples, by vertices of neighbours,
  /// or by counterexamples.
  std::vector<Leaf> leaves_with_thin_parts(const Part& part,
                                           const FastCellErrors& fast_errors) const {
    std::vector<Leaf> crossed;
    for (std::size_t k = 0; k < part.leaves.size(); ++k) {
      const Leaf& leaf = part.leaves[k];
      const Origin& origin = part.origins[k];
      const int defined = fast_errors.leaves[k].is_known ? 9 : count_defined(tree_, leaf);
      const bool is_crossed = defined == 0   ? is_known_defined(leaf, origin)
                              : defined == 9 ? has_thin_vertex(leaf, tree_) || has_hole(origin)
                                             : true;
      if (is_crossed) crossed.push_back(leaf);
    }
    return crossed;
  }

  bool is_known_defined(const Leaf& leaf, const Origin& origin) const {
    return !origin.counterexamples.empty() || has_defined_corner(leaf, tree_);
  }

  bool has_hole(const Origin& origin) const {
    return std::ranges::any_of(origin.counterexamples, [this](std::uint32_t number) {
      return !is_finite(counterexamples_[number].position);
    });
  }

  /// Halves a leaf until its edge feature is nearly straight; validation points tell whether that
  /// is enough. The features of the halves are counted anew.
  void halve_toward_feature(const Estimated& estimated, Leaf leaf, bool along_u, bool is_coarse) {
    const auto halves = is_coarse ? halve_if_allowed(leaf, along_u) : std::nullopt;
    if (!halves) {
      const int most =
          leaf.state.is_on_boundary() ? most_boundary_halvings(leaf, tree_) : kMostHalvings;
      if (halvings(leaf) >= most || tree_.budget().is_full(goal_.triangles)) leaf.state.freeze();
      result_.leaves.push_back(leaf);
      return;
    }
    for (Leaf half : *halves) {
      half.state.forget_boundary();
      const Origin& origin = estimated.candidate.origin;
      push(half, origin, origin.parent_distance, origin.parent_turn);
    }
  }

  /// Halves a leaf that is defined at none of its samples, if it is known to be defined somewhere.
  void seek_defined(const Candidate& candidate) {
    const Leaf& leaf = candidate.leaf;
    const auto halves = is_known_defined(leaf, candidate.origin)
                            ? halve_if_allowed(leaf, seeks_along_u(candidate))
                            : std::nullopt;
    if (!halves) {
      result_.empty.push_back(leaf);
      return;
    }
    for (Leaf half : *halves) {
      half.sought = static_cast<std::uint8_t>(halvings_of_root(half));
      push(half, candidate.origin, candidate.origin.parent_distance, candidate.origin.parent_turn);
    }
  }

  /// Whether to halve a leaf without defined samples along u: across a narrow part, or else the
  /// longer direction.
  bool seeks_along_u(const Candidate& candidate) const {
    const Leaf& leaf = candidate.leaf;
    for (const std::uint32_t number : candidate.origin.counterexamples) {
      const dvec2& bend = counterexamples_[number].bend;
      if (bend.x > 0 && bend.y == 0 && leaf.size_u() > 1) return true;
      if (bend.y > 0 && bend.x == 0 && leaf.size_v() > 1) return false;
    }
    return leaf.size_u() >= leaf.size_v();
  }

  /// Keeps a leaf with a boundary where the surface is predicted to oscillate. False for others.
  bool keep_oscillating_boundary(Leaf leaf) {
    if (!known_oscillation_.contains(leaf, tree_)) return false;
    leaf.state.cross_boundary();
    note_oscillation(leaf);
    result_.leaves.push_back(leaf);
    return true;
  }

  void note_oscillation(Leaf& leaf) {
    leaf.state.stop_at_oscillation();
    known_oscillation_.add(leaf, tree_);
    if (!result_.oscillates) result_.oscillates = tree_.vertices().parameters(leaf.middle());
  }

  /// Halves leaves with a boundary. Where the surface goes to infinity, they are halved until the
  /// part that is cut off is outside of the clip box.
  void halve_boundaries(std::span<const Estimated> boundaries) {
    std::vector<Leaf> fine;
    for (const Estimated& boundary : boundaries) {
      const bool is_fine = halvings(boundary.candidate.leaf) >= kBoundaryHalvings;
      if (is_fine && limits_.clip && !indicator_.is_outside(boundary.candidate.leaf))
        fine.push_back(boundary.candidate.leaf);
    }
    search_sides(fine);
    std::vector<bool> is_coarse;
    std::vector<Leaf> with_landmarks;  // fine enough but for them
    for (const Estimated& boundary : boundaries) {
      Leaf leaf = boundary.candidate.leaf;
      leaf.state.take_pole_for_boundary();
      const bool goes_far =
          limits_.clip && !indicator_.is_outside(leaf) && has_cut(FeatureKind::Pole, leaf, tree_);
      const int wanted = goes_far || has_essential(leaf.samples) ? kMostCutHalvings
                                                                 : boundary_halvings(leaf, tree_);
      is_coarse.push_back(halvings(leaf) < wanted);
      if (!is_coarse.back() && has_landmark(boundary.candidate)) with_landmarks.push_back(leaf);
    }
    search_sides(with_landmarks);
    for (std::size_t k = 0; k < boundaries.size(); ++k)
      is_coarse[k] = is_coarse[k] || misses_landmark(boundaries[k].candidate);
    for (std::size_t k = 0; k < boundaries.size(); ++k) {
      Leaf leaf = boundaries[k].candidate.leaf;
      leaf.state.take_pole_for_boundary();
      halve_toward_feature(boundaries[k], leaf, indicator_.splits_boundary_u(leaf), is_coarse[k]);
    }
  }

  /// Whether a sample is an essential point: the triangles at it are left out.
  bool has_essential(const SampleVertices& samples) const {
    const auto is_essential = [this](std::uint32_t vertex) {
      return tree_.geometry().singularity(vertex) == PointSingularity::Kind::Essential;
    };
    return std::ranges::any_of(samples.corner, is_essential) ||
           std::ranges::any_of(samples.side, is_essential) || is_essential(samples.centre);
  }

  /// Searches the sides of leaves for features.
  void search_sides(std::span<const Leaf> leaves) {
    const std::vector<Side> sides = unsearched_sides(leaves, limits_.threads, tree_);
    if (!sides.empty()) trace_features(sides, trace_options(), tree_);
  }

  TraceOptions trace_options() const {
    return {limits_.tolerance, false, limits_.threads, limits_.clip, goal_.triangles};
  }

  /// Whether the samples of a leaf show a feature, or errors that do not fall may hide one.
  static bool shows_feature(const Estimated& estimated) {
    return estimated.error.is_folded || estimated.error.may_jump ||
           is_search_due(estimated.candidate.leaf);
  }

  /// Searches the sides of leaves and halves those with features. Searches for creases, too, in
  /// folded leaves and where a search is due; in others, for jumps only.
  void search_features(std::span<Estimated> to_search) {
    std::vector<Leaf> only_jumps;
    std::vector<Leaf> all_features;
    for (const Estimated& estimated : to_search) {
      const Leaf& leaf = estimated.candidate.leaf;
      const bool may_crease = estimated.error.is_folded || is_search_due(leaf);
      (may_crease ? all_features : only_jumps).push_back(leaf);
    }
    search_sides(all_features);
    find_jumps(unsearched_sides(only_jumps, limits_.threads, tree_), trace_options(), tree_);
    // Features are counted before halves put new vertices on the sides.
    std::vector<FeatureCount> features_of(to_search.size());
    parallel_chunks(to_search.size(), kSearchedTogether, limits_.threads,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t k = begin; k < end; ++k)
                        features_of[k] = count_features(to_search[k].candidate.leaf, tree_);
                    });
    for (std::size_t k = 0; k < to_search.size(); ++k) {
      Leaf& leaf = to_search[k].candidate.leaf;
      const FeatureCount& features = features_of[k];
      if (features.leads_to_pole) to_search[k].error.distance = to_search[k].error.gap;
      const bool is_creased = to_search[k].error.is_folded && features.is_through();
      // A leaf whose samples show nothing may hold a strip that goes through. Any other part of a
      // feature is too small beside the leaf.
      const bool counts = shows_feature(to_search[k]) || features.is_through();
      leaf.state.set_features(counts && (features.features > 0 || is_creased),
                              features.leads_to_pole);
    }
    for (std::size_t k = 0; k < to_search.size(); ++k) {
      Leaf& leaf = to_search[k].candidate.leaf;
      const bool is_clear = features_of[k].is_through();
      const bool is_cut = leaf.state.is_cut_by_feature();
      const bool may_end = is_cut && !is_clear && halvings_of_root(leaf) >= kBoundaryHalvings;
      const bool is_missed = is_cut && misses_landmark(to_search[k].candidate);
      if (may_end && !is_missed && indicator_.is_too_small_to_see(leaf)) {
        leaf.state.freeze();
        result_.leaves.push_back(leaf);
      } else if (is_cut) {
        halve_toward_feature(to_search[k], leaf, features_of[k].is_parted_along_u(leaf),
                             halvings(leaf) < wanted_halvings(features_of[k]) || is_missed);
      } else {
        keep_or_halve(to_search[k]);
      }
    }
  }

  /// The error estimate of a leaf. `known`: the one that was made before; nullptr for a leaf that
  /// the loops pass, which may have counterexamples.
  Estimated estimate(Candidate candidate, const CellError* known) const {
    Estimated estimated{std::move(candidate), {}};
    Leaf& leaf = estimated.candidate.leaf;
    if (indicator_.is_clipped(leaf)) return estimated;
    estimated.error = known != nullptr ? *known : indicator_.estimate(leaf);
    if (leaf.state.leads_to_pole()) estimated.error.distance = estimated.error.gap;
    const double distance = estimated.error.distance.worst() * leaf.safety;
    const double turn = estimated.error.turn.worst() * leaf.normal_safety;
    const Origin& origin = estimated.candidate.origin;
    leaf.stagnation = count_stagnation(leaf.stagnation, distance, origin.parent_distance);
    leaf.normal_stagnation = count_stagnation(leaf.normal_stagnation, turn, origin.parent_turn);
    return estimated;
  }

  /// Keeps a leaf that passes or that halving does not help; halves any other.
  void keep_or_halve(const Estimated& estimated) {
    Leaf leaf = estimated.candidate.leaf;
    const CellError& error = estimated.error;
    const double distance = error.distance.worst() * leaf.safety;
    const bool turn_counts = !tree_.budget().has_many(limit_for_normals(goal_.triangles));
    const double turn = turn_counts ? error.turn.worst() * leaf.normal_safety : 0;
    // Toward a pole errors grow as leaves shrink, so halvings are limited: further where the leaf
    // may jump than beside the pole.
    const int most = error.may_jump ? kMostCutHalvings : kMostHalvings;
    const bool is_cut_off =
        leaf.state.leads_to_pole() && (halvings(leaf) >= most || indicator_.is_outside(leaf));
    const bool is_far = distance > 1 && leaf.stagnation <= kMaxStagnation && !is_cut_off;
    const bool is_turned = turn > 1 && leaf.normal_stagnation <= kMaxStagnation && !is_cut_off;
    const ErrorRatios ratios = !is_turned ? error.distance
                               : !is_far  ? error.turn
                                          : worse(error.distance, error.turn);
    const bool passes = !is_far && !is_turned;
    const Counterexample* const missed =
        passes ? missed_counterexample(estimated.candidate) : nullptr;
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
    for (Leaf half : *halves) {
      if (missed != nullptr) half.sought = static_cast<std::uint8_t>(halvings_of_root(half));
      push(half, estimated.candidate.origin, distance, turn);
    }
  }

  bool oscillates(const Leaf& leaf) const {
    return oscillation_.contains(leaf, tree_) || known_oscillation_.contains(leaf, tree_);
  }

  /// Empty where the limit is reached or the surface oscillates.
  std::optional<std::array<Leaf, 2>> halves_of(Leaf& leaf, bool along_u) {
    if (oscillates(leaf)) {
      note_oscillation(leaf);
      return std::nullopt;
    }
    return halve_if_allowed(leaf,
                            known_oscillation_.splits_predicted_u(leaf, tree_).value_or(along_u));
  }

  /// Empty where the limit is reached.
  std::optional<std::array<Leaf, 2>> halve_if_allowed(const Leaf& leaf, bool along_u) {
    const bool full = tree_.budget().is_full(goal_.triangles);
    result_.reached_limit = result_.reached_limit || full;
    tell_share(static_cast<double>(tree_.effort().total()) /
               static_cast<double>(most_effort(goal_.triangles.triangles)));
    return full ? std::nullopt : halve(leaf, along_u, tree_);
  }

  /// Adds a half to the next generation, with the counterexamples in it.
  void push(const Leaf& half, const Origin& whole, double distance, double turn) {
    Origin origin{{}, distance, turn};
    if (!whole.counterexamples.empty()) {
      const dvec2 low = tree_.vertices().parameters(half.low);
      const dvec2 size = tree_.vertices().parameters(half.high()) - low;
      for (const std::uint32_t counterexample : whole.counterexamples) {
        const dvec2 part = (counterexamples_[counterexample].uv - low) / size;
        const bool is_inside = part.x >= 0 && part.x <= 1 && part.y >= 0 && part.y <= 1;
        if (is_inside) origin.counterexamples.push_back(counterexample);
      }
    }
    add_active(half, std::move(origin));
    if (forgets_) next_.back().leaves.back().samples.forget_all_but_corners();
  }

  /// Whether a counterexample is a landmark of a sheet at which a leaf is larger than the
  /// tolerance.
  bool is_landmark_of(const Leaf& leaf, const Counterexample& place) const {
    if (!place.speed || !is_finite(place.position)) return false;
    const dvec2 size = tree_.vertices().size(leaf.low, leaf.high());
    return glm::dot(*place.speed, size) > limits_.tolerance(place.position);
  }

  bool has_landmark(const Candidate& candidate) const {
    return std::ranges::any_of(candidate.origin.counterexamples, [&](std::uint32_t number) {
      return is_landmark_of(candidate.leaf, counterexamples_[number]);
    });
  }

  /// The size of a leaf beside that of the box that a counterexample stands for, on the axis along
  /// which the leaf would be halved.
  double boxes_in(const Leaf& leaf, const Counterexample& place) const {
    const dvec2 boxes = tree_.vertices().size(leaf.low, leaf.high()) / place.size;
    return indicator_.splits_u(leaf, place) ? boxes.x : boxes.y;
  }

  /// The triangles that a leaf has in the mesh.
  LeafTriangles triangles_of(const Leaf& leaf) const {
    return triangulate_leaves(std::span(&leaf, 1), std::array{std::size_t{0}}, SingularCorners(),
                              grid_, tree_, 1);
  }

  bool misses(const Array<Triangle>& triangles, const Counterexample& place) const {
    return distance_from(grid_, triangles, place.uv, place.position) >
           limits_.tolerance(place.position);
  }

  /// The first counterexample that a leaf without features misses. A leaf that is larger than the
  /// counterexample's box must not miss it with the triangles of its corners, either: hanging
  /// vertices may hide that it is too large beside the place.
  const Counterexample* missed_counterexample(const Candidate& candidate) const {
    const auto& [leaf, origin] = candidate;
    Array<Triangle> of_corners;
    std::optional<LeafTriangles> triangles;  // made for the first place near those
    for (const std::uint32_t number : origin.counterexamples) {
      const Counterexample& place = counterexamples_[number];
      const double boxes = boxes_in(leaf, place);
      if (!(boxes >= 1)) continue;
      if (of_corners.empty()) cut_cell(grid_, leaf.samples.corner, of_corners);
      const bool is_coarse = boxes > 1 && (!is_finite(place.position) || misses(of_corners, place));
      if (is_coarse) return &place;
      if (!triangles) triangles = triangles_of(leaf);
      if (misses(triangles->all, place)) return &place;
    }
    return nullptr;
  }

  /// Whether a leaf with features misses a landmark with the features that it has.
  bool misses_landmark(const Candidate& candidate) {
    if (!has_landmark(candidate)) return false;
    search_sides(std::span(&candidate.leaf, 1));
    const LeafTriangles triangles = triangles_of(candidate.leaf);
    if (triangles.all.empty()) return true;
    return std::ranges::any_of(candidate.origin.counterexamples, [&](std::uint32_t number) {
      const Counterexample& place = counterexamples_[number];
      return is_landmark_of(candidate.leaf, place) && misses(triangles.all, place);
    });
  }

  std::span<const Counterexample> counterexamples_;
  const bool may_forget_;  // no other leaves have samples
  std::size_t roots_;      // active root cells, which are all
  bool forgets_ = false;   // leaves that pass and halves keep their corners alone
  const CellLimits& limits_;
  SubdivisionGoal goal_;
  const Grid& grid_;
  CellTree& tree_;
  ErrorIndicator indicator_;
  Generation next_;
  Oscillation known_oscillation_;  // of leaves that are no longer active
  Oscillation oscillation_;        // of this generation
  Subdivision result_;
};

}  // namespace

Subdivision subdivide(ActiveLeaves active, Oscillation known_oscillation, const CellLimits& limits,
                      const SubdivisionGoal& goal, const Grid& grid, CellTree& tree) {
  Subdivider subdivider(active, limits, goal, grid, std::move(known_oscillation), tree);
  active.leaves = std::vector<Leaf>();
  // One generation follows the one that finds poles: they may be on the sides of a few cells only.
  for (bool has_poles = false; subdivider.has_active(); has_poles = tree.has_poles()) {
    subdivider.advance();
    if (goal.until == Until::OneGeneration || (goal.until == Until::Poles && has_poles)) {
      break;
    }
  }
  return subdivider.take_result();
}

}  // namespace saddle
