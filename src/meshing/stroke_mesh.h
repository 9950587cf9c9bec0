// Curves and points of a scene as meshes: lines and tubes, dots.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/curve/curve_mesher.h"
#include "mesh/model/mesh.h"
#include "meshing/findings.h"
#include "meshing/tolerance.h"
#include "scene/model/scene.h"
#include "surface/surface.h"

namespace saddle {

/// A curve's mesh, with what was found on the way.
struct MeshedCurve {
  Mesh mesh;        ///< a tube's triangles, or lines alone
  CurveMesh curve;  ///< without its chains
  std::vector<Finding> findings;
  bool moves = false;
  double parse_ms = 0;
  double tessellate_ms = 0;
};

/// Meshes the curve that `spec` stands for, as --tolerance or the outputs ask for. A curve that
/// goes to infinity is clipped to the box that most of it is in, unless the scene says otherwise.
/// Throws Error: as bind_curve() does; Nothing if it is nowhere defined.
MeshedCurve mesh_stroke_curve(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose);

/// The place of the point that `spec` stands for. Throws Error: as bind_surface() does; Nothing if
/// it is undefined.
dvec3 place_of_point(const Scene& scene, const SurfaceSpec& spec);

/// The place of a surface's label: the corner that is nearest to the middle of the ranges. Nothing
/// without a label.
std::optional<dvec3> middle_of(const Surface& surface, const Mesh& mesh, const std::string& label);

/// A mesh of one corner, without triangles.
Mesh dot_mesh(const dvec3& place);

}  // namespace saddle
