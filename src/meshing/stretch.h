// A picture that is stretched along an axis needs another mesh: distances and angles between
// normals are other ones there. The surface is meshed with its axes stretched about as much. The
// factors are powers of two, so that positions are the same to the last bit when the stretch is
// taken back.
#pragma once

#include <optional>

#include "mesh/model/mesh_report.h"
#include "meshing/tolerance.h"
#include "scene/model/scene.h"

namespace saddle {

/// The powers of two next to the factors of a resolved scene's scale, the largest of which becomes
/// 1. All are 1 for meshes alone and for surfaces in nodes, which may turn the axes: there
/// the tolerance allows for the largest factor.
dvec3 mesh_stretch(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose);

/// The largest factor by which the picture stretches one direction of the stretched surface more
/// than another: angles between normals grow by no more.
double rest_of_stretch(const Scene& scene, const Purpose& purpose);

/// The box of a stretched surface.
Bounds stretched(const Bounds& box, const dvec3& stretch);
/// The clip box of a scene, if it has one, for the stretched surface.
std::optional<Bounds> stretched_clip_box(const Scene& scene, const Purpose& purpose);

/// The mesh of the surface itself from that of the stretched one. Errors become upper bounds: a
/// distance grows by at most one over the least factor.
void take_back_stretch(const dvec3& stretch, MeshResult& mesh);

}  // namespace saddle
