// Cells of a root grid halved until tests, fresh samples and bounds find nothing more.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "mesh/error/error_indicator.h"
#include "mesh/error/validator.h"
#include "mesh/mesher/mesh_plan.h"
#include "mesh/mesher/oscillation.h"
#include "mesh/mesher/remove_singular_cells.h"
#include "mesh/mesher/subdivide.h"
#include "mesh/mesher/trace_options.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/point_union.h"
#include "mesh/proof/certify.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/leaf_mesh.h"
#include "mesh/tree/match_seams.h"
#include "mesh/tree/singular_corners.h"

namespace saddle {

class AdaptiveMesher {
 public:
  /// Takes the plan's lines. Throws Error (Nothing) as mesh_on_grid() does.
  AdaptiveMesher(const Surface& surface, const MeshRequest& request, MeshPlan& plan);

  /// Halves until nothing is found any more, and cuts poles out.
  void run(std::vector<Counterexample> counterexamples);

  /// Whether poles or far vertices were found that the request stops at: there are no leaves.
  bool stops_early() const { return may_stop() && (tree_.has_poles() || !far_.empty()); }
  /// A box around the vertices that are too far away.
  const Bounds& far() const { return far_; }

  /// The leaves, and how far off they are.
  const ValidatedMesh& measured() const { return mesh_; }
  const CellTree& tree() const { return tree_; }
  /// Points in leaves that are left out with them.
  const std::vector<PlacedSingularity>& singularities() const { return singularities_; }
  /// The vertices, and all that is to become of the mesh.
  Grid& grid() { return grid_; }
  const Grid& grid() const { return grid_; }

  /// Gives singular vertices the corners that leaves see there, and measures those leaves once
  /// more. The triangles of all.
  LeafTriangles triangulate(MeshReport& report);

  /// Whether nothing of a leaf will be left.
  bool is_clipped(const Leaf& leaf) const;
  /// Whether a part of a leaf is beyond a face of the box that a mesh is clipped to.
  bool crosses_box(const Leaf& leaf) const;
  /// How wide a leaf is where it is narrow; of one on the boundary what of it is defined.
  double width(const Leaf& leaf) const;

  /// Has vertices where the surface oscillates too fast reach its extremes, once nothing is
  /// measured any more.
  void reach_extremes();

  /// What is to be said of the way here.
  void complete(MeshReport& report);

 private:
  /// Leaves that are to be refined, and the counterexamples against them.
  struct Failed {
    std::vector<Leaf> leaves;
    std::vector<Counterexample> counterexamples;
  };

  bool is_unrefined() const { return request_.method == MeshRequest::Method::Samples; }
  bool certifies() const { return request_.certify && !is_unrefined(); }
  bool may_stop() const { return request_.stop != MeshRequest::Stop::Never; }
  void leave_all_unproved(GapReason why);
  void name_proof_gaps(MeshReport& report);
  Seams weld_if_two_dimensional(const Probe& probe);
  TraceOptions trace_options(bool poles) const;
  bool stop_if_full();
  void add(const Failed& failed, const SubdivisionGoal& goal);
  void take(const Subdivision& subdivision);
  bool revalidate();
  void measure(std::span<const std::size_t> which, const SingularCorners& singular);
  bool validate_singular();
  bool splits_u(std::size_t number);
  bool has_singular_side(const SampleVertices& samples, std::size_t along) const;
  bool has_lasting_triangles(std::size_t number) const;
  bool is_cut_unclearly(std::size_t number) const;
  bool is_turned(std::size_t number) const;
  double turn(std::size_t number);
  Oscillation predict(const MeshPlan& plan) const;
  Oscillation oscillation() const;
  void look_far();
  bool stop_if_done(Leaf& leaf, const Oscillation& oscillation);
  std::vector<Leaf> take_failed();
  Failed take_small_components(std::size_t& boxes);
  bool is_visible_hole(const UnprovedBox& box) const;
  std::vector<std::size_t> find_points_without_limit(std::span<const UnprovedBox> unproved_boxes);
  Failed take(const std::set<std::size_t>& guilty, std::vector<Counterexample> counterexamples);
  Failed take_unproved_boxes();
  Failed take_points_without_limit();

  const Surface& surface_;
  const MeshRequest& request_;
  const RefineOptions limits_;
  Grid grid_;
  Seams seams_;
  PointUnion points_;
  CellTree tree_;
  ErrorIndicator indicator_;
  Validator validator_;
  Oscillation predicted_;
  ValidatedMesh mesh_;
  LastLimits normal_limits_;
  /// Outside of it vertices are too far away.
  Bounds proportionate_{dvec3(-std::numeric_limits<double>::infinity()),
                        dvec3(std::numeric_limits<double>::infinity())};
  Bounds far_;
  std::size_t seen_ = 0;     // vertices that look_far() has looked at
  std::uint32_t taken_ = 0;  // when take_failed() last looked: RevisionClock::next()
  std::vector<Leaf> empty_;  // no part of the mesh: the surface is not defined at their samples
  std::vector<PlacedSingularity> singularities_;
  ProofBudget budget_;
  bool reached_limit_ = false;
  std::optional<dvec2> coarse_normals_;
  std::optional<dvec2> oscillates_;
  std::optional<std::vector<ProofGap>> proof_gaps_;  // nothing: no proof was tried
  bool meets_itself_ = false;                        // poles at one place are one point
};

}  // namespace saddle
