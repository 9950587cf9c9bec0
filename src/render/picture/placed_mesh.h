// A mesh in one of the places where it is drawn.
#pragma once

#include <cstddef>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "render/gl/gpu_mesh.h"
#include "scene/model/camera.h"
#include "scene/model/instances.h"

namespace saddle {

/// A mesh that is drawn once, with the way from its coordinates to the screen.
struct PlacedMesh {
  std::size_t surface = 0;
  glm::dmat4 model_to_eye;  // in units of the scene
  glm::dmat4 model_to_clip;
  glm::dmat3 normal_to_eye;
  bool is_similar = true;  // angles stay: normals go as directions do
  bool mirrored = false;
  bool two_sided = true;  // back faces can be seen
  double opacity = 1;

  /// Everything relative to the camera's target, all in double. `unit`: the lengths that shaders
  /// measure in.
  PlacedMesh(const Instance& instance, const GpuMesh& mesh, const FittedCamera& camera,
             double unit);

  /// Its transform leaves something to see.
  bool is_visible() const { return normal_to_eye != glm::dmat3(0); }
};

}  // namespace saddle
