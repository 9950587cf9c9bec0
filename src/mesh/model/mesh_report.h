// The report of a mesh: its size, its errors, the singular places that were found, and the work.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/bounds.h"
#include "base/run_limits.h"
#include "base/vec.h"
#include "mesh/model/mesh.h"
#include "mesh/model/proof_gap.h"
#include "mesh/model/seam.h"
#include "surface/surface.h"

namespace saddle {

/// A place of the surface that the report names.
struct SingularPoint {
  dvec2 uv;
  bool has_limit = true;  ///< false: the normal there has no limit; the face's is used
  bool is_alone = false;  ///< it is known to be on no curve of such points
};

/// A point of space at which the surface is singular.
struct SingularInSpace {
  dvec2 uv;  ///< one of its places
  dvec3 position;
  std::vector<std::size_t> places;  ///< those of MeshReport::singular_points
  bool is_isolated = false;         ///< on no curve of such points
};

/// Lines of constant u and of constant v, in order.
struct ParameterLines {
  std::vector<double> u, v;
};

/// Findings, errors and costs of a mesh.
struct MeshReport {
  /// The share that was left out although the surface should be there.
  double unexpected_fraction() const { return region ? region->undefined : undefined_fraction; }

  std::size_t cells = 0;              ///< cells of the grid that are covered
  std::size_t evaluations = 0;        ///< points at which the surface was computed
  std::size_t boxes = 0;              ///< boxes of parameters in proofs
  double undefined_fraction = 0;      ///< share of the domain's cells that were left out
  std::optional<RegionShare> region;  ///< shares by the surface's condition, if it has one
  bool exceeds_doubles = false;       ///< these are defined, with numbers too large for doubles
  std::size_t flat_triangles = 0;     ///< triangles left out: without area in double precision
  bool stopped_early = false;         ///< as MeshRequest asks: there is no mesh
  std::optional<double> tolerance;    ///< the limit of max_error
  /// The rounding of positions, where it exceeds the tolerance: it is the limit in its place.
  std::optional<double> rounding;
  double least_triangles = 0;          ///< estimate of the least that any mesh needs; 0: unknown
  bool reached_limit = false;          ///< the limit of triangles ended refinement
  bool budget_spent = false;           ///< the budget of effort ended refinement
  Shortage shortage = Shortage::None;  ///< what the run had too little of when refinement ended
  std::size_t effort = 0;              ///< Effort::total()
  bool certified = false;              ///< proved: no feature hides between samples
  std::vector<ProofGap> proof_gaps;    ///< boxes where that is not proved, at most 1000
  double proved_fraction = 0;          ///< share of the domain where that is proved
  double max_error = 0;                ///< largest distance of mesh and surface that was found
  bool error_is_bound = false;         ///< max_error is an upper bound; else a search's result
  double max_normal_error = 0;         ///< degrees between interpolated and exact normals, in
                                       ///< cells larger than the tolerance
  /// A place where normals stay off by more than allowed: the triangles for them were too many.
  std::optional<dvec2> coarse_normals;
  /// The place of max_error, if it exceeds the tolerance; a place beside which the surface is
  /// unresolvable: it oscillates faster than a picture shows.
  std::optional<dvec2> worst_place, oscillates;
  std::vector<SingularPoint> singular_points;  ///< one per singular (u, v), at most 1000
  std::size_t singular_point_count = 0;
  std::vector<SingularInSpace> singular_in_space;  ///< the points of these, each once
  /// Lines of constant u and of constant v that are known to be singular from end to end.
  std::vector<double> singular_u, singular_v;
  std::vector<dvec2> poles;  ///< places where the surface was cut before infinity, at most 1000
  std::size_t pole_count = 0;
  ParameterLines pole_lines;  ///< along which poles were found from end to end, by all their places
  /// A box around the last points before poles, as far as doubles go, or as they would beside 0,
  /// and around vertices so far away that the mesh was not made (MeshRequest::stop).
  Bounds beside_poles;
  std::vector<dvec2> jumps;  ///< places of jumps, at most 1000
  std::size_t jump_count = 0;
  ParameterLines jump_lines;  ///< of jumps, likewise
  /// The first of the jumps: essential points, which the surface approaches differently from each
  /// side; at most 1000.
  std::vector<dvec2> without_limit;
  bool is_clipped = false;     ///< along a clip box, given or chosen
  std::optional<Bounds> clip;  ///< the box that the mesh was cut along because of poles
  std::string closed_u;        ///< Seam::name() of the edges u0 and u1
  std::string closed_v;
  Shift shift_u, shift_v;             ///< of edges that join
  std::array<bool, 2> folded_u = {};  ///< whether u0 and u1 are folded; see Seams
  std::array<bool, 2> folded_v = {};
  bool orientable = true;  ///< false: the surface is one-sided
};

struct MeshResult {
  Mesh mesh;
  MeshReport report;
};

/// Counts a singular point and lists it. An even choice of more than kMaxListed stays in the list,
/// and all that have no limit of the normal.
void add_singular_point(const dvec2& uv, MeshReport& report);
/// The normal has no limit at the point that was added last.
void mark_without_limit(MeshReport& report);

}  // namespace saddle
