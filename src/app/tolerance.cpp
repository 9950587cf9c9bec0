#include "app/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>

#include "scene/camera.h"
#include "scene/instances.h"

namespace saddle {
namespace {

/// Distance of mesh and surface that no eye sees in a picture, in pixels, and what a mesh for other
/// programs may be off by, as a share of its bounding box's diagonal.
constexpr ToleranceValue kPictureTolerance = {0.5, true};
constexpr ToleranceValue kMeshTolerance = {1e-3, false};
/// An eye in the midst of the surface sees parts of it at any distance; nearer ones than this part
/// of its extent are drawn more coarsely than asked.
constexpr double kNearest = 0.05;
/// Samples that go so many times as far as nine tenths of them do are on their way to infinity.
constexpr double kFarOut = 3;
/// A surface may go beyond its samples by this part of their extent without being clipped.
constexpr double kBeyondProbe = 0.1;

std::vector<ToleranceValue> asked(const Scene& scene, const Purpose& purpose) {
  if (scene.mesh.tolerance) return {*scene.mesh.tolerance};
  std::vector<ToleranceValue> tolerances;
  if (purpose.picture) tolerances.push_back(kPictureTolerance);
  if (purpose.mesh) tolerances.push_back(kMeshTolerance);
  return tolerances;
}

/// What of the surface is in the box.
Bounds visible(const Probe& probe, const std::optional<Bounds>& clip) {
  Bounds bounds = probe.bounds();
  if (!clip) return bounds;
  bounds.low = glm::max(bounds.low, clip->low);
  bounds.high = glm::min(bounds.high, clip->high);
  return bounds;
}

/// The side of a pixel on the nearest part of the surface at this place, in the surface's own units
/// of length.
double pixel_size(const Scene& scene, const glm::dmat4& place, const Probe& probe,
                  const std::optional<Bounds>& clip) {
  const Camera& camera = scene.camera;
  const double stretch = largest_stretch(place);
  const bool in_world = place == glm::dmat4(1);
  const Bounds bounds = transformed(visible(probe, clip), place);
  const dvec3 target = camera_target(camera, bounds);
  const double to_corner =
      glm::length(glm::max(glm::abs(bounds.low - target), glm::abs(bounds.high - target)));
  const double radius = in_world ? std::min(probe.radius(target), to_corner) : to_corner;
  const double aspect = static_cast<double>(scene.picture.width) / scene.picture.height;
  const double distance = fit_camera(camera, bounds, aspect, radius).distance;
  const double depth = camera.ortho ? distance : std::max(distance - radius, kNearest * radius);
  const double half_fov = camera.fov / 2 * std::numbers::pi / 180;
  return 2 * depth * std::tan(half_fov) / scene.picture.height / stretch;
}

/// The least of all places'.
double pixel_size(const Scene& scene, const SurfaceSpec& spec, const Probe& probe,
                  const std::optional<Bounds>& clip) {
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dmat4& place : places(scene, spec)) {
    if (largest_stretch(place) == 0) continue;  // drawn as nothing
    least = std::min(least, pixel_size(scene, place, probe, clip));
  }
  return std::isfinite(least) ? least : visible(probe, clip).diagonal();
}

}  // namespace

Tolerance tolerance_of(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                       const Probe& probe, const std::optional<Bounds>& clip) {
  double least = std::numeric_limits<double>::infinity();
  if (!probe.bounds().empty()) {
    for (const auto& [value, pixels] : asked(scene, purpose)) {
      const double unit =
          pixels ? pixel_size(scene, spec, probe, clip) : visible(probe, clip).diagonal();
      least = std::min(least, value * unit);
    }
  }
  return [least](const dvec3&) { return least; };
}

Bounds clip_box(const Probe& probe) {
  Bounds box;
  const Bounds robust = probe.robust_bounds();
  const dvec3 size = probe.bounds().size();
  for (int k = 0; k < 3; ++k) {
    const bool is_far_out = size[k] > kFarOut * robust.size()[k];
    const Bounds& most = is_far_out ? robust : probe.bounds();
    const double margin = is_far_out ? 0 : kBeyondProbe * size[k];
    box.low[k] = most.low[k] - margin;
    box.high[k] = most.high[k] + margin;
  }
  return box;
}

double tolerance_share(const Scene& scene, const Purpose& purpose) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [value, pixels] : asked(scene, purpose)) {
    least = std::min(least,
                     pixels ? value / std::max(scene.picture.width, scene.picture.height) : value);
  }
  return least;
}

}  // namespace saddle
