// Lines of any width with round ends and joints, and dots, in a GL buffer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"
#include "render/gl/gl.h"

namespace saddle {

/// Needs a current context.
class GpuStrokes {
 public:
  using Lines = std::vector<std::vector<std::uint32_t>>;

  /// Lines through `positions`, in the model coordinates of a GpuMesh of these bounds; one of a
  /// single position is a dot. A position is drawn at the depth of `behind`, if that is nearer.
  GpuStrokes(const Lines& lines, std::span<const dvec3> positions, std::span<const dvec3> behind,
             const Bounds& bounds);
  /// The mesh's lines.
  explicit GpuStrokes(const Mesh& mesh)
      : GpuStrokes(mesh.lines, mesh.position, mesh.position, mesh.bounds) {}

  /// With the program of stroke.vert.glsl, in the model coordinates of GpuMesh.
  void draw() const;

 private:
  GlVertexArray array_;
  GlBuffer pieces_;
  GLsizei count_ = 0;
};

}  // namespace saddle
