// Affine transforms in double. Angles in degrees, rotations by Rodrigues' formula.
// Source of normals: K. Turkowski, "Properties of surface-normal transformations", 1990.
#include "scene/model/instances.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace saddle {
namespace {

glm::dmat4 matrix_of(const Transform& step) {
  const glm::dmat4 identity(1);
  switch (step.kind) {
    case Transform::Kind::Translate:
      return glm::translate(identity, dvec3(step.vector));
    case Transform::Kind::Rotate:
      return glm::rotate(identity, glm::radians(step.angle.value), dvec3(step.vector));
    case Transform::Kind::Scale:
      return glm::scale(identity, dvec3(step.vector));
  }
  return identity;
}

glm::dmat4 matrix_of(const SceneNode& node) {
  glm::dmat4 matrix(1);
  for (const Transform& step : node.transform) matrix = matrix * matrix_of(step);
  return matrix;
}

}  // namespace

NodeFrames::NodeFrames(const Scene& scene, World world) {
  if (world == World::Drawn) root_ = glm::scale(root_, dvec3(scene.scale.factors));
  std::map<std::string, const SceneNode*> nodes;
  for (const SceneNode& node : scene.nodes) nodes[node.name] = &node;
  for (const SceneNode& node : scene.nodes) {
    glm::dmat4 matrix = matrix_of(node);
    for (const SceneNode* outer = &node; !outer->in.empty();) {
      outer = nodes.at(outer->in);
      matrix = matrix_of(*outer) * matrix;
    }
    frames_[node.name] = root_ * matrix;
  }
}

std::vector<glm::dmat4> places(const NodeFrames& frames, const SurfaceSpec& spec) {
  if (spec.in.empty()) return {frames.root()};
  std::vector<glm::dmat4> result;
  for (const std::string& node : spec.in) result.push_back(frames.to_world(node));
  return result;
}

std::vector<glm::dmat4> places(const Scene& scene, const SurfaceSpec& spec) {
  return places(NodeFrames(scene), spec);
}

std::vector<Instance> instances(const Scene& scene, World world) {
  const NodeFrames frames(scene, world);
  std::vector<Instance> result;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    if (!scene.surfaces[i].visible) continue;
    for (const glm::dmat4& place : places(frames, scene.surfaces[i])) result.push_back({i, place});
  }
  return result;
}

Bounds transformed(const Bounds& bounds, const glm::dmat4& to_world) {
  Bounds result;
  if (bounds.empty()) return result;
  for (const dvec3& p : bounds.corners()) result.add(dvec3(to_world * glm::dvec4(p, 1)));
  return result;
}

Mesh transformed(const Mesh& mesh, const glm::dmat4& to_world) {
  if (to_world == glm::dmat4(1)) return mesh;
  Mesh result = mesh;
  const glm::dmat3 normals = normal_matrix(glm::dmat3(to_world));
  result.bounds = {};
  for (dvec3& p : result.position) {
    p = dvec3(to_world * glm::dvec4(p, 1));
    result.bounds.add(p);
  }
  const auto turn = [&normals](dvec3& n) {
    n = normals * n;
    const double length = glm::length(n);
    if (length > 0) n /= length;
  };
  for (dvec3& n : result.normal) turn(n);
  for (dvec3& n : result.contours.normal) turn(n);
  for (auto* const places : {&result.contours.position, &result.contours.on_mesh}) {
    for (dvec3& p : *places) p = dvec3(to_world * glm::dvec4(p, 1));
  }
  if (glm::determinant(glm::dmat3(to_world)) < 0) {
    for (Triangle& t : result.triangles) std::swap(t[1], t[2]);
  }
  return result;
}

void add_points(std::span<const dvec3> points, const Bounds& bounds, const glm::dmat4& to_world,
                ViewPyramid& seen) {
  const auto placed = [&](const dvec3& p) { return dvec3(to_world * glm::dvec4(p, 1)); };
  if (bounds.empty()) return;
  const auto corners = bounds.corners();
  if (std::ranges::all_of(corners, [&](const dvec3& p) { return seen.holds(placed(p)); })) return;
  for (const dvec3& point : points) seen.add(placed(point));
}

glm::dmat3 normal_matrix(const glm::dmat3& m) {
  glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  if (glm::determinant(m) < 0) cofactors = -cofactors;
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(cofactors[i][k]));
  }
  return largest > 0 ? cofactors / largest : glm::dmat3(0);
}

double largest_stretch(const glm::dmat4& to_world) {
  const glm::dmat3 m(to_world);
  const glm::dmat3 rows = glm::transpose(m);
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    largest = std::max({largest, glm::length(m[i]), glm::length(rows[i])});
  }
  return largest;
}

}  // namespace saddle
