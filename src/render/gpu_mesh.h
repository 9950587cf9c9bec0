// A mesh in GL buffers: the one place where doubles become floats.
#pragma once

#include "mesh/mesh.h"
#include "render/gl.h"

namespace saddle {

/// Model coordinates are (world - centre) / size, computed in double: floats near 1 keep their 24
/// bits for the surface's shape, wherever it is and however large.
struct ModelFrame {
  dvec3 centre{0, 0, 0};
  double size = 1;
};

/// The frame in which `bounds` lies within distance 1 of the origin.
ModelFrame model_frame(const Bounds& bounds);

/// Positions, normals, triangles and lines of one mesh. Needs a current context.
class GpuMesh {
 public:
  explicit GpuMesh(const Mesh& mesh);

  const Bounds& bounds() const { return bounds_; }
  const ModelFrame& frame() const { return frame_; }
  bool hides_its_back() const { return hides_its_back_; }
  bool has_lines() const { return line_indices_ > 0; }
  void draw_triangles() const;
  void draw_lines() const;

 private:
  Bounds bounds_;
  ModelFrame frame_;  ///< of the bounds
  bool hides_its_back_;
  GlVertexArray triangle_array_;
  GlVertexArray line_array_;
  GlBuffer vertices_;
  GlBuffer triangles_;
  GlBuffer lines_;
  GLsizei triangle_indices_ = 0;
  GLsizei line_indices_ = 0;
};

}  // namespace saddle
