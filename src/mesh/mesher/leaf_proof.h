// Interval proofs over the leaves of a mesh: the boxes of parameters without a proof, the
// counterexamples in them, and the proof gaps that the report names.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validated_mesh.h"
#include "mesh/model/counterexample.h"
#include "mesh/model/mesh_report.h"
#include "mesh/proof/certify.h"
#include "mesh/proof/report_proof.h"

namespace saddle {

class CellTree;

class LeafProof {
 public:
  LeafProof(const Surface& surface, const Grid& grid, const CellTree& tree, unsigned threads);

  /// The boxes without a proof. Keeps the proof gaps for the report.
  std::vector<UnprovedBox> prove(const ValidatedMesh& mesh);
  /// The boxes without a proof. The gaps of the last prove() stay for the report.
  std::vector<UnprovedBox> find_unproved(const ValidatedMesh& mesh);

  /// The middles of boxes that are farther from their leaf's triangles than allowed, or in a
  /// visible hole. `cell` is the index of the leaf. The distances are added to the sampled errors.
  std::vector<Counterexample> refute(std::span<const UnprovedBox> boxes, ValidatedMesh& mesh) const;

  /// Leaves the boxes of leaves unproved whose triangles were left out.
  void leave_unproved(std::span<const Leaf> leaves);
  /// Fills in what is proved of the mesh, and its proof gaps. `reached_limit`: subdivision ended
  /// at the limit of triangles, which leaves the whole domain unproved.
  void complete(bool reached_limit, MeshReport& report);

 private:
  Certification certify_leaves(const ValidatedMesh& mesh);
  bool is_visible_hole(const UnprovedBox& box, const ValidatedMesh& mesh) const;
  void leave_domain_unproved(GapReason why);
  void name_gaps(const MeshReport& report);

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  unsigned threads_;
  ProofBudget budget_;
  std::optional<Certification> proof_;  // the last; empty: none was tried
  ProvedCells cells_;                   // that it was tried for
};

}  // namespace saddle
