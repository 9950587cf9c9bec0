// Lines of any width with round ends and joints, and dots, in a GL buffer.
#pragma once

#include "mesh/model/mesh.h"
#include "render/gl/gl.h"
#include "render/gl/gpu_mesh.h"

namespace saddle {

/// Needs a current context.
class GpuStrokes {
 public:
  /// The mesh's lines; one of a single corner is a dot.
  explicit GpuStrokes(const Mesh& mesh);

  /// With the program of stroke.vert.glsl, in the model coordinates of GpuMesh.
  void draw() const;

 private:
  GlVertexArray array_;
  GlBuffer pieces_;
  GLsizei count_ = 0;
};

}  // namespace saddle
