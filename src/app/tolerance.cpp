#include "app/tolerance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/camera.h"

namespace saddle {
namespace {

/// Distance of mesh and surface that no eye sees in a picture, in pixels, and what a mesh for other
/// programs may be off by, as a share of its bounding box's diagonal.
constexpr ToleranceValue kPictureTolerance = {0.5, true};
constexpr ToleranceValue kMeshTolerance = {1e-3, false};
/// An eye in the midst of the surface sees parts of it at any distance; nearer ones than this part
/// of its extent are drawn more coarsely than asked.
constexpr double kNearest = 0.05;

std::vector<ToleranceValue> asked(const CommandLine& line, const Purpose& purpose) {
  if (line.tolerance) return {*line.tolerance};
  std::vector<ToleranceValue> tolerances;
  if (purpose.picture) tolerances.push_back(kPictureTolerance);
  if (purpose.mesh) tolerances.push_back(kMeshTolerance);
  return tolerances;
}

/// The side of a pixel on the nearest part of the surface, in units of length.
double pixel_size(const CommandLine& line, const Camera& camera, const Probe& probe) {
  const dvec3 target = camera_target(camera, probe.bounds());
  const double radius = probe.radius(target);
  const double aspect = static_cast<double>(line.width) / line.height;
  const double distance = fit_camera(camera, probe.bounds(), aspect, radius).distance;
  const double depth = camera.ortho ? distance : std::max(distance - radius, kNearest * radius);
  const double half_fov = camera.fov / 2 * std::numbers::pi / 180;
  return 2 * depth * std::tan(half_fov) / line.height;
}

}  // namespace

Tolerance tolerance_of(const CommandLine& line, const Scene& scene, const Purpose& purpose,
                       const Probe& probe) {
  double least = std::numeric_limits<double>::infinity();
  if (!probe.bounds().empty()) {
    for (const auto& [value, pixels] : asked(line, purpose)) {
      const double unit =
          pixels ? pixel_size(line, scene.camera, probe) : probe.bounds().diagonal();
      least = std::min(least, value * unit);
    }
  }
  return [least](const dvec3&) { return least; };
}

double tolerance_share(const CommandLine& line, const Purpose& purpose) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [value, pixels] : asked(line, purpose)) {
    least = std::min(least, pixels ? value / std::max(line.width, line.height) : value);
  }
  return least;
}

}  // namespace saddle
