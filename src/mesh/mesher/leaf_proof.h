// Interval proofs over the leaves of a mesh: the boxes of parameters without a proof, the
// counterexamples in them, and the proof gaps that the report names.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validated_mesh.h"
#include "mesh/model/counterexample.h"
#include "mesh/model/mesh_report.h"
#include "mesh/proof/certify.h"
#include "mesh/proof/report_proof.h"

namespace saddle {

class BoxMeasure;
class CellTree;

class LeafProof {
 public:
  /// `clip`: the surface outside of it needs no proof. `share`: of a ProofBudget.
  LeafProof(const Surface& surface, const Grid& grid, const CellTree& tree,
            const std::optional<Bounds>& clip, double share, unsigned threads);

  /// The result of a proof that was tried.
  struct Result {
    std::vector<std::uint32_t> may_jump;  ///< leaves with a box where bounds do not exclude a jump
    /// Points that are farther from their leaf's triangles than allowed, or in a visible hole.
    /// `cell` is the index of the leaf.
    std::vector<Counterexample> counterexamples;
  };

  /// Proves the leaves that are new or whose triangles changed. Adds measured distances to the
  /// sampled errors. Keeps the proof gaps for the report.
  Result prove(ValidatedMesh& mesh);
  /// Whether a proof was tried.
  bool was_tried() const { return proof_.has_value(); }
  /// Whether a leaf with its triangles is proved, and its bounds leave no room for a tip that is
  /// off by more than the tolerance.
  bool is_proved_smooth(const ValidatedMesh& mesh, std::size_t leaf) const {
    return is_proved(mesh, leaf) && !mesh.marks[leaf].is_rough;
  }
  /// Whether a leaf with its triangles is proved.
  bool is_proved(const ValidatedMesh& mesh, std::size_t leaf) const {
    return mesh.marks[leaf].is_proved;
  }
  /// Whether the work of proofs is done: only some of the worst places are searched.
  bool is_spent() const { return budget_.is_spent(true); }
  /// The leaves, of those without a proof, in which bounds do not exclude a jump. All leaves of a
  /// small mesh are tried to prove, which adds measured distances: they tell more of how far it is
  /// off, and take more time. The gaps of the last prove() stay for the report.
  std::vector<std::uint32_t> find_may_jump(std::span<const std::uint32_t> leaves,
                                           ValidatedMesh& mesh);

  /// Leaves the boxes of leaves unproved whose triangles were left out.
  void leave_unproved(std::span<const Leaf> leaves);
  /// Fills in what is proved of the mesh, and its proof gaps. `reached_limit`: subdivision ended
  /// at the limit of triangles, which leaves the whole domain unproved.
  void complete(bool reached_limit, KnownHulls& hulls, MeshReport& report);

 private:
  ProvedCells cells_of(const ValidatedMesh& mesh) const;
  /// Numbers of leaves. At first all leaves of a fine mesh have no proof.
  struct Leaves {
    std::size_t count = 0;
    std::vector<std::uint32_t> numbers;  ///< empty: all leaves

    std::size_t operator[](std::size_t k) const { return numbers.empty() ? k : numbers[k]; }
  };
  Leaves unproved_leaves(const ValidatedMesh& mesh) const;
  void refute(std::span<const UnprovedBox> boxes, const Leaves& leaves, BoxMeasure& measure,
              ValidatedMesh& mesh, Result& result);
  bool is_visible_hole(const UnprovedBox& box, const ValidatedMesh& mesh) const;
  void leave_domain_unproved(GapReason why);
  void name_gaps(const MeshReport& report);

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  ProofBudget budget_;
  std::size_t from_mesh_ = 0;           // distances that prove() took from the whole mesh
  std::optional<Certification> proof_;  // the last; empty: none was tried
  ProvedCells cells_;                   // of the mesh that it was tried for
};

}  // namespace saddle
