#include "render/picture/placed_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/matrix.hpp>

namespace saddle {
namespace {

/// Columns of a matrix may differ from a similarity's by this share of their length: float normals
/// do not show it.
constexpr double kSimilar = 1e-6;

/// A rotation times a positive factor, for which normals need no matrix of their own.
bool is_similarity(const glm::dmat3& m) {
  const double length = glm::length(m[0]);
  const double slack = kSimilar * length * length;
  return glm::determinant(m) > 0 && std::abs(glm::dot(m[0], m[1])) <= slack &&
         std::abs(glm::dot(m[1], m[2])) <= slack && std::abs(glm::dot(m[2], m[0])) <= slack &&
         std::abs(glm::length(m[1]) - length) <= kSimilar * length &&
         std::abs(glm::length(m[2]) - length) <= kSimilar * length;
}

/// The least depth of the box's corners along the view. Parts before the near plane are not seen.
double nearest_depth(const Bounds& box, const FittedCamera& camera) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const dvec3& p : box.corners()) {
    const double z = (glm::dmat3(camera.world_to_eye) * (p - camera.target)).z;
    nearest = std::min(nearest, camera.distance - z);
  }
  return nearest;
}

}  // namespace

PlacedMesh::PlacedMesh(const Instance& instance, const GpuMesh& mesh, const FittedCamera& camera,
                       double unit)
    : surface(instance.surface), model_to_clip(camera.eye_to_clip) {
  const glm::dmat3 rotation(camera.world_to_eye);
  const glm::dmat3 turned = rotation * glm::dmat3(instance.to_world);
  const dvec3 centre(instance.to_world * glm::dvec4(mesh.frame().centre, 1));
  const dvec3 seen = rotation * (centre - camera.target) - dvec3(0, 0, camera.distance);
  glm::dmat3 from_model = turned;
  for (int column = 0; column < 3; ++column)
    from_model[column] *= mesh.frame().sides[column] / unit;
  model_to_eye = glm::dmat4(from_model);
  model_to_eye[3] = {seen / unit, 1};
  for (int column = 0; column < 3; ++column) model_to_clip[column] *= unit;
  // A factor of clip coordinates means nothing; w in units of the scene keeps to a float's range.
  if (model_to_clip[2][3] != 0) model_to_clip /= unit;
  model_to_clip = model_to_clip * model_to_eye;
  is_similar = is_similarity(from_model);
  normal_to_eye = normal_matrix(from_model);
  mirrored = glm::determinant(turned) < 0;
  const Bounds box = transformed(mesh.bounds(), instance.to_world);
  two_sided = !mesh.hides_its_back() || nearest_depth(box, camera) <= camera.near_plane;
}

}  // namespace saddle
