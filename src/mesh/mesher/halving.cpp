#include "mesh/mesher/halving.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

#include "mesh/features/robust_box.h"
#include "mesh/grid/degenerate.h"
#include "mesh/grid/weld.h"
#include "mesh/mesher/envelope.h"
#include "mesh/mesher/refine.h"
#include "mesh/proof/islands.h"
#include "mesh/tree/flip.h"

namespace saddle {

namespace {

/// Times that leaves which fail on fresh samples are halved again.
constexpr int kRounds = 12;
/// The part of the triangles that are allowed that tests may take at first. The rest is for waves
/// that fit into a cell so well that only fresh samples see them.
constexpr double kFirst = 0.875;
/// What a sample finds at a kink says nothing about how fine the mesh must be, and what one finds
/// where a leaf is cut tells of the cut only.
constexpr double kMostStrict = 4;
/// The search for islands may try one box for so many of proofs.
constexpr std::size_t kProofsPerIsland = 12;

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

Halving::Halving(const Surface& surface, const AdaptiveOptions& options, MeshPlan& plan)
    : surface_(surface),
      options_(options),
      refining_{plan.aim,
                options.normal_tolerance,
                options.max_triangles,
                options.clip,
                seen_lines(plan.lines.u, plan.drawn.u),
                seen_lines(plan.lines.v, plan.drawn.v),
                options.until_far ? Until::Poles : Until::Done,
                options.threads,
                share_of_diagonal(plan)},
      grid_(sample_grid(surface, std::move(plan.lines.u), std::move(plan.lines.v), options.threads,
                        options.clip)),
      seams_(weld_if_two_dimensional(plan.probe)),
      points_(grid_.mesh),
      lattice_(surface, grid_, options.threads),
      judge_(refining_, grid_, lattice_),
      verifier_(surface, grid_, lattice_, refining_),
      foreseen_(foresee(plan)),
      budget_(surface.bounds) {
  if (!options.until_far || std::isinf(*options.until_far)) return;
  const Bounds most = rough_box(plan.probe.positions());
  const dvec3 far(*options.until_far * most.diagonal());
  proportionate_ = {most.low - far, most.high + far};
}

void Halving::run(std::vector<Witness> witnesses) {
  look_far();
  if (stops_early()) refining_.until = Until::OneGeneration;
  lattice_.add_middles(options_.threads);
  refining_.max_triangles =
      static_cast<std::size_t>(kFirst * static_cast<double>(options_.max_triangles));
  add({root_leaves(grid_), std::move(witnesses)});
  refining_.max_triangles = options_.max_triangles;
  std::size_t island_boxes = budget_.boxes / kProofsPerIsland;
  for (int round = 0; round < kRounds && !stops_early(); ++round) {
    Failed failed{take_failed(), {}};
    if (failed.leaves.empty() && remeasure()) failed.leaves = take_failed();
    if (failed.leaves.empty() && options_.certify) failed = take_islands(island_boxes);
    if (failed.leaves.empty() && measure_singular()) failed.leaves = take_failed();
    if (failed.leaves.empty() && options_.certify) failed = take_suspects();
    if (failed.leaves.empty() && is_unrefined()) failed = take_torn();
    if (failed.leaves.empty()) break;
    add(failed);
  }
  if (stops_early()) return;
  const bool is_finished = !reached_limit_ || is_unrefined();
  if (is_finished) holes_ = leave_out_holes(surface_, refining_, lattice_, mesh_);
  cut_walls(refining_, is_finished, lattice_, mesh_);
}

LeafTriangles Halving::triangulate(MeshReport& report) {
  const auto& leaves = mesh_.leaves;
  const SingularCorners singular(leaves, lattice_, options_.threads, limits_, grid_, report);
  measure(singular.leaves(), singular);
  std::vector<std::size_t> stale;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    if (!has_lasting_triangles(k)) stale.push_back(k);
  }
  mesh_.put(stale, triangulate_leaves(leaves, stale, singular, grid_, lattice_),
            lattice_.next_moment());
  LeafTriangles triangles = mesh_.all_triangles();
  if (meets_itself_ || seams_.has_folds()) flip_shared_chords(grid_, triangles);
  return triangles;
}

std::size_t Halving::reach_extremes() {
  if (!oscillates_) return 0;
  const Oscillation hopeless = oscillation();
  const auto oscillates = [&](const Leaf& leaf) { return hopeless.contains(leaf, lattice_); };
  return saddle::reach_extremes(surface_, mesh_.leaves, oscillates, options_.threads, lattice_,
                                grid_);
}

/// Whether a leaf would be cut into the same triangles as when it was measured.
bool Halving::has_lasting_triangles(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  if (leaf.is_left_out) return false;
  if (!lattice_.has_changed(leaf, mesh_.made[number])) return true;
  if (leaf.is_split || leaf.on_rim || lattice_.may_be_crossed(leaf)) return false;
  // Something has changed nearby: not this leaf, if what was around it still is, and all of that
  // are vertices and points of their own.
  std::uint32_t count = 0;
  bool is_regular = true;
  for_sides(leaf, lattice_, [&](std::uint32_t vertex, std::uint32_t) {
    ++count;
    is_regular = is_regular && lattice_.is_regular(vertex) && grid_.mesh.point[vertex] == vertex;
  });
  return is_regular && count == leaf.outline;
}

void Halving::complete(MeshReport& report) {
  report.cells = mesh_.leaves.size();
  const bool stopped = reached_limit_ && !is_unrefined();
  report.reached_limit = report.reached_limit || stopped;
  report.is_tired = stopped && lattice_.is_tired(options_.max_triangles);
  report.coarse_normals = coarse_normals_;
  report.oscillates = oscillates_;
  if (stopped) doubt_all(Doubt::Triangles);
  if (!doubts_) doubt_all(Doubt::NotTried);
  report.certified = doubts_->empty();
  name_doubts(report);
  report_seams(seams_, report);
  report.work.leaf_samples +=
      grid_.vertex_count() + lattice_.evaluations() + verifier_.evaluations();
  report.work.boxes += ProofBudget(surface_.bounds).boxes - budget_.boxes;
  report.evaluations += report.work.leaf_samples;
  report.work.searches += lattice_.effort().looks();
}

/// Has no proof hold anywhere.
void Halving::doubt_all(Doubt why) {
  const Domain& d = surface_.domain;
  doubts_ = {{why, {d.u0, d.v0}, {d.u1, d.v1}}};
}

/// Where bounds say no more than that there is no proof, what was found in the meantime tells why.
void Halving::name_doubts(MeshReport& report) {
  DoubtNames names;
  for (const dvec2& uv : report.torn) names.add(Doubt::NoLimit, uv);
  for (const dvec2& uv : report.poles) names.add(Doubt::Pole, uv);
  for (const dvec2& uv : report.jumps) names.add(Doubt::Jump, uv);
  for (const SingularPoint& point : report.singular_points) names.add(Doubt::Singular, point.uv);
  names.give_to(*doubts_);
  report.doubts = merged(*doubts_, surface_.domain);
}

Seams Halving::weld_if_two_dimensional(const Probe& probe) {
  if (probe.island()) grid_.range = probe.island()->where.high - probe.island()->where.low;
  if (grid_.left_out_count == grid_.cell_count()) {
    set_extent(grid_, probe.bounds());
    return {};
  }
  require_two_dimensional(surface_, grid_, options_.threads);
  return weld(surface_, options_.threads, grid_);
}

CrossingOptions Halving::crossing_options(bool poles) const {
  return {refining_.tolerance, poles, options_.threads, options_.clip, options_.max_triangles};
}

/// Stops, and remembers it, if one more halving could exceed the limit of triangles.
bool Halving::stop_if_full() {
  const bool full = lattice_.is_full(options_.max_triangles);
  reached_limit_ = reached_limit_ || full;
  return full;
}

bool Halving::is_clipped(const Leaf& leaf) const {
  return saddle::is_clipped(leaf, options_.clip, lattice_);
}

bool Halving::crosses_box(const Leaf& leaf) const {
  return options_.clip &&
         std::ranges::any_of(corner_positions(leaf, lattice_),
                             [&](const dvec3& p) { return !options_.clip->contains(p); });
}

double Halving::width(const Leaf& leaf) const {
  if (leaf.on_rim) {
    Bounds bounds;
    double area = 0;
    for (const Polygon& piece : pieces(leaf, lattice_)) {
      const dvec3& first = grid_.mesh.position[piece[0].corner];
      for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
        const dvec3 a = grid_.mesh.position[piece[k].corner] - first;
        const dvec3 b = grid_.mesh.position[piece[k + 1].corner] - first;
        area += glm::length(glm::cross(a, b)) / 2;
      }
      for (const PolygonCorner& corner : piece) bounds.add(grid_.mesh.position[corner.corner]);
    }
    return area > 0 ? area / bounds.diagonal() : 0;
  }
  return thickness(grid_.mesh, leaf.samples.corner);
}

void Halving::take(const Refinement& refinement) {
  reached_limit_ = reached_limit_ || refinement.reached_limit;
  if (!oscillates_) oscillates_ = refinement.oscillates;
  mesh_.leaves.insert(mesh_.leaves.end(), refinement.leaves.begin(), refinement.leaves.end());
  empty_.insert(empty_.end(), refinement.empty.begin(), refinement.empty.end());
}

/// Looks for new vertices that are too far away.
void Halving::look_far() {
  if (!options_.until_far) return;
  const auto& position = grid_.mesh.position;
  for (; seen_ < position.size(); ++seen_) {
    const dvec3& p = position[seen_];
    if (!proportionate_.contains(p) && is_finite(p)) far_.add(p);
  }
}

/// Refines leaves, adds what comes out and measures it.
void Halving::add(const Failed& failed) {
  take(refine(failed.leaves, failed.witnesses, oscillation(), refining_, grid_, lattice_));
  look_far();
  if (stops_early()) return;
  auto& leaves = mesh_.leaves;
  mirror_seams(seams_, options_.threads, grid_, lattice_, points_);
  points_.settle();
  std::vector<std::size_t> changed = follow_crossings(crossing_options(false), leaves, lattice_);
  if (lattice_.has_crossings() && seams_.any()) {
    mirror_crossings(seams_, crossing_options(false), grid_, lattice_);
    const auto more = follow_crossings(crossing_options(false), leaves, lattice_);
    changed.insert(changed.end(), more.begin(), more.end());
    join_crossings(seams_, grid_, lattice_, points_);
  }
  meets_itself_ |= join_poles(std::span(leaves).subspan(mesh_.deviations.size()), options_.threads,
                              grid_, lattice_, points_);
  points_.settle();
  for (const std::uint32_t vertex : points_.take_changed()) lattice_.mark_changed(vertex);
  std::erase_if(changed, [&](std::size_t k) { return k >= mesh_.deviations.size(); });
  for (std::size_t k = mesh_.allowed.size(); k < leaves.size(); ++k) {
    mesh_.allowed.push_back(tolerance_of(leaves[k], refining_.tolerance, lattice_));
  }
  const std::vector<std::size_t> fresh = numbers(mesh_.deviations.size(), leaves.size());
  changed.insert(changed.end(), fresh.begin(), fresh.end());
  measure(changed, SingularCorners());
}

/// Measures the distances of leaves anew that have other triangles than when they were measured,
/// with vertices of neighbours on their sides. Their normals are known: those do not turn. False if
/// there are none.
bool Halving::remeasure() {
  std::vector<std::size_t> changed;
  std::vector<double> degrees;
  const std::uint32_t now = lattice_.next_moment();
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    Leaf& leaf = mesh_.leaves[k];
    if (!lattice_.has_changed(leaf, leaf.measured)) continue;
    leaf.measured = now;
    if (count_outline(leaf, lattice_) == leaf.outline) continue;
    changed.push_back(k);
    degrees.push_back(mesh_.deviations[k].degrees);
  }
  if (changed.empty()) return false;
  measure(changed, SingularCorners());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    mesh_.deviations[changed[i]].degrees = degrees[i];
  }
  return true;
}

/// Normals of what is so thin that it is not seen how they turn do not count.
void Halving::measure(std::span<const std::size_t> which, const SingularCorners& singular) {
  const std::uint32_t now = lattice_.next_moment();
  for (const std::size_t k : which) mesh_.leaves[k].measured = now;
  const LeafTriangles triangles =
      triangulate_leaves(mesh_.leaves, which, singular, grid_, lattice_);
  const std::size_t before = verifier_.evaluations();
  verifier_.measure(mesh_, which, triangles);
  lattice_.effort().add_places(verifier_.evaluations() - before);
  mesh_.put(which, triangles, now);
  for (const std::size_t k : which) {
    if (is_turned(k) && width(mesh_.leaves[k]) <= kSeenTurn * mesh_.allowed[k]) {
      mesh_.deviations[k].degrees = 0;
    }
  }
}

/// Measures the leaves with singular corners with the limits of their normals, which are not kept
/// until no leaf changes any more. False if there are none.
bool Halving::measure_singular() {
  if (!lattice_.has_singular()) return false;
  Mesh& mesh = grid_.mesh;
  const std::size_t count = mesh.position.size();
  MeshReport unused;
  const SingularCorners singular(mesh_.leaves, lattice_, options_.threads, limits_, grid_, unused);
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
bool Halving::splits_u(std::size_t number) {
  const Leaf& leaf = mesh_.leaves[number];
  const bool is_far = mesh_.off(number) > 1;
  if (const auto foreseen = foreseen_.splits_foreseen_u(leaf, lattice_)) return *foreseen;
  if (mesh_.triangles.ranges[number].has_flat_piece && leaf.is_split) {
    if (const auto along_u = flat_piece_along_u(leaf, lattice_)) return *along_u;
  }
  if (is_far && mesh_.deviations[number].on_crease) return is_cut_along_u(leaf, lattice_);
  if (leaf.on_rim) return judge_.splits_rim_u(leaf);
  if (is_cut_unclearly(number)) return count_cuts(leaf, lattice_).is_parted_across_u(leaf);
  const Verdict verdict = judge_.score(leaf);
  const Scores scores = is_far ? verdict.distance : verdict.turn;
  constexpr double kTells = 0.5;  // of the tolerance
  const bool tells = std::max(scores.along_u, scores.along_v) > kTells;
  const bool is_narrow = Oscillation(grid_, refining_.share).is_sliver(leaf, lattice_);
  if (tells && !is_narrow) return scores.along_u >= scores.along_v;
  // Normals at a singular side are not known yet, but it is there that they turn most.
  if (!is_far && has_singular_side(leaf.samples, 0) != has_singular_side(leaf.samples, 1)) {
    return has_singular_side(leaf.samples, 1);
  }
  return leaf.size_u() >= leaf.size_v();
}

/// Whether one of a leaf's two sides along u (0) or along v (1) is singular at both ends.
bool Halving::has_singular_side(const SampleVertices& samples, std::size_t along) const {
  const auto& corner = samples.corner;
  return is_cusp(corner[along], corner[along + 1], lattice_) ||
         is_cusp(corner[along + 2], corner[(along + 3) % 4], lattice_);
}

/// Whether a leaf is cut by more than one jump, or by one that ends in it: its pieces do not tell.
/// Or a side of it is a piece of its own, with vertices that the others do not have.
bool Halving::is_cut_unclearly(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  if (!leaf.is_split || leaf.given_up) return false;
  const CutCount cuts = count_cuts(leaf, lattice_);
  if (cuts.only_creases) return mesh_.triangles.ranges[number].has_flat_piece;
  return !cuts.is_through();
}

/// Whether the normals of a leaf turn by more than is allowed.
bool Halving::is_turned(std::size_t number) const {
  return turn_of_line(mesh_.deviations[number].degrees) > options_.normal_tolerance;
}

/// How many times worse than allowed the normals of a leaf are, as a score; 0 where no more
/// triangles are worth it.
double Halving::turn(std::size_t number) {
  if (!is_turned(number)) return 0;
  const Leaf& leaf = mesh_.leaves[number];
  const double share = turn_of_line(mesh_.deviations[number].degrees) / options_.normal_tolerance;
  if (!lattice_.has_many(allowed_for_normals(options_.max_triangles))) return share * share;
  if (!coarse_normals_) coarse_normals_ = lattice_.parameters(leaf.middle());
  return 0;
}

/// Where leaves will be hopeless.
Oscillation Halving::foresee(const MeshPlan& plan) const {
  Oscillation oscillation(grid_, refining_.share);
  oscillation.foresee(plan.probe.departures(oscillation.narrow_size(), plan.tolerance));
  return oscillation;
}

/// Where leaves are hopeless.
Oscillation Halving::oscillation() const {
  Oscillation oscillation = foreseen_;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    if (!oscillates_ && mesh_.is_near(k)) continue;
    const Leaf& leaf = mesh_.leaves[k];
    if (leaf.oscillates) {
      oscillation.add(leaf, lattice_);
    } else if (!leaf.leads_to_pole && !mesh_.is_near(k)) {
      oscillation.add(leaf, {.centre = mesh_.off(k)}, lattice_);
    }
  }
  return oscillation;
}

/// Stops at a leaf that deviates too much but is not to be halved any more, and tells it why.
bool Halving::stop_if_done(Leaf& leaf, const Oscillation& oscillation) {
  if (leaf.given_up || leaf.oscillates || is_clipped(leaf) || stop_if_full()) return true;
  leaf.oscillates = oscillation.contains(leaf, lattice_);
  if (leaf.oscillates && !oscillates_) oscillates_ = lattice_.parameters(leaf.middle());
  return leaf.oscillates;
}

/// Halves of the leaves that deviate too much, among those that were measured since the last time,
/// since what stayed then stays; and of those that new crossings on their sides cut unclearly.
std::vector<Leaf> Halving::take_failed() {
  const std::uint32_t now = lattice_.next_moment();
  std::optional<Oscillation> hopeless;  // known once it is asked for
  std::vector<std::size_t> failed;
  std::vector<Leaf> halves;
  for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
    Leaf& leaf = mesh_.leaves[k];
    const bool is_cut_anew = leaf.is_split && lattice_.has_changed(leaf, taken_);
    if (leaf.measured <= taken_ && !is_cut_anew) continue;
    if (mesh_.is_near(k) && !leaf.is_split && !is_turned(k)) continue;
    const double off = mesh_.off(k);
    const double turned = turn(k);
    if (!(off > 1) && !(turned > 1) && !is_cut_unclearly(k)) continue;
    if (!hopeless) hopeless.emplace(oscillation());
    if (stop_if_done(leaf, *hopeless)) continue;
    const auto both = halve(leaf, splits_u(k), lattice_);
    if (!both) continue;
    failed.push_back(k);
    const double stricter = leaf.is_split ? 1 : std::clamp(off, 1.0, kMostStrict);
    for (Leaf half : *both) {
      half.strictness *= static_cast<float>(stricter);
      half.turn_strictness *= static_cast<float>(std::clamp(turned, 1.0, kMostStrict));
      halves.push_back(half);
    }
  }
  taken_ = now;
  mesh_.remove(failed);
  // A neighbour was halved, and the side that both share turns out to be defined.
  const auto is_no_more = [this](const Leaf& leaf) {
    return has_defined_corner(leaf, lattice_) && !stop_if_full();
  };
  std::ranges::copy_if(empty_, std::back_inserter(halves), is_no_more);
  std::erase_if(empty_, is_no_more);
  return halves;
}

/// The leaves that are defined at none of their samples, but elsewhere.
Halving::Failed Halving::take_islands(std::size_t& boxes) {
  std::vector<ParameterBox> where;
  for (const Leaf& leaf : empty_) {
    where.push_back({lattice_.parameters(leaf.low), lattice_.parameters(leaf.high)});
  }
  const auto found = find_defined(surface_, where, boxes, options_.threads);
  Failed failed;
  std::vector<Leaf> kept;
  for (std::size_t k = 0; k < where.size(); ++k) {
    if (!found[k] || stop_if_full()) {
      kept.push_back(empty_[k]);
      continue;
    }
    failed.witnesses.push_back({*found[k], {}, {}, {}, failed.leaves.size()});
    failed.leaves.push_back(empty_[k]);
  }
  empty_ = std::move(kept);
  return failed;
}

/// Whether a box in a leaf in which the surface is not defined would be seen if it was.
bool Halving::is_seen_hole(const Suspect& box) const {
  // A hole holds boxes half as wide as it is, or a little wider.
  constexpr double kOfTolerance = 0.5;
  const Leaf& leaf = mesh_.leaves[box.leaf];
  const dvec2 size = glm::abs(lattice_.parameters(leaf.high) - lattice_.parameters(leaf.low));
  const dvec2 part = box.size / size;
  const auto p = corner_positions(leaf, lattice_);
  const double along_u = std::max(glm::distance(p[0], p[1]), glm::distance(p[3], p[2]));
  const double along_v = std::max(glm::distance(p[0], p[3]), glm::distance(p[1], p[2]));
  return std::max(part.x * along_u, part.y * along_v) > kOfTolerance * mesh_.allowed[box.leaf];
}

/// The leaves in which bounds found places that deviate too much, holes that are seen, or tears.
Halving::Failed Halving::take_suspects() {
  const Certification proof =
      certify(surface_, grid_, lattice_, mesh_.leaves, mesh_.allowed, budget_);
  doubts_ = proof.doubts;
  std::vector<dvec2> middles;
  std::vector<std::size_t> suspected;
  for (const Suspect& suspect : proof.suspects) {
    middles.push_back(suspect.middle);
    suspected.push_back(suspect.leaf);
  }
  std::ranges::sort(suspected);
  suspected.erase(std::unique(suspected.begin(), suspected.end()), suspected.end());
  const LeafTriangles triangles =
      triangulate_leaves(mesh_.leaves, suspected, SingularCorners(), grid_, lattice_);
  const std::vector<SurfacePoint> points = evaluate(surface_, middles, options_.threads);
  std::vector<double> distances;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Suspect& suspect = proof.suspects[k];
    const auto number = std::ranges::lower_bound(suspected, suspect.leaf) - suspected.begin();
    distances.push_back(distance_from(grid_, triangles.of(static_cast<std::size_t>(number)),
                                      suspect.middle, points[k].position));
    Deviation& worst = mesh_.deviations[suspect.leaf];
    worst.distance = std::max(worst.distance, distances.back());
  }
  const Oscillation hopeless = oscillation();
  std::set<std::size_t> guilty;
  std::vector<Witness> witnesses;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Suspect& suspect = proof.suspects[k];
    const bool is_off =
        suspect.is_hole ? is_seen_hole(suspect) : distances[k] > mesh_.allowed[suspect.leaf];
    if (!is_off || stop_if_done(mesh_.leaves[suspect.leaf], hopeless)) {
      continue;
    }
    guilty.insert(suspect.leaf);
    witnesses.push_back(
        {suspect.middle, points[k].position, suspect.size, suspect.bend, suspect.leaf});
  }
  const std::vector<std::size_t> torn = find_torn(proof.suspects);
  guilty.insert(torn.begin(), torn.end());
  return take(guilty, std::move(witnesses));
}

/// The leaves with a tear alone.
Halving::Failed Halving::take_torn() {
  const Certification proof =
      certify(surface_, grid_, lattice_, mesh_.leaves, mesh_.allowed, budget_);
  const std::vector<std::size_t> torn = find_torn(proof.suspects);
  return take({torn.begin(), torn.end()}, {});
}

/// Where bounds do not exclude a jump, looks for one along the sides of leaves: along the surface,
/// as within a plane, none takes any sample far from its triangles. The leaves that are cut so.
std::vector<std::size_t> Halving::find_torn(std::span<const Suspect> suspects) {
  std::set<std::size_t> leaves;
  for (const Suspect& suspect : suspects) {
    const Leaf& leaf = mesh_.leaves[suspect.leaf];
    const bool is_done = leaf.given_up || leaf.oscillates || leaf.leads_to_pole || is_clipped(leaf);
    if (suspect.may_jump && !is_done) leaves.insert(suspect.leaf);
  }
  std::vector<Side> sides;
  for (const std::size_t k : leaves) append_unsearched(mesh_.leaves[k], lattice_, sides);
  sort_sides(sides);
  find_jumps(sides, crossing_options(false), lattice_);
  std::vector<std::size_t> torn;
  for (const std::size_t k : leaves) {
    Leaf& leaf = mesh_.leaves[k];
    leaf.is_split = count_cuts(leaf, lattice_).crossings > 0;
    if (leaf.is_split) torn.push_back(k);
  }
  return torn;
}

/// Takes leaves out, by their numbers, which witnesses tell them by.
Halving::Failed Halving::take(const std::set<std::size_t>& guilty, std::vector<Witness> witnesses) {
  for (Witness& witness : witnesses) {
    witness.cell =
        static_cast<std::size_t>(std::distance(guilty.begin(), guilty.find(witness.cell)));
  }
  Failed failed{{}, std::move(witnesses)};
  const std::vector<std::size_t> taken(guilty.begin(), guilty.end());
  for (const std::size_t k : taken) failed.leaves.push_back(mesh_.leaves[k]);
  mesh_.remove(taken);
  return failed;
}

}  // namespace saddle
