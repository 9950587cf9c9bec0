// The numbers of a surface of a scene on its mesh: its colours and its level lines.
#pragma once

#include <span>
#include <vector>

#include "mesh/color/color_mesh.h"
#include "mesh/color/contours.h"
#include "mesh/model/mesh_report.h"
#include "meshing/findings.h"
#include "meshing/tolerance.h"
#include "scene/model/prepare.h"
#include "scene/model/scene.h"

namespace saddle {

/// Round levels that are chosen, about.
inline constexpr int kRoundLevels = 10;

/// Gives the mesh of a surface with a colour its numbers.
ColorReport color_as_asked(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                           const Surface& surface, MeshResult& mesh, unsigned threads);

/// Gives the mesh the level lines that the surface has. Returns a report for each expression.
std::vector<ContourReport> contour_as_asked(const Scene& scene, const SurfaceSpec& spec,
                                            const Purpose& purpose, const PreparedSurface& prepared,
                                            MeshResult& mesh, unsigned threads);

/// The findings about its colour.
std::vector<Finding> color_findings(const Mesh& mesh, const ColorReport& report);

/// The findings about its level lines; reports[i] is that of spec.contours[i].
std::vector<Finding> contour_findings(const SurfaceSpec& spec,
                                      std::span<const ContourReport> reports);

/// Levels of an expression whose numbers have a range: those that are given, or round ones inside
/// of it, none on its ends.
std::vector<double> levels_in(const ContourSpec& contour, const ColorRange& range);

}  // namespace saddle
