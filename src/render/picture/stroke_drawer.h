// The lines and dots of curves and points, and the places of labels.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"
#include "render/gl/gpu_mesh.h"
#include "render/gl/gpu_strokes.h"
#include "render/gl/program.h"
#include "render/gl/viewport.h"
#include "render/overlay/annotations.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

/// Needs the same current context from the first to the last of its calls.
class StrokeDrawer {
 public:
  /// Takes the lines and the label's place of the mesh of scene.surfaces[surface].
  void set_mesh(std::size_t surface, const Mesh& mesh);
  void keep_meshes(std::size_t count);
  bool has_strokes() const;

  /// Where a picture is drawn to.
  struct Screen {
    const FittedCamera& camera;
    const Viewport& viewport;
    double unit;  ///< the length that shaders measure in
  };

  /// Draws all lines and dots of a resolved scene where its nodes have them.
  /// `program`: LineDrawer::stroke_program().
  void draw(const Scene& scene, std::span<const GpuMesh> meshes, const Screen& screen,
            Program& program);

  /// The labels in a picture of this size.
  std::vector<SpaceLabel> labels(const Scene& scene, const FittedCamera& camera,
                                 const dvec2& size) const;

 private:
  std::vector<std::optional<GpuStrokes>> strokes_;  // of meshes without triangles
  std::vector<std::optional<dvec3>> anchors_;       // of each mesh
};

}  // namespace saddle
