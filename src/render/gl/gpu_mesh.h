// A mesh in GL buffers: doubles become floats.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "mesh/model/mesh.h"
#include "render/gl/gl.h"
#include "render/gl/gpu_strokes.h"
#include "render/gl/model_frame.h"
#include "render/gl/program.h"

namespace saddle {

/// A mesh that has only these lines.
Mesh mesh_of_lines(std::span<const std::array<dvec3, 2>> lines);

/// Lines are so many samples wide from now on; returns false if the driver draws only thinner ones.
bool set_line_width(int samples);

/// Positions, normals, triangles and lines of one mesh. Needs a current context.
class GpuMesh {
 public:
  explicit GpuMesh(const Mesh& mesh);

  const Bounds& bounds() const { return bounds_; }
  const ModelFrame& frame() const { return frame_; }
  bool hides_its_back() const { return hides_its_back_; }
  /// The range of the numbers that it is coloured by; nothing if it is not.
  const std::optional<ColorRange>& color_range() const { return color_range_; }
  bool has_lines() const { return line_indices_ > 0; }
  bool has_contours() const { return contours_.has_value(); }
  /// Gives its corners their u and v, and what the program of trust_shader() finds out about each
  /// of them. Returns the share of corners that it trusts.
  double measure_trust(Program& program, std::span<const dvec2> uv);
  /// The parts of a solid; nothing of a sheet.
  const std::optional<SolidParts>& solid() const { return solid_; }
  std::size_t triangle_count() const { return static_cast<std::size_t>(triangle_indices_) / 3; }
  /// Gives its corners their places on a texture, 0 to 1 over the ranges of u and v.
  void set_texture_places(std::span<const dvec2> places);
  bool has_texture_places() const { return texture_places_.has_value(); }
  void draw_triangles() const;
  /// So many of them, from one on.
  void draw_triangles(std::size_t first, std::size_t count) const;
  void draw_lines() const;
  /// Its level lines, with the program of stroke.vert.glsl.
  void draw_contours() const;

 private:
  Bounds bounds_;
  ModelFrame frame_;  ///< of the bounds
  std::optional<SolidParts> solid_;
  bool hides_its_back_;
  std::optional<ColorRange> color_range_;
  GlVertexArray triangle_array_;
  GlVertexArray line_array_;
  GlBuffer vertices_;
  GlBuffer triangles_;
  GlBuffer lines_;
  std::optional<GlBuffer> colors_;  ///< of the corners, 0 to 1 in that range, -1: undefined
  std::optional<GlBuffer> parameters_;
  std::optional<GlBuffer> trust_;
  std::optional<GlBuffer> texture_places_;
  std::optional<GpuStrokes> contours_;
  GLsizei triangle_indices_ = 0;
  GLsizei line_indices_ = 0;
};

}  // namespace saddle
