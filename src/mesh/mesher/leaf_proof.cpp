#include "mesh/mesher/leaf_proof.h"

#include <algorithm>

#include "mesh/error/error_indicator.h"
#include "mesh/grid/grid.h"
#include "mesh/proof/report_proof.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/patches.h"
#include "mesh/tree/singular_corners.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// A hole is visible if a box in it is longer than 0.5 tolerances: a hole holds boxes about half as
/// wide as itself.
constexpr double kVisibleHole = 0.5;

}  // namespace

LeafProof::LeafProof(const Surface& surface, const Grid& grid, const CellTree& tree,
                     unsigned threads)
    : surface_(surface), grid_(grid), tree_(tree), threads_(threads), budget_(surface.bounds) {}

Certification LeafProof::certify_leaves(const ValidatedMesh& mesh) {
  const std::vector<Patch> patches = patches_of(mesh.leaves, mesh.allowed, grid_, tree_);
  cells_ = proved_cells(patches, surface_.domain);
  return certify(surface_, root_lines(grid_), patches, budget_);
}

std::vector<UnprovedBox> LeafProof::prove(const ValidatedMesh& mesh) {
  proof_ = certify_leaves(mesh);
  return std::move(proof_->unproved_boxes);
}

std::vector<UnprovedBox> LeafProof::find_unproved(const ValidatedMesh& mesh) {
  return certify_leaves(mesh).unproved_boxes;
}

std::vector<Counterexample> LeafProof::refute(std::span<const UnprovedBox> boxes,
                                              ValidatedMesh& mesh) const {
  std::vector<dvec2> middles;
  std::vector<std::size_t> leaves;
  for (const UnprovedBox& box : boxes) {
    middles.push_back(box.middle);
    leaves.push_back(box.patch);
  }
  std::ranges::sort(leaves);
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  const LeafTriangles triangles =
      triangulate_leaves(mesh.leaves, leaves, SingularCorners(), grid_, tree_);
  const std::vector<SurfacePoint> points = evaluate(surface_, middles, threads_);
  std::vector<Counterexample> counterexamples;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const UnprovedBox& box = boxes[k];
    const auto number = std::ranges::lower_bound(leaves, box.patch) - leaves.begin();
    const double distance = distance_from(grid_, triangles.of(static_cast<std::size_t>(number)),
                                          box.middle, points[k].position);
    mesh.add(box.patch, distance);
    const bool exceeds_tolerance =
        box.is_undefined ? is_visible_hole(box, mesh) : distance > mesh.allowed[box.patch];
    if (exceeds_tolerance)
      counterexamples.push_back({box.middle, points[k].position, box.size, box.bend, box.patch});
  }
  return counterexamples;
}

/// Whether a box in which the surface is undefined shows in the mesh.
bool LeafProof::is_visible_hole(const UnprovedBox& box, const ValidatedMesh& mesh) const {
  const Leaf& leaf = mesh.leaves[box.patch];
  const dvec2 size =
      glm::abs(tree_.vertices().parameters(leaf.high) - tree_.vertices().parameters(leaf.low));
  const dvec2 part = box.size / size;
  const auto p = corner_positions(leaf, tree_);
  const double along_u = std::max(glm::distance(p[0], p[1]), glm::distance(p[3], p[2]));
  const double along_v = std::max(glm::distance(p[0], p[3]), glm::distance(p[1], p[2]));
  return std::max(part.x * along_u, part.y * along_v) > kVisibleHole * mesh.allowed[box.patch];
}

void LeafProof::leave_unproved(std::span<const Leaf> leaves) {
  if (!proof_) return;
  for (const Leaf& leaf : leaves) {
    const ProofGap gap{GapReason::Flat, tree_.vertices().parameters(leaf.low),
                       tree_.vertices().parameters(leaf.high)};
    // The leaf may hold gaps, or lie in one.
    std::erase_if(proof_->proof_gaps, [&gap](const ProofGap& other) {
      return gap.contains(0.5 * other.low + 0.5 * other.high);
    });
    const dvec2 middle = 0.5 * gap.low + 0.5 * gap.high;
    const auto holds = [&middle](const ProofGap& other) { return other.contains(middle); };
    if (std::ranges::none_of(proof_->proof_gaps, holds)) proof_->proof_gaps.push_back(gap);
  }
}

void LeafProof::complete(bool reached_limit, MeshReport& report) {
  if (reached_limit) leave_domain_unproved(GapReason::Triangles);
  if (!proof_) leave_domain_unproved(GapReason::NotTried);
  name_gaps(report);
  report_proof(surface_, cells_, threads_, *proof_, report);
  report.work.boxes += ProofBudget(surface_.bounds).boxes - budget_.boxes;
}

void LeafProof::leave_domain_unproved(GapReason why) {
  const Domain& d = surface_.domain;
  proof_ = {{}, {{why, {d.u0, d.v0}, {d.u1, d.v1}}}};
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
