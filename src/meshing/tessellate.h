// One surface of a scene as triangles, as the command line asks for them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/color/color_mesh.h"
#include "mesh/color/contours.h"
#include "mesh/curve/curve_mesher.h"
#include "mesh/model/mesh_report.h"
#include "meshing/findings.h"
#include "meshing/thickness.h"
#include "meshing/tolerance.h"
#include "scene/model/prepare.h"
#include "scene/model/scene.h"

namespace saddle {

/// A surface of a scene and its mesh, both in the surface's own parameters.
struct MeshedSurface {
  PreparedSurface prepared;
  MeshResult mesh;
  std::optional<ColorReport> color;     ///< of a coloured surface
  std::vector<ContourReport> contours;  ///< of each of its level lines' expressions
  std::optional<SharpestBends> bends;   ///< of a surface with a thickness
  bool is_clipped = false;              ///< a box may hide part of the surface
  bool shares_limits = false;           ///< its limits are a share of those of all surfaces
  double tessellate_ms = 0;
};

/// A mesh and what there is to say about it, in the user's parameters.
struct Tessellation {
  Mesh mesh;
  MeshReport report;
  Domain domain;  ///< where v depends on u: the box around the mesh's parameters
  std::vector<Finding> findings;
  std::vector<std::string> warnings;   ///< sentences of findings
  std::optional<SharpestBends> bends;  ///< of a surface with a thickness
  std::optional<SolidReport> solid;    ///< once its mesh is one: thicken_scene()
  std::optional<CurveMesh> curve;      ///< of a curve, without its chains
  std::optional<dvec3> place;          ///< of a point
  bool moves = false;                  ///< at another time it is another mesh
  double parse_ms = 0;                 ///< text to graph
  double compile_ms = 0;               ///< derivatives and tapes
  double tessellate_ms = 0;
};

/// Prepares and tessellates surface `spec` of `scene`: on the grid of --samples, or with the fewest
/// triangles that keep the tolerance of `purpose`. Throws Error as prepare_surface() and
/// mesh_on_grid() do.
MeshedSurface mesh_surface(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                           unsigned threads);

/// The mesh of `spec` and what was found about it, for the user.
Tessellation tessellation_of(const SurfaceSpec& spec, MeshedSurface meshed);

/// Both in one call; also of a surface that stands for a curve or a point.
Tessellation tessellate(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                        unsigned threads);

}  // namespace saddle
