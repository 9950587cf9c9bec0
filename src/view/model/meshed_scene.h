// Questions about a scene and its meshes, as they are shown: how large it is, which camera holds
// it, what is under a pixel.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "scene/model/camera.h"
#include "scene/model/instances.h"
#include "view/model/mesh_worker.h"
#include "view/model/pick.h"

namespace saddle {

/// A box around all that is drawn of the meshes.
Bounds bounds_of(const Meshed& meshed);

/// A pyramid for a picture of `size` pixels that leaves room for what is written beside these
/// surfaces of the scene. The meshes are added by add_meshes().
ViewPyramid pyramid_beside_annotations(const Scene& scene,
                                       std::span<const std::shared_ptr<const SightedMesh>> surfaces,
                                       const Bounds& bounds, const dvec2& size);
void add_meshes(const Meshed& meshed, ViewPyramid& seen);

/// The camera as render() would fit it to these meshes.
FittedCamera fit_to(const Meshed& meshed, const PictureSettings& picture);

/// The first surface on a line of sight, where a node has put it.
struct SightedPoint {
  Instance instance;
  Ray ray;  ///< in the surface's own coordinates; distances along it are the world's
  Hit hit;
};
std::optional<SightedPoint> look_along(const Meshed& meshed, const Ray& ray);

/// A point that was picked, and the surface it is on.
struct PickedPoint {
  std::string surface;
  std::size_t index = 0;                    ///< of the surface
  std::size_t copy = 0;                     ///< which of the nodes that the surface is in
  SurfacePlace place;                       ///< in the surface's own coordinates
  dvec3 world;                              ///< where its node has put it
  ParameterNames names = kUsualParameters;  ///< of u and v
};

/// The point of the first surface on a line of sight.
std::optional<PickedPoint> pick(const Meshed& meshed, const Ray& ray);

/// The point with the same u and v, of the same surface and node, in another scene. Throws Error
/// (Input) with the reason where there is none.
PickedPoint pick_again(const Meshed& meshed, const PickedPoint& picked);

/// The point in a line: u, v, x, y, z, the normal and the curvatures.
std::string describe(const PickedPoint& picked);

}  // namespace saddle
