// Adaptive refinement: solve, estimate, mark, refine. The leaves of a cell tree are subdivided
// until error indicators, validation points and interval proofs find no error above the tolerance.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "mesh/error/open_leaves.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/mesher/leaf_landmarks.h"
#include "mesh/mesher/leaf_proof.h"
#include "mesh/mesher/leaf_validation.h"
#include "mesh/mesher/mesh_plan.h"
#include "mesh/mesher/oscillation.h"
#include "mesh/mesher/remove_singular_cells.h"
#include "mesh/mesher/split_direction.h"
#include "mesh/mesher/subdivide.h"
#include "mesh/mesher/trace_options.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/point_union.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/match_seams.h"

namespace saddle {

class AdaptiveMesher {
 public:
  /// Moves the root lines out of the plan. Throws Error (Nothing) as mesh_on_grid() does.
  AdaptiveMesher(const Surface& surface, const MeshRequest& request, MeshPlan& plan);

  /// Subdivides leaves until no error is found, and removes singular cells.
  void run(std::vector<Counterexample> counterexamples);

  /// Whether poles, far vertices or the need of another clip box were found, at which the request
  /// stops. There are no leaves to use then.
  bool stops_early() const {
    return needs_other_box_ || (may_stop() && (tree_.has_poles() || !far_vertices_.empty()));
  }
  /// A box around the vertices that are farther away than the request allows.
  const Bounds& far_vertices() const { return far_vertices_; }

  /// MeshPlan::coarser: by how much the mesh may miss the tolerance.
  double coarser() const { return coarser_; }
  /// The leaves and their sampled errors.
  const ValidatedMesh& mesh() const { return mesh_; }
  const CellTree& tree() const { return tree_; }
  const LeafLandmarks& landmarks() const { return landmarks_; }
  const LeafProof& proof() const { return proof_; }
  KnownHulls& hulls() const { return hulls_; }
  /// Point singularities inside leaves, which are left out.
  const std::vector<PlacedSingularity>& singularities() const { return singularities_; }
  /// The root grid; its mesh has the vertices of all leaves.
  Grid& grid() { return grid_; }
  const Grid& grid() const { return grid_; }

  /// The triangles of all leaves, in their order. Singular vertices get a corner for each limit of
  /// the normal.
  LeafTriangles& triangulate(MeshReport& report);

  /// Whether a leaf is outside of the clip box.
  bool is_clipped(const Leaf& leaf) const;
  /// Whether a corner of a leaf is outside of the clip box.
  bool crosses_box(const Leaf& leaf) const;

  /// Moves vertices to the extremes of the surface nearby where it oscillates too fast for the
  /// mesh. Follows all validation.
  void reach_extremes();

  /// Fills in the report's counters and findings. `triangles`: those of triangulate().
  void complete(const LeafTriangles& triangles, MeshReport& report);

 private:
  bool is_refined() const { return limits_.triangles.is_refined; }
  bool may_grow() const { return is_refined() && !reached_limit_; }
  bool certifies() const { return request_.certify && may_grow(); }
  bool may_stop() const { return request_.stop != MeshRequest::Stop::Never; }
  Seams weld_if_two_dimensional(const Probe& probe);
  TraceOptions trace_options() const;
  bool stop_if_full();
  void refine(ActiveLeaves active, const SubdivisionGoal& goal);
  void append(Subdivision subdivision);
  std::vector<std::size_t> follow_all_features();
  void join_points();
  void place_inner_vertices(std::size_t first);
  void find_far_vertices();
  ActiveLeaves next_active();
  double normal_error_ratio(std::size_t leaf);
  Oscillation predict(const MeshPlan& plan) const;
  Oscillation oscillation() const;
  bool is_small(const Leaf& leaf) const;
  bool leave_out(std::size_t number);
  bool is_wall_at_pole(const Leaf& leaf) const;
  void leave_out_unclear();
  bool take_news_of_left_out();
  std::vector<Leaf> halve_missed();
  std::optional<std::array<Leaf, 2>> halve_cut(std::size_t number);
  bool stop_if_done(Leaf& leaf, const Oscillation& oscillation);
  /// Error ratios of distances and of normals.
  struct Failure {
    double distance, normal;
  };
  void ask_forgotten_samples();
  bool was_tested(const Leaf& leaf) const;
  std::optional<Failure> failure_of(std::size_t number);
  std::vector<Leaf> halve_failed();
  std::vector<Leaf> reactivate_defined(std::uint32_t since);
  void follow_thin_parts(const Oscillation& known, const SubdivisionGoal& goal);
  void take_thinly_cut(std::uint32_t since, std::vector<std::size_t>& numbers,
                       std::vector<Leaf>& active) const;
  bool may_get_jump(const Leaf& leaf) const;
  std::vector<std::size_t> find_jumping(std::span<const std::uint32_t> may_jump);
  ActiveLeaves activate(const std::set<std::size_t>& numbers,
                        std::vector<Counterexample> counterexamples);
  std::set<std::size_t> drop_done(std::vector<Counterexample>& counterexamples);
  ActiveLeaves activate_refuted();
  std::vector<Counterexample> find_features();
  ActiveLeaves activate_with_features();
  bool may_hide_feature(std::size_t leaf) const;
  void leave_flat_unproved(const LeafTriangles& triangles);
  ActiveLeaves activate_jumping();

  const Surface& surface_;
  const MeshRequest& request_;
  const CellLimits limits_;
  const double coarser_;
  Grid grid_;
  Seams seams_;
  PointUnion points_;
  CellTree tree_;
  ValidatedMesh mesh_;
  LeafLandmarks landmarks_;
  LeafValidation validation_;
  SplitDirection direction_;
  LeafProof proof_;
  mutable KnownHulls hulls_;
  OpenLeaves open_;
  Oscillation predicted_;
  /// Vertices outside of it are far.
  Bounds proportionate_{dvec3(-std::numeric_limits<double>::infinity()),
                        dvec3(std::numeric_limits<double>::infinity())};
  Bounds far_vertices_;
  std::size_t seen_ = 0;      // vertices that find_far_vertices() has tested
  std::uint32_t halved_ = 0;  // revision of the last halve_failed()
  std::vector<Leaf> empty_;   // not in the mesh: the surface is defined at none of their samples
  std::vector<PlacedSingularity> singularities_;
  bool has_new_left_out_ = false;  ///< leaves that are too small
  std::uint32_t seen_left_out_ = RevisionClock::kNever;
  bool has_forgotten_ = false;     ///< leaves may lack samples
  bool has_halved_spent_ = false;  ///< leaves were halved when the work of proofs was done
  bool needs_other_box_ = false;   // MeshRequest::needs_other_box
  bool reached_limit_ = false;
  std::optional<dvec2> coarse_normals_;
  std::optional<dvec2> oscillates_;
  bool has_shared_chords_ = false;  // join_poles(): leaves may have chords in common
};

}  // namespace saddle
