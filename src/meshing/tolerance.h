// How far the mesh may be from the surface: what --tolerance or the outputs ask for, as a length.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/run_limits.h"
#include "mesh/mesher/mesh_request.h"
#include "mesh/model/tolerance.h"
#include "mesh/sizing/probe.h"
#include "scene/model/camera.h"
#include "scene/model/instances.h"
#include "scene/model/scene.h"
#include "surface/surface.h"

namespace saddle {

/// Where the camera and the nodes of a resolved scene are in its picture.
struct Moment {
  Camera camera;
  NodeFrames nodes;

  explicit Moment(const Scene& scene) : camera(drawn_camera(scene)), nodes(scene) {}
  /// Nothing that a picture shows is elsewhere, or of another size.
  bool operator==(const Moment&) const = default;
};

/// The outputs of a run that its tolerance depends on.
struct Purpose {
  bool picture = false;
  bool mesh = false;
  /// Distance of mesh and surface where a picture is drawn and no tolerance is asked for: no eye
  /// sees it at the picture's size.
  double pixels = 0.5;
  std::vector<Moment> moments{};  ///< that the mesh is drawn at; none: the scene's own
  /// The surface is meshed with its axes stretched by these powers of two: see mesh_stretch().
  dvec3 stretch{1, 1, 1};
};

/// The tolerance of a surface of the scene that a probe has sampled, or of its part in a box: the
/// stricter one of picture and mesh. A picture's pixels are those of the part of the surface, in
/// any of its nodes, that is nearest to the eye at any of its moments. All lengths and boxes are
/// those of the stretched surface.
Tolerance tolerance_of(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                       const Probe& probe, const std::optional<Bounds>& clip = {});

/// The same for what has a box and samples, and nothing else.
Tolerance tolerance_of(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                       const Bounds& bounds, std::vector<dvec3> positions);

/// The lines of a surface's grid in a picture that has no more of them than can be told apart.
/// `tolerance`: that of the surface for the same purpose.
LineCounts lines_in_picture(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                            const Probe& probe, const Tolerance& tolerance);

/// The tolerance for a mesh that knows only its box, as a share of the box's diagonal, which the
/// picture's larger side shows about.
double tolerance_share(const Scene& scene, const Purpose& purpose);

/// Triangles at most: the value of --max-triangles; 4000000 with --tolerance or --samples; else
/// about one per pixel of the picture, from 1000000 to 4000000, more than can be told apart in it.
/// Fewer where many surfaces share what a scene may have, or where --max-memory is little.
std::size_t most_triangles(const Scene& scene, const SurfaceSpec& spec);

/// Whether each surface has a share of the triangles and of the work of all.
bool shares_limits(const Scene& scene);

/// The bounds of the mesh of one surface.
struct MeshAllowance {
  std::size_t triangles;  ///< no more than the points are worth
  std::size_t points;     ///< that are computed, with all checks: fewer if the formula is long
};
MeshAllowance mesh_allowance(const Scene& scene, const SurfaceSpec& spec, const Surface& surface);

/// The limit of a run that makes most_triangles() fewer, if one does.
Shortage shortage_of_triangles(const Scene& scene, const SurfaceSpec& spec);

/// The effort that each surface may take however few its triangles are, in places
/// (mesh/sizing/effort.h): a share of what all surfaces may take.
std::size_t least_effort(const Scene& scene);

}  // namespace saddle
