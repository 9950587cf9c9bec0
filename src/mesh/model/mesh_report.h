// The report of a mesh: its size, its errors, the singular places that were found, and the work.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/bounds.h"
#include "base/vec.h"
#include "mesh/model/mesh.h"
#include "mesh/model/proof_gap.h"
#include "mesh/model/seam.h"

namespace saddle {

/// A place of the surface that the report names.
struct SingularPoint {
  dvec2 uv;
  bool has_limit = true;  ///< false: the normal there has no limit; the face's is used
  bool is_alone = false;  ///< it is known to be on no curve of such points
};

/// What a mesh was made with, counted.
struct MeshWork {
  std::size_t grid_samples = 0;  ///< points in step with each other, on a tensor grid of parameters
  std::size_t leaf_samples = 0;  ///< points of a mesh whose cells are halved
  std::size_t boxes = 0;         ///< of parameters, that proofs tried
  std::size_t searches = 0;      ///< points and boxes, in search of jumps, poles and creases
  void add(const MeshWork& other) {
    searches += other.searches;
    grid_samples += other.grid_samples;
    leaf_samples += other.leaf_samples;
    boxes += other.boxes;
  }
};

/// Why a mesh is a grid, or why its cells were halved instead.
struct MeshChoice {
  enum class Why {
    GridIsCheaper,
    HalvingIsCheaper,
    Asked,            ///< for the fewest triangles
    Limited,          ///< a box cuts the surface, or its triangles are limited
    VariesTolerance,  ///< with the place
    NotSmooth,   ///< what a grid cannot do: boundaries, jumps, poles, creases, points without a
                 ///< normal
    GridMisses,  ///< the tolerance, where nobody could have known before
  };
  Why why = Why::Asked;
  std::size_t cells_u = 0, cells_v = 0;    ///< of the grid that was thought of, 0: of none
  std::size_t grids = 0;                   ///< that were thought of, each with closer lines
  double grid_cost = 0, halving_cost = 0;  ///< milliseconds by the model, 0: not estimated
  double excess = 0;                       ///< by how much the grid missed, in tolerances
};

/// What meshing found out and what it cost.
struct MeshReport {
  std::size_t cells = 0;             ///< cells of the grid that are covered
  std::size_t evaluations = 0;       ///< points at which the surface was computed
  MeshWork work;                     ///< with that of grids that came to nothing
  std::optional<MeshChoice> choice;  ///< nothing: there was none
  double undefined_fraction = 0;     ///< share of the domain's cells that were left out
  bool exceeds_doubles = false;      ///< because numbers there are too large, not undefined
  std::size_t flat_triangles = 0;    ///< without area in double precision: left out
  bool stopped_early = false;        ///< MeshRequest::stop: there is no mesh
  std::optional<double> tolerance;   ///< what max_error was to stay within
  double least_triangles = 0;        ///< that any mesh within it needs, about; 0: unknown
  bool reached_limit = false;        ///< more triangles were not allowed
  bool budget_spent = false;         ///< they were, but no more effort
  std::size_t effort = 0;            ///< that was made: Effort::total()
  bool certified = false;            ///< proved that nothing hides between samples
  std::vector<ProofGap> proof_gaps;  ///< else where that is not proved, at most 1000
  double max_error = 0;              ///< largest measured distance of mesh and surface
  double max_normal_error = 0;       ///< degrees: interpolated against exact normal, in
                                     ///< cells larger than the tolerance
  /// A place at which normals are off by more than allowed: no more triangles were worth it.
  std::optional<dvec2> coarse_normals;
  /// Where max_error is, if it exceeds the tolerance; a place from which on the surface oscillates
  /// faster than any picture shows, and the mesh does not follow it.
  std::optional<dvec2> worst_place, oscillates;
  std::vector<SingularPoint> singular_points;  ///< one per singular (u, v), at most 1000
  std::size_t singular_point_count = 0;
  /// Lines of constant u and of constant v that are known to be singular from end to end.
  std::vector<double> singular_u, singular_v;
  std::vector<dvec2> poles;  ///< where the surface goes to infinity and was cut, at most 1000
  std::size_t pole_count = 0;
  /// A box around the last points before them, as far as doubles go, and around what was so far
  /// away that the mesh was not made: MeshRequest::stop.
  Bounds beside_poles;
  std::vector<dvec2> jumps;  ///< the same where it jumps
  std::size_t jump_count = 0;
  /// The first of the jumps: single points that the surface comes to at a different place on each
  /// way; at most 1000.
  std::vector<dvec2> without_limit;
  bool is_clipped = false;     ///< along a box, asked for or not
  std::optional<Bounds> clip;  ///< the box that the mesh was cut along because of poles
  std::string closed_u;        ///< how the edges u0 and u1 meet: Seam::name()
  std::string closed_v;
  Shift shift_u, shift_v;             ///< by which edges that join are shifted
  std::array<bool, 2> folded_u = {};  ///< whether u0 and u1 are folded; see Seams
  std::array<bool, 2> folded_v = {};
  bool orientable = true;  ///< false: the surface is one-sided
};

struct MeshResult {
  Mesh mesh;
  MeshReport report;
};

/// Counts a singular point and lists it, if the list is not full.
void add_singular_point(const dvec2& uv, MeshReport& report);
/// The normal has no limit at the point that was added last.
void mark_without_limit(MeshReport& report);

}  // namespace saddle
