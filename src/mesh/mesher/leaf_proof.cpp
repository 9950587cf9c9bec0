#include "mesh/mesher/leaf_proof.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "mesh/distance/measure_boxes.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/error/error_indicator.h"
#include "mesh/grid/grid.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/jump_search.h"
#include "mesh/proof/report_proof.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/patches.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// A hole is visible if a box in it is longer than 0.5 tolerances: a hole holds boxes about half as
/// wide as itself.
constexpr double kVisibleHole = 0.5;

}  // namespace

LeafProof::LeafProof(const Surface& surface, const Grid& grid, const CellTree& tree,
                     const std::optional<Bounds>& clip, double share, unsigned threads)
    : surface_(surface),
      grid_(grid),
      tree_(tree),
      clip_(clip),
      threads_(threads),
      budget_(surface.bounds, share) {}

LeafProof::Leaves LeafProof::unproved_leaves(const ValidatedMesh& mesh) const {
  Leaves leaves;
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) leaves.count += is_proved(mesh, k) ? 0 : 1;
  if (leaves.count == mesh.leaves.size()) return leaves;
  leaves.numbers.reserve(leaves.count);
  for (std::uint32_t k = 0; k < mesh.leaves.size(); ++k) {
    if (!is_proved(mesh, k)) leaves.numbers.push_back(k);
  }
  return leaves;
}

ProvedCells LeafProof::cells_of(const ValidatedMesh& mesh) const {
  const dvec2 range = box_of(surface_.domain).size();
  ProvedCells cells;
  for (const Leaf& leaf : mesh.leaves) {
    cells.add(tree_.box(leaf).size(), range);
  }
  return cells;
}

LeafProof::Result LeafProof::prove(ValidatedMesh& mesh) {
  const Leaves leaves = unproved_leaves(mesh);
  const Patches patches{
      leaves.count,
      [&](std::size_t number) {
        const std::size_t k = leaves[number];
        Patch patch = patch_of(mesh.leaves[k], mesh.allowed[k], grid_, tree_);
        patch.is_measured |= !mesh.triangles.ranges[k].is_complete();
        return patch;
      },
      [&](std::size_t number) { return root_cell_of(mesh.leaves[leaves[number]], grid_); }};
  budget_.allow_for(tree_.effort().total());
  BoxMeasure measure(surface_, grid_, patches,
                     {[&](std::size_t patch) { return mesh.triangles.of(leaves[patch]); },
                      [&] {
                        mesh.tidy_triangles();
                        return NearestTriangles(grid_, mesh.triangles.all);
                      }},
                     clip_, budget_, threads_);
  Result result;
  from_mesh_ = 0;
  const double bound = proof_ ? proof_->bound : 0;
  proof_.reset();  // both would take much memory
  const BoxHandlers handlers = {
      std::ref(measure),
      [&](std::span<const UnprovedBox> boxes) { refute(boxes, leaves, measure, mesh, result); },
      threads_};
  Certification proof = certify(surface_, root_lines(grid_), patches, clip_, handlers, budget_);
  proof.bound = std::max(proof.bound, bound);
  for (std::size_t k = 0; k < leaves.count; ++k) {
    const std::size_t leaf = leaves[k];
    if (proof.proved[k] != 0) mesh.marks[leaf].is_proved = true;
    if (proof.rough[k] != 0) mesh.marks[leaf].is_rough = true;
  }
  for (const BoxMeasure::Found& found : measure.found()) {
    result.counterexamples.push_back(found.counterexample);
    const std::size_t leaf = leaves[found.counterexample.cell];
    result.counterexamples.back().cell = leaf;
    mesh.add(leaf, found.distance, found.counterexample.uv);
  }
  cells_ = cells_of(mesh);
  proof_ = std::move(proof);
  return result;
}

std::vector<std::uint32_t> LeafProof::find_may_jump(std::span<const std::uint32_t> leaves,
                                                    ValidatedMesh& mesh) {
  if (mesh.leaves.size() <= kKeptAtATime) {
    auto before = std::pair(std::move(proof_), cells_);
    std::vector<std::uint32_t> found = prove(mesh).may_jump;
    std::tie(proof_, cells_) = std::move(before);
    return found;
  }
  budget_.allow_for(tree_.effort().total());
  const std::vector<std::uint8_t> cells = cells_that_may_jump(surface_, root_lines(grid_), budget_);
  std::vector<std::uint32_t> unproved;
  std::vector<JumpBox> boxes;
  for (const std::uint32_t k : leaves) {
    const Leaf& leaf = mesh.leaves[k];
    if (is_proved(mesh, k) || cells[root_cell_of(leaf, grid_)] == 0) continue;
    unproved.push_back(k);
    boxes.push_back({tree_.box(leaf), mesh.allowed[k]});
  }
  std::vector<std::uint32_t> found;
  for (const std::size_t k : saddle::find_may_jump(surface_, boxes, budget_, threads_))
    found.push_back(unproved[k]);
  return found;
}

/// Looks at boxes without a proof of the patches of leaves. Beside a feature the nearest triangle
/// may be a neighbour's. That is looked for a few times: where many are off, their surface is.
void LeafProof::refute(std::span<const UnprovedBox> boxes, const Leaves& leaves,
                       BoxMeasure& measure, ValidatedMesh& mesh, Result& result) {
  std::vector<dvec2> middles;
  for (const UnprovedBox& box : boxes) middles.push_back(box.middle);
  const std::vector<dvec3> points = evaluate_positions(surface_, middles, threads_);
  for (std::size_t k = 0; k < points.size(); ++k) {
    UnprovedBox box = boxes[k];
    box.patch = leaves[box.patch];
    if (box.may_jump) result.may_jump.push_back(static_cast<std::uint32_t>(box.patch));
    if (!box.is_undefined && !is_seen(clip_, points[k])) continue;
    const double allowed = mesh.allowed[box.patch];
    const double known = std::min(allowed, mesh.sampled_errors[box.patch].distance);
    double distance =
        distance_from(grid_, mesh.triangles.of(box.patch), box.middle, points[k], known);
    if (distance > allowed && !mesh.leaves[box.patch].state.is_whole() &&
        from_mesh_++ < kFirstSearched)
      distance = measure.distance_from_mesh(points[k], distance);
    mesh.add(box.patch, distance, box.middle);
    const bool exceeds_tolerance =
        box.is_undefined ? is_visible_hole(box, mesh) : distance > allowed;
    if (exceeds_tolerance)
      result.counterexamples.push_back({box.middle, points[k], box.size, box.bend, box.patch});
  }
}

/// Whether a box in which the surface is undefined shows in the mesh.
bool LeafProof::is_visible_hole(const UnprovedBox& box, const ValidatedMesh& mesh) const {
  const Leaf& leaf = mesh.leaves[box.patch];
  const dvec2 part = box.size / tree_.vertices().size(leaf.low, leaf.high());
  const auto p = corner_positions(leaf, tree_);
  const double along_u = std::max(glm::distance(p[0], p[1]), glm::distance(p[3], p[2]));
  const double along_v = std::max(glm::distance(p[0], p[3]), glm::distance(p[1], p[2]));
  return std::max(part.x * along_u, part.y * along_v) > kVisibleHole * mesh.allowed[box.patch];
}

void LeafProof::leave_unproved(std::span<const Leaf> leaves) {
  if (!proof_) return;
  for (const Leaf& leaf : leaves) {
    const auto [low, high] = tree_.box(leaf);
    const GapBox gap{GapReason::Flat, low, high};
    // The leaf may hold gaps, or lie in one.
    std::erase_if(proof_->proof_gaps, [&gap](const GapBox& other) {
      return gap.contains(0.5 * other.low + 0.5 * other.high);
    });
    const dvec2 middle = 0.5 * gap.low + 0.5 * gap.high;
    const auto holds = [&middle](const GapBox& other) { return other.contains(middle); };
    if (std::ranges::none_of(proof_->proof_gaps, holds)) proof_->proof_gaps.push_back(gap);
  }
}

void LeafProof::complete(bool reached_limit, KnownHulls& hulls, MeshReport& report) {
  if (reached_limit) leave_domain_unproved(GapReason::Triangles);
  if (!proof_) leave_domain_unproved(GapReason::NotTried);
  name_gaps(report);
  report_proof(surface_, cells_, threads_, hulls, *proof_, report);
  report.boxes += budget_.boxes();
}

void LeafProof::leave_domain_unproved(GapReason why) {
  const Domain& d = surface_.domain;
  proof_.emplace().proof_gaps = {{why, {d.u0, d.v0}, {d.u1, d.v1}}};
}

/// Replaces the reasons that follow from bounds alone by what the report says of places in the
/// gaps.
void LeafProof::name_gaps(const MeshReport& report) {
  GapReasons names;
  for (const dvec2& uv : report.without_limit) names.add(GapReason::NoLimit, uv);
  for (const dvec2& uv : report.poles) names.add(GapReason::Pole, uv);
  for (const dvec2& uv : report.jumps) names.add(GapReason::Jump, uv);
  for (const SingularPoint& point : report.singular_points)
    names.add(GapReason::Singular, point.uv);
  names.give_to(proof_->proof_gaps);
}

}  // namespace saddle
