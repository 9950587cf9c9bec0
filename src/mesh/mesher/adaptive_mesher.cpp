#include "mesh/mesher/adaptive_mesher.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/heap.h"
#include "mesh/error/left_out_leaves.h"
#include "mesh/features/robust_box.h"
#include "mesh/grid/degenerate.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/grid/weld.h"
#include "mesh/mesher/edge_features.h"
#include "mesh/mesher/envelope.h"
#include "mesh/mesher/follow_features.h"
#include "mesh/mesher/halving_limits.h"
#include "mesh/mesher/pole_features.h"
#include "mesh/mesher/solve_inner_vertices.h"
#include "mesh/mesher/walls.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"
#include "mesh/tree/flip.h"
#include "mesh/tree/halve.h"
#include "mesh/tree/leaf_border.h"

namespace saddle {

namespace {

/// Rounds of refinement after the first subdivision, at most. Most surfaces take less than 20.
/// Features that touch take more: the wedge between them is halved leaf by leaf.
constexpr int kMostRounds = 512;
/// Where validation keeps failing, leaves are searched for features after every 4 rounds: one round
/// leads to a feature that is found, and halves a leaf once without it.
constexpr int kFeaturePeriod = 4;
/// The share of the triangles that the first subdivision may take: 7/8. The rest is for errors that
/// only validation finds, as of waves that fit into a cell.
constexpr double kFirst = 0.875;

/// In tolerances: leaves with a jump, with several features, or with a strip or gap that is thinner
/// than they are, are halved if they are farther off. They are measured at a few places: where
/// lines cross in between, that misses up to a quarter of the distance.
constexpr double kAimOnLines = 0.8;

/// Which of the grid's lines are drawn, so that their chords are visible.
std::vector<std::uint8_t> seen_lines(std::span<const double> lines, std::span<const double> drawn) {
  std::vector<std::uint8_t> seen;
  for (const double line : lines) seen.push_back(std::ranges::count(drawn, line) > 0 ? 1 : 0);
  return seen;
}

/// Appends leaves, with their counterexamples.
void append_leaves(ActiveLeaves& active, ActiveLeaves more) {
  for (Counterexample& counterexample : more.counterexamples)
    counterexample.cell += active.leaves.size();
  std::ranges::copy(more.leaves, std::back_inserter(active.leaves));
  std::ranges::copy(more.counterexamples, std::back_inserter(active.counterexamples));
}

/// The vertex of the root grid at a place.
std::optional<std::uint32_t> root_vertex(const Grid& grid, const dvec2& uv) {
  const auto nearest = [](const std::vector<double>& lines, double place) {
    const auto line = std::ranges::min_element(
        lines, {}, [place](double line) { return std::fabs(line - place); });
    return static_cast<std::size_t>(line - lines.begin());
  };
  const std::size_t vertex = grid.vertex(nearest(grid.u, uv.x), nearest(grid.v, uv.y));
  const bool is_there = glm::length((grid.uv(vertex) - uv) / grid.range) < kSame;
  return is_there ? std::optional(static_cast<std::uint32_t>(vertex)) : std::nullopt;
}

/// The landmarks of the probe, and the singular points that are no vertices of the root grid.
std::vector<Landmark> landmarks_of(const Surface& surface, const MeshPlan& plan, const Grid& grid,
                                   unsigned threads) {
  std::vector<Landmark> landmarks = plan.probe.landmarks().places;
  std::vector<dvec2> points = plan.singular.points;
  std::erase_if(points, [&grid](const dvec2& uv) { return root_vertex(grid, uv).has_value(); });
  const std::vector<dvec3> positions = evaluate_positions(surface, points, threads);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_finite(positions[k])) landmarks.push_back({points[k], positions[k], dvec2(0), dvec2(0)});
  }
  return landmarks;
}

}  // namespace

AdaptiveMesher::AdaptiveMesher(const Surface& surface, const MeshRequest& request, MeshPlan& plan)
    : surface_(surface),
      request_(request),
      limits_{plan.aim,
              request.normal_tolerance,
              {request.max_triangles, !request.samples, request.least_effort},
              request.clip,
              seen_lines(plan.lines.u, plan.drawn.u),
              seen_lines(plan.lines.v, plan.drawn.v),
              request.threads,
              plan.tolerance.share_of_diagonal(plan.probe.bounds()),
              request.leaves_at_a_time},
      coarser_(plan.coarser),
      grid_(sample_grid(surface, std::move(plan.lines.u), std::move(plan.lines.v), request.threads,
                        request.clip)),
      seams_(weld_if_two_dimensional(plan.probe)),
      points_(grid_.mesh),
      tree_(surface, grid_, request.threads),
      landmarks_(landmarks_of(surface, plan, grid_, request.threads), request.clip, grid_, tree_),
      validation_(surface, limits_, grid_, tree_, landmarks_, mesh_),
      direction_(limits_, grid_, tree_, mesh_),
      proof_(surface, grid_, tree_, request_.clip, share_of_searches(request.least_effort),
             request.threads),
      hulls_(surface),
      open_(surface, grid_, tree_, hulls_, request_.clip, request.threads),
      predicted_(predict(plan)) {
  for (const dvec2& uv : plan.singular.points) {
    if (const auto vertex = root_vertex(grid_, uv)) tree_.geometry().make_singular(*vertex);
  }
  if (seams_.any()) tree_.edges().set_has_seams();
  if (request.stop != MeshRequest::Stop::AtPolesOrFar) return;
  const Bounds most = rough_box(plan.probe.positions());
  const dvec3 far(request.far * most.diagonal());
  proportionate_ = {most.low - far, most.high + far};
}

void AdaptiveMesher::run(std::vector<Counterexample> counterexamples) {
  find_far_vertices();
  const Until until = stops_early() ? Until::OneGeneration
                      : may_stop()  ? Until::Poles
                                    : Until::Done;
  if (grid_.cell_count() <= limits_.leaves_at_a_time)
    tree_.geometry().add_middles(request_.threads);
  refine({{}, std::move(counterexamples), true}, {until, limits_.triangles.part(kFirst)});
  needs_other_box_ = request_.needs_other_box &&
                     request_.needs_other_box(box_beside_poles(tree_, request_.threads));
  for (int round = 0; !stops_early(); ++round) {
    if (round == kMostRounds) {
      if (certifies()) find_features();  // they count as errors
      break;
    }
    if (!surface_.may_go_on()) {
      reached_limit_ = true;
      break;
    }
    ActiveLeaves active = next_active();
    if (active.leaves.empty()) break;
    if (round % kFeaturePeriod == kFeaturePeriod - 1 && certifies()) {
      append_leaves(active, activate_with_features());
    }
    refine(std::move(active), {until, limits_.triangles});
  }
  if (stops_early()) return;
  ask_forgotten_samples();
  leave_out_unclear();
  const bool is_finished = !reached_limit_ || !is_refined();
  if (is_finished) singularities_ = leave_out_singularities(surface_, limits_, tree_, mesh_);
  cut_walls(limits_, is_finished, tree_, mesh_);
}

/// Runs the checks in the order of their cost and returns the leaves of the first that finds any:
/// validation, validation of changed polygons, validation at singular vertices, interval proofs.
ActiveLeaves AdaptiveMesher::next_active() {
  ActiveLeaves active{halve_failed(), {}};
  if (active.leaves.empty() && validation_.revalidate()) active.leaves = halve_failed();
  if (active.leaves.empty() && validation_.validate_singular()) active.leaves = halve_failed();
  if (active.leaves.empty()) {
    leave_out_unclear();
    active.leaves = halve_missed();
  }
  if (active.leaves.empty() && certifies()) active = activate_refuted();
  if (active.leaves.empty() && certifies()) active = activate_with_features();
  if (active.leaves.empty() && !may_grow()) active = activate_jumping();
  return active;
}

LeafTriangles& AdaptiveMesher::triangulate(MeshReport& report) {
  validation_.triangulate(report);
  if (request_.clip && tree_.edges().has_jumps())
    remove_walls(surface_, *request_.clip, grid_.mesh, request_.threads, mesh_);
  if (has_shared_chords_ || seams_.has_folds()) flip_shared_chords(grid_, mesh_.triangles);
  return mesh_.triangles;
}

void AdaptiveMesher::reach_extremes() {
  if (oscillates_) saddle::reach_extremes(surface_, mesh_.leaves, request_.threads, tree_, grid_);
}

/// Whole leaves without some of their triangles have no proof, unless measured distances gave one
/// or the leaves are smaller than the tolerance.
void AdaptiveMesher::leave_flat_unproved(const LeafTriangles& triangles) {
  std::vector<Leaf> flat;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    if (!mesh_.leaves[k].state.is_whole() || triangles.ranges[k].is_complete()) continue;
    if (proof_.is_proved(mesh_, k)) continue;
    Bounds bounds;
    for (const dvec3& p : corner_positions(mesh_.leaves[k], tree_)) bounds.add(p);
    if (!(bounds.diagonal() <= mesh_.allowed[k])) flat.push_back(mesh_.leaves[k]);
  }
  proof_.leave_unproved(flat);
}

void AdaptiveMesher::complete(const LeafTriangles& triangles, MeshReport& report) {
  if (!request_.clip) leave_flat_unproved(triangles);
  landmarks_.complete(triangles.all, report.tolerance.value_or(0), report);
  for (const auto& [k, farthest] :
       measure_left_out(mesh_, report.max_error, grid_, request_.clip, request_.threads, tree_)) {
    if (farthest.distance > std::max(report.max_error, mesh_.allowed[k]))
      report.worst_place = farthest.uv;
    report.max_error = std::max(report.max_error, farthest.distance);
  }
  report.cells = mesh_.leaves.size();
  const bool stopped = reached_limit_ && is_refined();
  report.reached_limit = report.reached_limit || stopped;
  report.budget_spent = stopped && tree_.budget().is_spent(limits_.triangles);
  if (stopped) report.shortage = shortage();
  report.coarse_normals = coarse_normals_;
  report.oscillates = oscillates_;
  proof_.complete(report.reached_limit, hulls_, report);
  report_seams(seams_, report);
}

Seams AdaptiveMesher::weld_if_two_dimensional(const Probe& probe) {
  if (probe.component()) grid_.range = probe.component()->where.high - probe.component()->where.low;
  if (grid_.left_out_count == grid_.cell_count()) {
    set_extent(grid_, probe.bounds());
    return {};
  }
  require_two_dimensional(surface_, grid_, request_.threads);
  return weld(surface_, request_.threads, grid_);
}

TraceOptions AdaptiveMesher::trace_options() const {
  return {limits_.tolerance, false, request_.threads, request_.clip, limits_.triangles};
}

/// Whether one more halving could exceed the limit of triangles or of effort. Notes it for the
/// report.
bool AdaptiveMesher::stop_if_full() {
  const bool full = tree_.budget().is_full(limits_.triangles);
  reached_limit_ = reached_limit_ || full;
  return full;
}

bool AdaptiveMesher::is_clipped(const Leaf& leaf) const {
  return saddle::is_clipped(leaf, request_.clip, tree_);
}

bool AdaptiveMesher::crosses_box(const Leaf& leaf) const {
  return request_.clip && std::ranges::any_of(corner_positions(leaf, tree_), [&](const dvec3& p) {
           return is_finite(p) && !request_.clip->contains(p);
         });
}

void AdaptiveMesher::append(Subdivision subdivision) {
  reached_limit_ = reached_limit_ || subdivision.reached_limit;
  if (!oscillates_) oscillates_ = subdivision.oscillates;
  has_forgotten_ = has_forgotten_ || subdivision.has_forgotten;
  if (mesh_.leaves.empty()) {
    mesh_.leaves = std::move(subdivision.leaves);
  } else {
    mesh_.leaves.insert(mesh_.leaves.end(), subdivision.leaves.begin(), subdivision.leaves.end());
  }
  empty_.insert(empty_.end(), subdivision.empty.begin(), subdivision.empty.end());
}

/// Tests new vertices.
void AdaptiveMesher::find_far_vertices() {
  if (!may_stop()) return;
  const auto& position = grid_.mesh.position;
  if (has_forgotten_) seen_ = 0;  // others may have their numbers
  for (; seen_ < position.size(); ++seen_) {
    const dvec3& p = position[seen_];
    if (!proportionate_.contains(p) && is_finite(p)) far_vertices_.add(p);
  }
}

/// Subdivides active leaves, follows the features found on their sides, and validates the leaves
/// that are new or cut.
void AdaptiveMesher::refine(ActiveLeaves active, const SubdivisionGoal& goal) {
  if (landmarks_.any() && active.are_roots) {
    landmarks_.append_missed(root_leaves(grid_, 0, grid_.cell_count()), active.counterexamples);
  } else {
    landmarks_.append_missed(active.leaves, active.counterexamples);
  }
  const bool are_roots = active.are_roots;
  const Oscillation known = oscillation();
  append(subdivide(std::move(active), known, limits_, goal, grid_, tree_));
  if (goal.until != Until::OneGeneration) follow_thin_parts(known, goal);
  // Leaves that are halved later take up again what is free.
  if (has_forgotten_ && are_roots) give_back_free_memory();
  find_far_vertices();
  if (stops_early()) return;
  mirror_seams(seams_, request_.threads, grid_, tree_, points_);
  points_.settle();
  std::vector<std::size_t> changed = follow_all_features();
  join_points();
  const std::size_t first = mesh_.sampled_errors.size();
  validation_.validate_new(std::move(changed));
  // Leaves have their own.
  if (has_forgotten_ && !grid_.mesh.triangles.empty()) grid_.forget_triangles();
  if (has_forgotten_ && are_roots) give_back_free_memory();
  place_inner_vertices(first);
}

/// Follows thin parts from leaf to leaf: each leaf that they enter may lead to the next one.
void AdaptiveMesher::follow_thin_parts(const Oscillation& known, const SubdivisionGoal& goal) {
  for (;;) {
    ActiveLeaves entered{reactivate_defined(halved_), {}};
    if (entered.leaves.empty()) return;
    landmarks_.append_missed(entered.leaves, entered.counterexamples);
    append(subdivide(std::move(entered), known, limits_, goal, grid_, tree_));
  }
}

/// Solves for corners of features in new leaves, numbered from `first`, whose chords miss them.
void AdaptiveMesher::place_inner_vertices(std::size_t first) {
  std::optional<Oscillation> unresolvable;  // made for the first cut leaf
  std::vector<std::size_t> which;
  for (std::size_t k = first; k < mesh_.leaves.size(); ++k) {
    const Leaf& leaf = mesh_.leaves[k];
    if (leaf.state.is_whole() || leaf.state.leads_to_pole() || is_clipped(leaf)) continue;
    if (is_refined() && !leaf.state.may_be_halved()) continue;
    if (leaf.state.is_cut_smoothly() && !mesh_.sampled_errors[k].is_off_chord) continue;
    if (!unresolvable) unresolvable.emplace(oscillation());
    if (unresolvable->contains(leaf, tree_)) continue;
    if (request_.clip && crosses_box(leaf)) continue;
    const FeatureCount features = count_features(leaf, tree_);
    const bool is_strip = features.features > 2 && has_thin_strip(leaf, tree_);
    const bool is_solvable = !features.has_more && features.lines == 0 && !features.has_cliffs &&
                             !is_strip && !has_cut(FeatureKind::Pole, leaf, tree_) &&
                             !has_cut(FeatureKind::Face, leaf, tree_) &&
                             !has_cut(FeatureKind::Essential, leaf, tree_) &&
                             !(leaf.state.is_cut_by_feature() && features.only_creases);
    if (is_solvable) which.push_back(k);
  }
  for (std::span<const std::size_t> rest = which; !rest.empty();) {
    if (is_refined() && tree_.budget().is_full(limits_.triangles)) return;
    const auto some = rest.first(std::min(rest.size(), kInBatch));
    validation_.validate_again(solve_inner_vertices(some, limits_, mesh_, tree_));
    rest = rest.subspan(some.size());
  }
}

/// Follows features from leaf to leaf and across seams. Returns the leaves that get their first
/// one.
std::vector<std::size_t> AdaptiveMesher::follow_all_features() {
  std::vector<std::size_t> changed = follow_features(trace_options(), mesh_.leaves, tree_);
  if (!tree_.edges().has_features() || !seams_.any()) return changed;
  trace_features_across_seams(seams_, trace_options(), grid_, tree_);
  const auto more = follow_features(trace_options(), mesh_.leaves, tree_);
  changed.insert(changed.end(), more.begin(), more.end());
  join_features(seams_, grid_, tree_, points_);
  return changed;
}

/// Joins the poles of new leaves, and marks the places whose vertices became one point.
void AdaptiveMesher::join_points() {
  const auto fresh = std::span(mesh_.leaves).subspan(mesh_.sampled_errors.size());
  has_shared_chords_ |= join_poles(fresh, request_.threads, grid_, tree_, points_);
  points_.settle();
  for (const std::uint32_t vertex : points_.take_changed())
    tree_.revisions().mark(tree_.vertices().place_between(vertex));
}

/// How many times worse than allowed the normals of a leaf are, squared, as errors of distances
/// are; 0 beyond the triangles that normals alone are worth.
double AdaptiveMesher::normal_error_ratio(std::size_t number) {
  if (!validation_.is_turned(number)) return 0;
  const Leaf& leaf = mesh_.leaves[number];
  const double share =
      turn_of_line(mesh_.sampled_errors[number].degrees) / request_.normal_tolerance;
  if (!tree_.budget().has_many(limit_for_normals(limits_.triangles))) return share * share;
  if (!coarse_normals_) coarse_normals_ = tree_.vertices().parameters(leaf.middle());
  return 0;
}

/// Where leaves will be unresolvable, by linearisation errors.
Oscillation AdaptiveMesher::predict(const MeshPlan& plan) const {
  Oscillation oscillation(grid_, limits_.share);
  oscillation.predict(plan.probe.linearization_errors(oscillation.narrow_size(), plan.tolerance));
  return oscillation;
}

/// Where leaves are unresolvable.
Oscillation AdaptiveMesher::oscillation() const {
  Oscillation oscillation = predicted_;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    if (!oscillates_ && mesh_.is_near(k)) continue;
    const Leaf& leaf = mesh_.leaves[k];
    if (leaf.state.oscillates()) {
      oscillation.add(leaf, tree_);
    } else if (!leaf.state.leads_to_pole() && !mesh_.is_near(k)) {
      oscillation.add(leaf, {.centre = mesh_.error_ratio(k)}, tree_);
    }
  }
  return oscillation;
}

/// Whether a failed leaf is not halved: it is frozen or clipped, the limit is reached, or the
/// surface oscillates there, which is noted in its state.
bool AdaptiveMesher::stop_if_done(Leaf& leaf, const Oscillation& oscillation) {
  if (!leaf.state.may_be_halved() || is_clipped(leaf) || stop_if_full()) return true;
  if (!oscillation.contains(leaf, tree_)) return false;
  leaf.state.stop_at_oscillation();
  if (!oscillates_) oscillates_ = tree_.vertices().parameters(leaf.middle());
  return true;
}

/// Whether a leaf is too small to see or to halve.
bool AdaptiveMesher::is_small(const Leaf& leaf) const {
  if (leaf.state.leads_to_pole()) return false;
  if (leaf.size_u() < 2 && leaf.size_v() < 2) return true;
  return halvings_of_root(leaf) >= kBoundaryHalvings && direction_.is_too_small_to_see(leaf);
}

/// Whether a sheet of a cut leaf that is not halved further reaches from one face of the clip box
/// to the opposite one: where a jump or a rim meets a pole's line, that is a wall.
bool AdaptiveMesher::is_wall_at_pole(const Leaf& leaf) const {
  const LeafState& state = leaf.state;
  if (!request_.clip || state.is_whole() || state.is_left_out() || state.oscillates()) return false;
  if (state.may_be_halved() && (leaf.size_u() > 1 || leaf.size_v() > 1)) return false;
  return std::ranges::any_of(sub_polygons(leaf, tree_), [&](const Polygon& polygon) {
    Bounds around;
    for (const PolygonCorner& corner : polygon) around.add(grid_.mesh.position[corner.corner]);
    // Corners may be on faces, but for rounding.
    const dvec3 near = kNearly * around.size();
    return glm::any(glm::lessThanEqual(around.low, request_.clip->low + near) &&
                    glm::greaterThanEqual(around.high, request_.clip->high - near));
  });
}

/// Leaves out the small leaves that are cut unclearly, and walls.
void AdaptiveMesher::leave_out_unclear() {
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    const Leaf& leaf = mesh_.leaves[k];
    const bool is_unclear = leaf.state.is_cut_by_feature() && is_small(leaf) &&
                            (direction_.is_cut_unclearly(k) || direction_.joins_sheets(k));
    if (is_unclear || is_wall_at_pole(leaf)) leave_out(k);
  }
}

/// Leaves out a failed leaf that is small: its triangles may be walls between sheets. The vertices
/// around it are within the tolerance.
bool AdaptiveMesher::leave_out(std::size_t number) {
  Leaf& leaf = mesh_.leaves[number];
  const FeatureCount features = count_features(leaf, tree_);
  if (features.has_cliffs && features.is_continuous) return false;
  leaf.state.leave_out_too_small();
  mesh_.sampled_errors[number] = {};
  has_new_left_out_ = true;
  return true;
}

/// Whether leaves were left out, or something in root cells of such leaves has changed, since the
/// last call. Begins a revision.
bool AdaptiveMesher::take_news_of_left_out() {
  const std::uint32_t since = std::exchange(seen_left_out_, tree_.revisions().next());
  return std::exchange(has_new_left_out_, false) ||
         std::ranges::any_of(mesh_.leaves, [&](const Leaf& leaf) {
           return leaf.state.is_too_small() && tree_.revisions().has_changed(leaf, since);
         });
}

/// Removes left-out leaves from the mesh that hold a part of a sheet too far from it, and returns
/// their halves.
std::vector<Leaf> AdaptiveMesher::halve_missed() {
  if (!take_news_of_left_out()) return {};
  ask_forgotten_samples();
  std::vector<std::size_t> missed;
  std::vector<Leaf> halves;
  for (const auto& [k, farthest] :
       measure_too_small(mesh_, grid_, request_.clip, request_.threads, tree_)) {
    const double size = 0.5 * border_of_pieces(mesh_.leaves[k], tree_).value_or(0);
    if (farthest.distance + size <= mesh_.allowed[k] || stop_if_full()) continue;
    const auto both = halve_cut(k);
    if (!both) continue;
    missed.push_back(k);
    for (Leaf half : *both) {
      half.state.take_back();
      halves.push_back(half);
    }
  }
  mesh_.remove(missed);
  return halves;
}

/// Halves a leaf across its features, or else the other way.
std::optional<std::array<Leaf, 2>> AdaptiveMesher::halve_cut(std::size_t number) {
  const Leaf& leaf = mesh_.leaves[number];
  const bool across_u = direction_.is_across_u(number, predicted_);
  const auto both = halve(leaf, across_u, tree_);
  return both ? both : halve(leaf, !across_u, tree_);
}

/// Evaluates the samples again of leaves that passed their estimate, but may be halved.
void AdaptiveMesher::ask_forgotten_samples() {
  if (!has_forgotten_) return;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    Leaf& leaf = mesh_.leaves[k];
    const bool is_good = leaf.state.is_whole() && mesh_.is_near(k) && !validation_.is_turned(k);
    if (!is_good) request_samples(leaf, tree_);
  }
  tree_.geometry().evaluate(request_.threads);
}

/// Whether a leaf was tested before, and its features have not changed since.
bool AdaptiveMesher::was_tested(const Leaf& leaf) const {
  const bool is_cut_anew =
      leaf.state.is_cut_by_feature() && tree_.revisions().has_changed(leaf, halved_);
  return leaf.validated_at <= halved_ && !is_cut_anew;
}

/// The error ratios of a leaf that failed its validation; nothing for others.
std::optional<AdaptiveMesher::Failure> AdaptiveMesher::failure_of(std::size_t number) {
  const Leaf& leaf = mesh_.leaves[number];
  const bool is_cut = leaf.state.is_cut_by_feature();
  const bool is_on_lines = has_thin_vertex(leaf, tree_) ||
                           (!leaf.state.is_whole() && (has_cut(FeatureKind::Jump, leaf, tree_) ||
                                                       has_cut(FeatureKind::Cliff, leaf, tree_) ||
                                                       count_features(leaf, tree_).features > 2));
  if (mesh_.is_near(number) && !is_cut && !is_on_lines && !validation_.is_turned(number))
    return std::nullopt;
  const Failure failure = {mesh_.error_ratio(number) / (is_on_lines ? kAimOnLines : 1),
                           normal_error_ratio(number)};
  const bool fails =
      failure.distance > 1 || failure.normal > 1 || direction_.is_cut_unclearly(number);
  return fails ? std::optional(failure) : std::nullopt;
}

/// Removes failed leaves from the mesh and returns their halves.
std::vector<Leaf> AdaptiveMesher::halve_failed() {
  ask_forgotten_samples();
  const std::uint32_t now = tree_.revisions().next();
  std::optional<Oscillation> unresolvable;  // made for the first failed leaf
  std::vector<std::size_t> failed;
  std::vector<Leaf> halves;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    Leaf& leaf = mesh_.leaves[k];
    if (was_tested(leaf)) continue;  // most leaves, in most rounds
    const bool is_cut = leaf.state.is_cut_by_feature();
    const std::optional<Failure> failure = failure_of(k);
    if (!failure) continue;
    if (is_cut && is_small(leaf) && leave_out(k)) continue;
    if (!unresolvable) unresolvable.emplace(oscillation());
    if (stop_if_done(leaf, *unresolvable)) continue;
    const auto both =
        is_cut ? halve_cut(k) : halve(leaf, direction_.is_across_u(k, predicted_), tree_);
    if (!both) continue;
    failed.push_back(k);
    // The error at a feature says nothing about the size of leaves beside it, and those at a
    // boundary do not add up.
    const double safety = is_cut ? 1 : std::clamp(failure->distance, 1.0, kMostSafety);
    for (Leaf half : *both) {
      if (leaf.state.is_on_boundary()) half.safety = 1;
      half.safety *= static_cast<float>(safety);
      half.normal_safety *= static_cast<float>(std::clamp(failure->normal, 1.0, kMostSafety));
      halves.push_back(half);
    }
  }
  take_thinly_cut(halved_, failed, halves);
  mesh_.remove(failed);
  std::ranges::copy(reactivate_defined(halved_), std::back_inserter(halves));
  halved_ = now;
  return halves;
}

/// Adds whole leaves with undefined vertices in thin parts of sides, which a neighbour has added
/// since a revision.
void AdaptiveMesher::take_thinly_cut(std::uint32_t since, std::vector<std::size_t>& numbers,
                                     std::vector<Leaf>& active) const {
  if (!tree_.thin().any()) return;
  const std::size_t count = numbers.size();
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    const Leaf& leaf = mesh_.leaves[k];
    if (!leaf.state.is_whole() || !leaf.state.may_be_halved()) continue;
    if (!tree_.revisions().has_changed(leaf, since)) continue;
    if (!has_thin_vertex(leaf, tree_) ||
        std::binary_search(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count),
                           k))
      continue;
    numbers.push_back(k);
    active.push_back(leaf);
  }
  std::ranges::sort(numbers);
}

/// Empty leaves with a defined corner, which the halving of a neighbour has added since a revision.
std::vector<Leaf> AdaptiveMesher::reactivate_defined(std::uint32_t since) {
  const auto is_empty = [&](const Leaf& leaf) {
    return !tree_.revisions().has_changed(leaf, since) || !has_defined_corner(leaf, tree_) ||
           stop_if_full();
  };
  const auto first = std::stable_partition(empty_.begin(), empty_.end(), is_empty);
  std::vector<Leaf> defined(first, empty_.end());
  empty_.erase(first, empty_.end());
  return defined;
}

/// Drops the counterexamples in leaves that are not halved. Returns the leaves of the others.
std::set<std::size_t> AdaptiveMesher::drop_done(std::vector<Counterexample>& counterexamples) {
  const Oscillation unresolvable = oscillation();
  std::erase_if(counterexamples, [&](const Counterexample& counterexample) {
    return stop_if_done(mesh_.leaves[counterexample.cell], unresolvable);
  });
  std::set<std::size_t> refuted;
  for (const Counterexample& counterexample : counterexamples) refuted.insert(counterexample.cell);
  return refuted;
}

/// Leaves with counterexamples or jumps in their unproved boxes. Where the work of proofs is done,
/// whole leaves are halved for them once more. Then they only count as errors: more may be
/// anywhere.
ActiveLeaves AdaptiveMesher::activate_refuted() {
  const bool is_spent = proof_.is_spent();
  auto [may_jump, counterexamples] = proof_.prove(mesh_);
  if (is_spent) {
    const bool is_again = std::exchange(has_halved_spent_, true);
    std::erase_if(counterexamples, [&](const Counterexample& counterexample) {
      return is_again || !mesh_.leaves[counterexample.cell].state.is_whole();
    });
  }
  std::set<std::size_t> refuted = drop_done(counterexamples);
  const std::vector<std::size_t> jumping = find_jumping(may_jump);
  refuted.insert(jumping.begin(), jumping.end());
  return activate(refuted, std::move(counterexamples));
}

/// Whether a leaf may be halved for a feature that its samples miss.
bool AdaptiveMesher::may_hide_feature(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  if (leaf.state.is_on_boundary()) return false;
  const bool is_continuous = leaf.state.is_whole() || count_features(leaf, tree_).is_continuous;
  return is_continuous && !leaf.state.oscillates() && !leaf.state.leads_to_pole() &&
         !is_clipped(leaf) && !proof_.is_proved_smooth(mesh_, number);
}

/// Adds features that stick out of the triangles of leaves to their errors. Waves are no features.
std::vector<Counterexample> AdaptiveMesher::find_features() {
  if (oscillates_) return {};
  return open_.refute([this](std::size_t k) { return may_hide_feature(k); }, mesh_);
}

/// Leaves with features that stick out of their triangles.
ActiveLeaves AdaptiveMesher::activate_with_features() {
  std::vector<Counterexample> counterexamples = find_features();
  for (const Counterexample& counterexample : counterexamples) {
    mesh_.leaves[counterexample.cell].state.thaw();
    mesh_.leaves[counterexample.cell].stagnation = 0;
  }
  const std::set<std::size_t> refuted = drop_done(counterexamples);
  return activate(refuted, std::move(counterexamples));
}

/// Leaves with jumps in their unproved boxes.
ActiveLeaves AdaptiveMesher::activate_jumping() {
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t k = 0; k < mesh_.leaves.size(); ++k) {
    if (may_get_jump(mesh_.leaves[k])) leaves.push_back(k);
  }
  const std::vector<std::size_t> jumping = find_jumping(proof_.find_may_jump(leaves, mesh_));
  return activate({jumping.begin(), jumping.end()}, {});
}

/// Whether a leaf would be cut at a jump that is found on its sides.
bool AdaptiveMesher::may_get_jump(const Leaf& leaf) const {
  return leaf.state.may_be_halved() && !leaf.state.is_cut_by_feature() &&
         !leaf.state.leads_to_pole() && !is_clipped(leaf);
}

/// Searches the sides of leaves for jumps where bounds do not exclude one. A jump along the
/// surface, as within a plane, moves no validation point away from the triangles. Returns the
/// leaves with features.
std::vector<std::size_t> AdaptiveMesher::find_jumping(std::span<const std::uint32_t> may_jump) {
  std::set<std::size_t> leaves;
  for (const std::uint32_t k : may_jump) {
    if (may_get_jump(mesh_.leaves[k])) leaves.insert(k);
  }
  std::vector<Leaf> searched(leaves.size());
  std::ranges::transform(leaves, searched.begin(),
                         [this](std::size_t k) { return mesh_.leaves[k]; });
  find_jumps(unsearched_sides(searched, request_.threads, tree_), trace_options(), tree_);
  std::vector<std::size_t> jumping;
  for (const std::size_t k : leaves) {
    Leaf& leaf = mesh_.leaves[k];
    const bool is_cut = count_features(leaf, tree_).features > 0;
    leaf.state.set_features(is_cut, false);
    if (is_cut) jumping.push_back(k);
  }
  return jumping;
}

/// Removes leaves from the mesh. The counterexamples' cells become indices of the active leaves.
ActiveLeaves AdaptiveMesher::activate(const std::set<std::size_t>& numbers,
                                      std::vector<Counterexample> counterexamples) {
  const std::vector<std::size_t> removed(numbers.begin(), numbers.end());
  for (Counterexample& counterexample : counterexamples) {
    const auto place = std::ranges::lower_bound(removed, counterexample.cell);
    counterexample.cell = static_cast<std::size_t>(place - removed.begin());
  }
  ActiveLeaves active{{}, std::move(counterexamples)};
  for (const std::size_t k : removed) active.leaves.push_back(mesh_.leaves[k]);
  mesh_.remove(removed);
  return active;
}

}  // namespace saddle
