// How far the mesh may be from the surface: what --tolerance or the outputs ask for, as a length.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mesh/adaptive_mesh.h"
#include "scene/instances.h"
#include "scene/scene.h"

namespace saddle {

/// Where the camera and the nodes of a resolved scene are.
struct Moment {
  Camera camera;
  NodeFrames nodes;

  explicit Moment(const Scene& scene) : camera(scene.camera), nodes(scene) {}
  /// Nothing that a picture shows is elsewhere, or of another size.
  bool operator==(const Moment&) const = default;
};

/// What a run draws and writes, as far as its tolerance depends on it.
struct Purpose {
  bool picture = false;
  bool mesh = false;
  std::vector<Moment> moments{};  ///< that the mesh is drawn at; none: the scene's own
};

/// The tolerance of a surface of the scene that is known by a probe, or of what of it is in a box:
/// the stricter one of picture and mesh. A picture's pixels are those of the part of the surface,
/// in any of its nodes, that is nearest to the eye at any of its moments.
Tolerance tolerance_of(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                       const Probe& probe, const std::optional<Bounds>& clip = {});

/// Where a clip box is open: the coordinate of a face that it does not have, or minus that.
inline constexpr double kNoFace = std::numeric_limits<double>::infinity();

/// The box that a surface which goes to infinity is clipped to, if `points` (finite) are spread
/// over it and `all` is around them: in each coordinate `all`, or what most of the points keep to,
/// if some go far beyond, and less of that if it is much longer than the box's other sides.
Bounds clip_box(const Bounds& all, std::span<const dvec3> points);

/// Beside a side that is so many times as long, the others are narrower than a pixel.
inline constexpr double kNeedle = 1000;

/// The box that shows what can be seen of a surface that outgrows its picture: one of whose sides
/// is so long that the others are no wider than a pixel, while a part of the points (finite) is in
/// proportion. Its faces are infinitely far where no point is beyond. Nothing for other surfaces.
/// Where it is only the edges of the domain that go so far, as that of tan(u) at u = pi / 2, which
/// is no pole in double precision, it is clip_box() without the faces that are not needed.
std::optional<Bounds> readable_box(const Bounds& all, std::span<const dvec3> points);

/// The tolerance for a mesh that knows only its box, as a share of the box's diagonal, which the
/// picture's larger side shows about.
double tolerance_share(const Scene& scene, const Purpose& purpose);

}  // namespace saddle
