#include "mesh/mesher/adaptive_mesher.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

#include "mesh/features/robust_box.h"
#include "mesh/grid/degenerate.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/grid/weld.h"
#include "mesh/mesher/edge_features.h"
#include "mesh/mesher/envelope.h"
#include "mesh/mesher/follow_features.h"
#include "mesh/mesher/halve.h"
#include "mesh/mesher/subdivide.h"
#include "mesh/proof/small_components.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/flip.h"
#include "mesh/tree/patches.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Times that leaves which fail on fresh samples are halved again.
constexpr int kRounds = 12;
/// The part of the triangles that are allowed that tests may take at first. The rest is for waves
/// that fit into a cell so well that only fresh samples see them.
constexpr double kFirst = 0.875;
/// What a sample finds at a kink says nothing about how fine the mesh must be, and what one finds
/// where a leaf is cut tells of the cut only.
constexpr double kMostSafety = 4;
/// The search for islands may try one box for so many of proofs.
constexpr std::size_t kProofsPerComponent = 12;

/// Which of the grid's lines are among those that are drawn: their chords are seen.
std::vector<std::uint8_t> seen_lines(std::span<const double> lines, std::span<const double> drawn) {
  std::vector<std::uint8_t> seen;
  for (const double line : lines) seen.push_back(std::ranges::count(drawn, line) > 0 ? 1 : 0);
  return seen;
}

std::vector<std::size_t> numbers(std::size_t begin, std::size_t end) {
  std::vector<std::size_t> result(end - begin);
  std::iota(result.begin(), result.end(), begin);
  return result;
}

}  // namespace

AdaptiveMesher::AdaptiveMesher(const Surface& surface, const MeshRequest& request, MeshPlan& plan)
    : surface_(surface),
      request_(request),
      limits_{plan.aim,
              request.normal_tolerance,
              request.method == MeshRequest::Method::Samples ? 0 : request.max_triangles,
              request.clip,
              seen_lines(plan.lines.u, plan.drawn.u),
              seen_lines(plan.lines.v, plan.drawn.v),
              request.threads,
              share_of_diagonal(plan)},
      grid_(sample_grid(surface, std::move(plan.lines.u), std::move(plan.lines.v), request.threads,
                        request.clip)),
      seams_(weld_if_two_dimensional(plan.probe)),
      points_(grid_.mesh),
      tree_(surface, grid_, request.threads),
      indicator_(limits_, grid_, tree_),
      validator_(surface, grid_, tree_, limits_),
      predicted_(predict(plan)),
      budget_(surface.bounds) {
  if (request.stop != MeshRequest::Stop::AtPolesOrFar) return;
  const Bounds most = rough_box(plan.probe.positions());
  const dvec3 far(request.far * most.diagonal());
  proportionate_ = {most.low - far, most.high + far};
}

void AdaptiveMesher::run(std::vector<Counterexample> counterexamples) {
  look_far();
  const Until until = stops_early() ? Until::OneGeneration
                      : may_stop()  ? Until::Poles
                                    : Until::Done;
  tree_.geometry().add_middles(request_.threads);
  const auto first = static_cast<std::size_t>(kFirst * static_cast<double>(limits_.max_triangles));
  add({root_leaves(grid_), std::move(counterexamples)}, {until, first});
  std::size_t component_boxes = budget_.boxes / kProofsPerComponent;
  for (int round = 0; round < kRounds && !stops_early(); ++round) {
    Failed failed{take_failed(), {}};
    if (failed.leaves.empty() && revalidate()) failed.leaves = take_failed();
    if (failed.leaves.empty() && certifies()) failed = take_small_components(component_boxes);
    if (failed.leaves.empty() && validate_singular()) failed.leaves = take_failed();
    if (failed.leaves.empty() && certifies()) failed = take_unproved_boxes();
    if (failed.leaves.empty() && is_unrefined()) failed = take_points_without_limit();
    if (failed.leaves.empty()) break;
    add(failed, {until, limits_.max_triangles});
  }
  if (stops_early()) return;
  const bool is_finished = !reached_limit_ || is_unrefined();
  if (is_finished) singularities_ = leave_out_singularities(surface_, limits_, tree_, mesh_);
  cut_walls(limits_, is_finished, tree_, mesh_);
}

LeafTriangles AdaptiveMesher::triangulate(MeshReport& report) {
  const auto& leaves = mesh_.leaves;
  const SingularCorners singular(leaves, tree_, request_.threads, normal_limits_, grid_, report);
  measure(singular.leaves(), singular);
  std::vector<std::size_t> stale;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    if (!has_lasting_triangles(k)) stale.push_back(k);
  }
  mesh_.put(stale, triangulate_leaves(leaves, stale, singular, grid_, tree_),
            tree_.revisions().next());
  LeafTriangles triangles = mesh_.all_triangles();
  if (meets_itself_ || seams_.has_folds()) flip_shared_chords(grid_, triangles);
  return triangles;
}

void AdaptiveMesher::reach_extremes() {
  if (!oscillates_) return;
  const Oscillation unresolvable = oscillation();
  const auto oscillates = [&](const Leaf& leaf) { return unresolvable.contains(leaf, tree_); };
  saddle::reach_extremes(surface_, mesh_.leaves, oscillates, request_.threads, tree_, grid_);
}

/// Whether a leaf would be cut into the same triangles as when it was measured.
bool AdaptiveMesher::has_lasting_triangles(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  if (leaf.state.is_left_out()) return false;
  if (!tree_.revisions().has_changed(leaf, mesh_.made[number])) return true;
  if (!leaf.state.is_whole() || tree_.edges().may_be_crossed(leaf)) return false;
  // Something has changed nearby: not this leaf, if what was around it still is, and all of that
  // are vertices and points of their own.
  std::uint32_t count = 0;
  bool is_regular = true;
  for_sides(leaf, tree_, [&](std::uint32_t vertex, std::uint32_t) {
    ++count;
    is_regular =
        is_regular && tree_.geometry().is_regular(vertex) && grid_.mesh.point[vertex] == vertex;
  });
  return is_regular && count == leaf.polygon_size;
}

void AdaptiveMesher::complete(MeshReport& report) {
  report.cells = mesh_.leaves.size();
  const bool stopped = reached_limit_ && !is_unrefined();
  report.reached_limit = report.reached_limit || stopped;
  report.budget_spent = stopped && tree_.budget().is_spent(limits_.max_triangles);
  report.coarse_normals = coarse_normals_;
  report.oscillates = oscillates_;
  if (stopped) leave_all_unproved(GapReason::Triangles);
  if (!proof_gaps_) leave_all_unproved(GapReason::NotTried);
  report.certified = proof_gaps_->empty();
  name_proof_gaps(report);
  report_seams(seams_, report);
  report.work.leaf_samples +=
      grid_.vertex_count() + tree_.geometry().evaluations() + validator_.evaluations();
  report.work.boxes += ProofBudget(surface_.bounds).boxes - budget_.boxes;
  report.work.searches += tree_.effort().looks();
}

/// Has no proof hold anywhere.
void AdaptiveMesher::leave_all_unproved(GapReason why) {
  const Domain& d = surface_.domain;
  proof_gaps_ = {{why, {d.u0, d.v0}, {d.u1, d.v1}}};
}

/// Where bounds say no more than that there is no proof, what was found in the meantime tells why.
void AdaptiveMesher::name_proof_gaps(MeshReport& report) {
  GapReasons names;
  for (const dvec2& uv : report.without_limit) names.add(GapReason::NoLimit, uv);
  for (const dvec2& uv : report.poles) names.add(GapReason::Pole, uv);
  for (const dvec2& uv : report.jumps) names.add(GapReason::Jump, uv);
  for (const SingularPoint& point : report.singular_points)
    names.add(GapReason::Singular, point.uv);
  names.give_to(*proof_gaps_);
  report.proof_gaps = merged(*proof_gaps_, surface_.domain);
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

TraceOptions AdaptiveMesher::trace_options(bool poles) const {
  return {limits_.tolerance, poles, request_.threads, request_.clip, limits_.max_triangles};
}

/// Stops, and remembers it, if one more halving could exceed the limit of triangles.
bool AdaptiveMesher::stop_if_full() {
  const bool full = tree_.budget().is_full(limits_.max_triangles);
  reached_limit_ = reached_limit_ || full;
  return full;
}

bool AdaptiveMesher::is_clipped(const Leaf& leaf) const {
  return saddle::is_clipped(leaf, request_.clip, tree_);
}

bool AdaptiveMesher::crosses_box(const Leaf& leaf) const {
  return request_.clip && std::ranges::any_of(corner_positions(leaf, tree_), [&](const dvec3& p) {
           return !request_.clip->contains(p);
         });
}

double AdaptiveMesher::width(const Leaf& leaf) const {
  if (leaf.state.is_on_boundary()) {
    Bounds bounds;
    double area = 0;
    for (const Polygon& sub_polygon : sub_polygons(leaf, tree_)) {
      const dvec3& first = grid_.mesh.position[sub_polygon[0].corner];
      for (std::size_t k = 1; k + 1 < sub_polygon.size(); ++k) {
        const dvec3 a = grid_.mesh.position[sub_polygon[k].corner] - first;
        const dvec3 b = grid_.mesh.position[sub_polygon[k + 1].corner] - first;
        area += glm::length(glm::cross(a, b)) / 2;
      }
      for (const PolygonCorner& corner : sub_polygon)
        bounds.add(grid_.mesh.position[corner.corner]);
    }
    return area > 0 ? area / bounds.diagonal() : 0;
  }
  return thickness(grid_.mesh, leaf.samples.corner);
}

void AdaptiveMesher::take(const Subdivision& subdivision) {
  reached_limit_ = reached_limit_ || subdivision.reached_limit;
  if (!oscillates_) oscillates_ = subdivision.oscillates;
  mesh_.leaves.insert(mesh_.leaves.end(), subdivision.leaves.begin(), subdivision.leaves.end());
  empty_.insert(empty_.end(), subdivision.empty.begin(), subdivision.empty.end());
}

/// Looks for new vertices that are too far away.
void AdaptiveMesher::look_far() {
  if (!may_stop()) return;
  const auto& position = grid_.mesh.position;
  for (; seen_ < position.size(); ++seen_) {
    const dvec3& p = position[seen_];
    if (!proportionate_.contains(p) && is_finite(p)) far_.add(p);
  }
}

/// Refines leaves, adds what comes out and measures it.
void AdaptiveMesher::add(const Failed& failed, const SubdivisionGoal& goal) {
  take(
      subdivide(failed.leaves, failed.counterexamples, oscillation(), limits_, goal, grid_, tree_));
  look_far();
  if (stops_early()) return;
  auto& leaves = mesh_.leaves;
  mirror_seams(seams_, request_.threads, grid_, tree_, points_);
  points_.settle();
  std::vector<std::size_t> changed = follow_features(trace_options(false), leaves, tree_);
  if (tree_.edges().has_features() && seams_.any()) {
    trace_features_across_seams(seams_, trace_options(false), grid_, tree_);
    const auto more = follow_features(trace_options(false), leaves, tree_);
    changed.insert(changed.end(), more.begin(), more.end());
    join_features(seams_, grid_, tree_, points_);
  }
  meets_itself_ |= join_poles(std::span(leaves).subspan(mesh_.sampled_errors.size()),
                              request_.threads, grid_, tree_, points_);
  points_.settle();
  for (const std::uint32_t vertex : points_.take_changed())
    tree_.revisions().mark(tree_.vertices().place_between(vertex));
  std::erase_if(changed, [&](std::size_t k) { return k >= mesh_.sampled_errors.size(); });
  for (std::size_t k = mesh_.allowed.size(); k < leaves.size(); ++k) {
    mesh_.allowed.push_back(tolerance_of(leaves[k], limits_.tolerance, tree_));
  }
  const std::vector<std::size_t> fresh = numbers(mesh_.sampled_errors.size(), leaves.size());
  changed.insert(changed.end(), fresh.begin(), fresh.end());
  measure(changed, SingularCorners());
}

/// Measures the distances of leaves anew that have other triangles than when they were measured,
/// with vertices of neighbours on their sides. Their normals are known: those do not turn. False if
/// there are none.
bool AdaptiveMesher::revalidate() {
  std::vector<std::size_t> changed;
  std::vector<double> degrees;
  const std::uint32_t now = tree_.revisions().next();
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    Leaf& leaf = mesh_.leaves[k];
    if (!tree_.revisions().has_changed(leaf, leaf.measured)) continue;
    leaf.measured = now;
    if (count_polygon_vertices(leaf, tree_) == leaf.polygon_size) continue;
    changed.push_back(k);
    degrees.push_back(mesh_.sampled_errors[k].degrees);
  }
  if (changed.empty()) return false;
  measure(changed, SingularCorners());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    mesh_.sampled_errors[changed[i]].degrees = degrees[i];
  }
  return true;
}

/// Normals of what is so thin that it is not seen how they turn do not count.
void AdaptiveMesher::measure(std::span<const std::size_t> which, const SingularCorners& singular) {
  const std::uint32_t now = tree_.revisions().next();
  for (const std::size_t k : which) mesh_.leaves[k].measured = now;
  const LeafTriangles triangles = triangulate_leaves(mesh_.leaves, which, singular, grid_, tree_);
  const std::size_t before = validator_.evaluations();
  validator_.measure(mesh_, which, triangles);
  tree_.effort().add_places(validator_.evaluations() - before);
  mesh_.put(which, triangles, now);
  for (const std::size_t k : which) {
    if (is_turned(k) && width(mesh_.leaves[k]) <= kSeenTurn * mesh_.allowed[k]) {
      mesh_.sampled_errors[k].degrees = 0;
    }
  }
}

/// Measures the leaves with singular corners with the limits of their normals, which are not kept
/// until no leaf changes any more. False if there are none.
bool AdaptiveMesher::validate_singular() {
  if (!tree_.geometry().has_singular()) return false;
  Mesh& mesh = grid_.mesh;
  const std::size_t count = mesh.position.size();
  MeshReport unused;
  const SingularCorners singular(mesh_.leaves, tree_, request_.threads, normal_limits_, grid_,
                                 unused);
  measure(singular.leaves(), singular);
  for (const std::size_t k : singular.leaves()) mesh_.made[k] = 0;  // their corners go away
  mesh.position.resize(count);
  mesh.normal.resize(count);
  mesh.uv.resize(count);
  mesh.point.resize(count);
  return true;
}

/// Which way to halve a leaf that deviates: the one that its tests find worse, or the longer one:
/// what the tests along its sides did not see, they see at half.
bool AdaptiveMesher::splits_u(std::size_t number) {
  const Leaf& leaf = mesh_.leaves[number];
  const bool is_far = mesh_.off(number) > 1;
  if (const auto predicted = predicted_.splits_predicted_u(leaf, tree_)) return *predicted;
  if (mesh_.triangles.ranges[number].has_flat_sub_polygon && leaf.state.is_cut_by_feature()) {
    if (const auto along_u = flat_sub_polygon_along_u(leaf, tree_)) return *along_u;
  }
  if (is_far && mesh_.sampled_errors[number].on_crease) return is_cut_along_u(leaf, tree_);
  if (leaf.state.is_on_boundary()) return indicator_.splits_boundary_u(leaf);
  if (is_cut_unclearly(number)) return count_features(leaf, tree_).is_parted_across_u(leaf);
  const CellError error = indicator_.estimate(leaf);
  const ErrorRatios ratios = is_far ? error.distance : error.turn;
  constexpr double kTells = 0.5;  // of the tolerance
  const bool tells = std::max(ratios.along_u, ratios.along_v) > kTells;
  const bool is_narrow = Oscillation(grid_, limits_.share).is_sliver(leaf, tree_);
  if (tells && !is_narrow) return ratios.along_u >= ratios.along_v;
  // Normals at a singular side are not known yet, but it is there that they turn most.
  if (!is_far && has_singular_side(leaf.samples, 0) != has_singular_side(leaf.samples, 1)) {
    return has_singular_side(leaf.samples, 1);
  }
  return leaf.size_u() >= leaf.size_v();
}

/// Whether one of a leaf's two sides along u (0) or along v (1) is singular at both ends.
bool AdaptiveMesher::has_singular_side(const SampleVertices& samples, std::size_t along) const {
  const auto& corner = samples.corner;
  return is_cusp(corner[along], corner[along + 1], tree_) ||
         is_cusp(corner[along + 2], corner[(along + 3) % 4], tree_);
}

/// Whether a leaf is cut by more than one jump, or by one that ends in it: its pieces do not tell.
/// Or a side of it is a piece of its own, with vertices that the others do not have.
bool AdaptiveMesher::is_cut_unclearly(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  if (!leaf.state.is_cut_by_feature() || !leaf.state.may_be_halved()) return false;
  const FeatureCount cuts = count_features(leaf, tree_);
  if (cuts.only_creases) return mesh_.triangles.ranges[number].has_flat_sub_polygon;
  return !cuts.is_through();
}

/// Whether the normals of a leaf turn by more than is allowed.
bool AdaptiveMesher::is_turned(std::size_t number) const {
  return turn_of_line(mesh_.sampled_errors[number].degrees) > request_.normal_tolerance;
}

/// How many times worse than allowed the normals of a leaf are, as a score; 0 where no more
/// triangles are worth it.
double AdaptiveMesher::turn(std::size_t number) {
  if (!is_turned(number)) return 0;
  const Leaf& leaf = mesh_.leaves[number];
  const double share =
      turn_of_line(mesh_.sampled_errors[number].degrees) / request_.normal_tolerance;
  if (!tree_.budget().has_many(allowed_for_normals(limits_.max_triangles))) return share * share;
  if (!coarse_normals_) coarse_normals_ = tree_.vertices().parameters(leaf.middle());
  return 0;
}

/// Where leaves will be hopeless.
Oscillation AdaptiveMesher::predict(const MeshPlan& plan) const {
  Oscillation oscillation(grid_, limits_.share);
  oscillation.predict(plan.probe.linearization_errors(oscillation.narrow_size(), plan.tolerance));
  return oscillation;
}

/// Where leaves are hopeless.
Oscillation AdaptiveMesher::oscillation() const {
  Oscillation oscillation = predicted_;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    if (!oscillates_ && mesh_.is_near(k)) continue;
    const Leaf& leaf = mesh_.leaves[k];
    if (leaf.state.oscillates()) {
      oscillation.add(leaf, tree_);
    } else if (!leaf.state.leads_to_pole() && !mesh_.is_near(k)) {
      oscillation.add(leaf, {.centre = mesh_.off(k)}, tree_);
    }
  }
  return oscillation;
}

/// Stops at a leaf that deviates too much but is not to be halved any more, and tells it why.
bool AdaptiveMesher::stop_if_done(Leaf& leaf, const Oscillation& oscillation) {
  if (!leaf.state.may_be_halved() || is_clipped(leaf) || stop_if_full()) return true;
  if (!oscillation.contains(leaf, tree_)) return false;
  leaf.state.stop_at_oscillation();
  if (!oscillates_) oscillates_ = tree_.vertices().parameters(leaf.middle());
  return true;
}

/// Halves of the leaves that deviate too much, among those that were measured since the last time,
/// since what stayed then stays; and of those that new crossings on their sides cut unclearly.
std::vector<Leaf> AdaptiveMesher::take_failed() {
  const std::uint32_t now = tree_.revisions().next();
  std::optional<Oscillation> unresolvable;  // known once it is asked for
  std::vector<std::size_t> failed;
  std::vector<Leaf> halves;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    Leaf& leaf = mesh_.leaves[k];
    const bool is_cut = leaf.state.is_cut_by_feature();
    const bool is_cut_anew = is_cut && tree_.revisions().has_changed(leaf, taken_);
    if (leaf.measured <= taken_ && !is_cut_anew) continue;
    if (mesh_.is_near(k) && !is_cut && !is_turned(k)) continue;
    const double off = mesh_.off(k);
    const double turned = turn(k);
    if (!(off > 1) && !(turned > 1) && !is_cut_unclearly(k)) continue;
    if (!unresolvable) unresolvable.emplace(oscillation());
    if (stop_if_done(leaf, *unresolvable)) continue;
    const auto both = halve(leaf, splits_u(k), tree_);
    if (!both) continue;
    failed.push_back(k);
    const double safer = is_cut ? 1 : std::clamp(off, 1.0, kMostSafety);
    for (Leaf half : *both) {
      half.safety *= static_cast<float>(safer);
      half.normal_safety *= static_cast<float>(std::clamp(turned, 1.0, kMostSafety));
      halves.push_back(half);
    }
  }
  taken_ = now;
  mesh_.remove(failed);
  // A neighbour was halved, and the side that both share turns out to be defined.
  const auto is_no_more = [this](const Leaf& leaf) {
    return has_defined_corner(leaf, tree_) && !stop_if_full();
  };
  std::ranges::copy_if(empty_, std::back_inserter(halves), is_no_more);
  std::erase_if(empty_, is_no_more);
  return halves;
}

/// The leaves that are defined at none of their samples, but elsewhere.
AdaptiveMesher::Failed AdaptiveMesher::take_small_components(std::size_t& boxes) {
  std::vector<ParameterBox> where;
  for (const Leaf& leaf : empty_) {
    where.push_back(
        {tree_.vertices().parameters(leaf.low), tree_.vertices().parameters(leaf.high)});
  }
  const auto found = find_defined(surface_, where, boxes, request_.threads);
  Failed failed;
  std::vector<Leaf> kept;
  for (std::size_t k = 0; k < where.size(); ++k) {
    if (!found[k] || stop_if_full()) {
      kept.push_back(empty_[k]);
      continue;
    }
    failed.counterexamples.push_back({*found[k], {}, {}, {}, failed.leaves.size()});
    failed.leaves.push_back(empty_[k]);
  }
  empty_ = std::move(kept);
  return failed;
}

/// Whether a box in a leaf in which the surface is not defined would be seen if it was.
bool AdaptiveMesher::is_visible_hole(const UnprovedBox& box) const {
  // A hole holds boxes half as wide as it is, or a little wider.
  constexpr double kOfTolerance = 0.5;
  const Leaf& leaf = mesh_.leaves[box.patch];
  const dvec2 size =
      glm::abs(tree_.vertices().parameters(leaf.high) - tree_.vertices().parameters(leaf.low));
  const dvec2 part = box.size / size;
  const auto p = corner_positions(leaf, tree_);
  const double along_u = std::max(glm::distance(p[0], p[1]), glm::distance(p[3], p[2]));
  const double along_v = std::max(glm::distance(p[0], p[3]), glm::distance(p[1], p[2]));
  return std::max(part.x * along_u, part.y * along_v) > kOfTolerance * mesh_.allowed[box.patch];
}

/// The leaves in which bounds found places that deviate too much, holes that are seen, or tears.
AdaptiveMesher::Failed AdaptiveMesher::take_unproved_boxes() {
  const Certification proof = certify(
      surface_, root_lines(grid_), patches_of(mesh_.leaves, mesh_.allowed, grid_, tree_), budget_);
  proof_gaps_ = proof.proof_gaps;
  std::vector<dvec2> middles;
  std::vector<std::size_t> unproved;
  for (const UnprovedBox& unproved_box : proof.unproved_boxes) {
    middles.push_back(unproved_box.middle);
    unproved.push_back(unproved_box.patch);
  }
  std::ranges::sort(unproved);
  unproved.erase(std::unique(unproved.begin(), unproved.end()), unproved.end());
  const LeafTriangles triangles =
      triangulate_leaves(mesh_.leaves, unproved, SingularCorners(), grid_, tree_);
  const std::vector<SurfacePoint> points = evaluate(surface_, middles, request_.threads);
  std::vector<double> distances;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const UnprovedBox& unproved_box = proof.unproved_boxes[k];
    const auto number = std::ranges::lower_bound(unproved, unproved_box.patch) - unproved.begin();
    distances.push_back(distance_from(grid_, triangles.of(static_cast<std::size_t>(number)),
                                      unproved_box.middle, points[k].position));
    SampledError& worst = mesh_.sampled_errors[unproved_box.patch];
    worst.distance = std::max(worst.distance, distances.back());
  }
  const Oscillation unresolvable = oscillation();
  std::set<std::size_t> guilty;
  std::vector<Counterexample> counterexamples;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const UnprovedBox& unproved_box = proof.unproved_boxes[k];
    const bool exceeds_tolerance = unproved_box.is_undefined
                                       ? is_visible_hole(unproved_box)
                                       : distances[k] > mesh_.allowed[unproved_box.patch];
    if (!exceeds_tolerance || stop_if_done(mesh_.leaves[unproved_box.patch], unresolvable)) {
      continue;
    }
    guilty.insert(unproved_box.patch);
    counterexamples.push_back({unproved_box.middle, points[k].position, unproved_box.size,
                               unproved_box.bend, unproved_box.patch});
  }
  const std::vector<std::size_t> without_limit = find_points_without_limit(proof.unproved_boxes);
  guilty.insert(without_limit.begin(), without_limit.end());
  return take(guilty, std::move(counterexamples));
}

/// The leaves with a tear alone.
AdaptiveMesher::Failed AdaptiveMesher::take_points_without_limit() {
  const Certification proof = certify(
      surface_, root_lines(grid_), patches_of(mesh_.leaves, mesh_.allowed, grid_, tree_), budget_);
  const std::vector<std::size_t> without_limit = find_points_without_limit(proof.unproved_boxes);
  return take({without_limit.begin(), without_limit.end()}, {});
}

/// Where bounds do not exclude a jump, looks for one along the sides of leaves: along the surface,
/// as within a plane, none takes any sample far from its triangles. The leaves that are cut so.
std::vector<std::size_t> AdaptiveMesher::find_points_without_limit(
    std::span<const UnprovedBox> unproved_boxes) {
  std::set<std::size_t> leaves;
  for (const UnprovedBox& unproved_box : unproved_boxes) {
    const Leaf& leaf = mesh_.leaves[unproved_box.patch];
    const bool is_done =
        !leaf.state.may_be_halved() || leaf.state.leads_to_pole() || is_clipped(leaf);
    if (unproved_box.may_jump && !is_done) leaves.insert(unproved_box.patch);
  }
  std::vector<Side> sides;
  for (const std::size_t k : leaves) append_unsearched(mesh_.leaves[k], tree_, sides);
  sort_sides(sides);
  find_jumps(sides, trace_options(false), tree_);
  std::vector<std::size_t> without_limit;
  for (const std::size_t k : leaves) {
    Leaf& leaf = mesh_.leaves[k];
    const bool is_cut = count_features(leaf, tree_).features > 0;
    leaf.state.set_features(is_cut, false);
    if (is_cut) without_limit.push_back(k);
  }
  return without_limit;
}

/// Takes leaves out, by their numbers, which counterexamples tell them by.
AdaptiveMesher::Failed AdaptiveMesher::take(const std::set<std::size_t>& guilty,
                                            std::vector<Counterexample> counterexamples) {
  for (Counterexample& counterexample : counterexamples) {
    counterexample.cell =
        static_cast<std::size_t>(std::distance(guilty.begin(), guilty.find(counterexample.cell)));
  }
  Failed failed{{}, std::move(counterexamples)};
  const std::vector<std::size_t> taken(guilty.begin(), guilty.end());
  for (const std::size_t k : taken) failed.leaves.push_back(mesh_.leaves[k]);
  mesh_.remove(taken);
  return failed;
}

}  // namespace saddle
