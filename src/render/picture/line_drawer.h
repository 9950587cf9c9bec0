// Lines on surfaces: grid lines, marks and the box of axes as GL's lines, contours as strokes.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "render/gl/gpu_mesh.h"
#include "render/gl/program.h"
#include "render/gl/viewport.h"
#include "render/picture/placed_mesh.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

/// Samples across a line of so many pixels, at least 1.
int samples_across(double pixels, const Viewport& viewport);

/// Draws into the current target, whose depths are known. `meshes`: of the scene's surfaces;
/// `items`: where they are.
class LineDrawer {
 public:
  void draw_lines(const Scene& scene, std::span<const PlacedMesh> items,
                  std::span<const GpuMesh> meshes, const Viewport& viewport);
  void draw_contours(const Scene& scene, std::span<const PlacedMesh> items,
                     std::span<const GpuMesh> meshes, const Viewport& viewport);
  void draw_marks(const GpuMesh& marks, const PlacedMesh& item, const Viewport& viewport);
  /// The edges of a box, fainter than `ink`, which its labels have.
  void draw_box(std::span<const std::array<dvec3, 2>> edges, const FittedCamera& camera,
                const Viewport& viewport, const dvec3& ink);

  /// Draws lines of one colour, its uniform "line_color".
  Program& program();
  /// Draws strokes of one colour: "line_color"; "half_size" is of the target and their width.
  Program& stroke_program();
  /// The driver has drawn lines thinner than they should be.
  bool has_thinner_lines() const { return has_thinner_lines_; }

 private:
  std::optional<Program> program_;
  std::optional<Program> stroke_program_;
  bool has_thinner_lines_ = false;
};

}  // namespace saddle
