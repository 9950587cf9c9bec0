#include "meshing/stretch.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace saddle {
namespace {

/// Exponents of a stretch: positions keep to a double's range.
constexpr double kMostHalvings = 256;

}  // namespace

dvec3 mesh_stretch(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose) {
  const bool has_pixels = purpose.picture || (scene.mesh.tolerance && scene.mesh.tolerance->pixels);
  if (!has_pixels || !spec.in.empty()) return dvec3(1);
  const dvec3 factors = scene.scale.factors;
  const dvec3 halvings = glm::round(glm::log2(factors) - std::log2(largest_of(factors)));
  return glm::exp2(glm::max(halvings, -kMostHalvings));
}

double rest_of_stretch(const Scene& scene, const Purpose& purpose) {
  const dvec3 rest = dvec3(scene.scale.factors) / purpose.stretch;
  return purpose.stretch == dvec3(1) ? 1 : largest_of(rest) / least_of(rest);
}

Bounds stretched(const Bounds& box, const dvec3& stretch) {
  return {box.low * stretch, box.high * stretch};
}

std::optional<Bounds> stretched_clip_box(const Scene& scene, const Purpose& purpose) {
  if (!scene.clip.box) return std::nullopt;
  return stretched(*scene.clip.box, purpose.stretch);
}

void take_back_stretch(const dvec3& stretch, MeshResult& result) {
  const dvec3 back = 1.0 / stretch;
  Mesh& mesh = result.mesh;
  for (dvec3& p : mesh.position) p *= back;
  for (dvec3& n : mesh.normal) {
    const dvec3 normal = stretch * n;
    const double length = glm::length(normal);
    if (length > 0) n = normal / length;
  }
  mesh.bounds = stretched(mesh.bounds, back);
  MeshReport& report = result.report;
  const double most = largest_of(back);
  report.max_error *= most;
  if (report.tolerance) *report.tolerance *= most;
  if (report.rounding) *report.rounding *= most;
  report.beside_poles = stretched(report.beside_poles, back);
  if (report.clip) report.clip = stretched(*report.clip, back);
}

}  // namespace saddle
