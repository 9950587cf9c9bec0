// Where the surfaces of a scene are: once in the world, or once for each node that they are in.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "mesh/model/mesh.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

/// The world as a picture shows it, stretched by the scene's scale, or in the scene's own units.
enum class World { Drawn, True };

/// The transforms of a resolved scene's nodes.
class NodeFrames {
 public:
  explicit NodeFrames(const Scene& scene, World world = World::Drawn);

  /// From the node's coordinates to the world's.
  const glm::dmat4& to_world(const std::string& node) const { return frames_.at(node); }
  /// From the scene's own units to the world's.
  const glm::dmat4& root() const { return root_; }

  bool operator==(const NodeFrames&) const = default;

 private:
  glm::dmat4 root_{1};
  std::map<std::string, glm::dmat4> frames_;
};

/// A surface where it is drawn.
struct Instance {
  std::size_t surface = 0;  ///< index into Scene::surfaces
  glm::dmat4 to_world{1};   ///< affine
};

/// From the surface's coordinates to the world's, for each time that it is drawn.
std::vector<glm::dmat4> places(const NodeFrames& frames, const SurfaceSpec& spec);
std::vector<glm::dmat4> places(const Scene& scene, const SurfaceSpec& spec);

/// All instances of a resolved scene that are visible, in the order of its surfaces.
std::vector<Instance> instances(const Scene& scene, World world = World::Drawn);

/// The box around a transformed box; empty for an empty one.
Bounds transformed(const Bounds& bounds, const glm::dmat4& to_world);

/// A mesh where an instance is: positions, normals, and the winding that keeps the front in front.
Mesh transformed(const Mesh& mesh, const glm::dmat4& to_world);

/// Adds points where an instance has them. `bounds`: around the points; nothing is added if the
/// pyramid holds it.
void add_points(std::span<const dvec3> points, const Bounds& bounds, const glm::dmat4& to_world,
                ViewPyramid& seen);

/// The transform of normals up to a positive factor: the inverse transpose, by its cofactors, which
/// a flattening transform has too. Largest element 1; zero if the transform leaves no surface.
glm::dmat3 normal_matrix(const glm::dmat3& m);

/// The largest factor by which the transform stretches an axis.
double largest_stretch(const glm::dmat4& to_world);

}  // namespace saddle
