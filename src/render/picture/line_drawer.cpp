#include "render/picture/line_drawer.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>

#include "render/gl/gl.h"
#include "render/picture/tiles.h"
#include "render/shading/shaders.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

constexpr dvec3 kMarkColor{0.3, 0.9, 0.5};
/// The box around the surfaces is less conspicuous than its labels.
constexpr double kBoxInk = 0.3;

}  // namespace

int samples_across(double pixels, const Viewport& viewport) {
  return std::max(1, static_cast<int>(std::lround(pixels * viewport.per_side)));
}

Program& LineDrawer::program() {
  if (!program_) {
    program_.emplace(std::string(shader_source("unlit.vert.glsl")),
                     std::string(shader_source("line.frag.glsl")));
  }
  return *program_;
}

Program& LineDrawer::stroke_program() {
  if (!stroke_program_) {
    stroke_program_.emplace(std::string(shader_source("stroke.vert.glsl")),
                            std::string(shader_source("stroke.frag.glsl")));
  }
  return *stroke_program_;
}

void LineDrawer::draw_lines(const Scene& scene, std::span<const PlacedMesh> items,
                            std::span<const GpuMesh> meshes, const Viewport& viewport) {
  if (std::ranges::none_of(meshes, &GpuMesh::has_lines)) return;
  program().use();
  for (const PlacedMesh& item : items) {
    const SurfaceSpec& surface = scene.surfaces[item.surface];
    const GpuMesh& mesh = meshes[item.surface];
    if (!mesh.has_lines() || surface.is_stroke()) continue;
    const Color& color = surface.line_color;
    program().set("line_color", dvec3(color.r, color.g, color.b));
    const double width = line_width_of(surface, viewport.size());
    has_thinner_lines_ |= !set_line_width(samples_across(width, viewport));
    program().set("model_to_clip", item.model_to_clip);
    program().check_all_set();
    mesh.draw_lines();
  }
}

void LineDrawer::draw_contours(const Scene& scene, std::span<const PlacedMesh> items,
                               std::span<const GpuMesh> meshes, const Viewport& viewport) {
  const dvec2 half_samples = dvec2(viewport.samples_across(), viewport.samples_down()) / 2.0;
  Program& program = stroke_program();
  program.use();
  glEnable(GL_DEPTH_CLAMP);  // they may stand out of the box that holds the triangles
  for (const PlacedMesh& item : items) {
    const SurfaceSpec& surface = scene.surfaces[item.surface];
    const GpuMesh& mesh = meshes[item.surface];
    if (!mesh.has_contours()) continue;
    const Color& color = contour_color_of(surface, scene.theme);
    program.set("line_color", dvec3(color.r, color.g, color.b));
    const double width = contour_width_of(surface, viewport.size()) * viewport.per_side;
    program.set("half_size", dvec3(half_samples, width / 2));
    program.set("model_to_clip", item.model_to_clip);
    program.check_all_set();
    mesh.draw_contours();
  }
  glDisable(GL_DEPTH_CLAMP);
}

void LineDrawer::draw_box(std::span<const std::array<dvec3, 2>> edges, const FittedCamera& camera,
                          const Viewport& viewport, const dvec3& ink) {
  const GpuMesh box(mesh_of_lines(edges));
  const PlacedMesh item({}, box, camera, box.frame().size);
  program().use();
  program().set("line_color", glm::mix(dvec3(0.5), ink, kBoxInk));
  program().set("model_to_clip",
                clip_to_rect(viewport.width, viewport.height, viewport.rect, viewport.margin) *
                    item.model_to_clip);
  program().check_all_set();
  set_line_width(samples_across(fit_line_width(viewport.size()), viewport));
  glEnable(GL_DEPTH_CLAMP);
  box.draw_lines();
  glDisable(GL_DEPTH_CLAMP);
}

/// They may stand out of the box that the camera's near and far planes enclose.
void LineDrawer::draw_marks(const GpuMesh& marks, const PlacedMesh& item,
                            const Viewport& viewport) {
  program().use();
  program().set("line_color", kMarkColor);
  program().set("model_to_clip", item.model_to_clip);
  program().check_all_set();
  set_line_width(samples_across(fit_line_width(viewport.size()), viewport));
  glEnable(GL_DEPTH_CLAMP);
  marks.draw_lines();
  glDisable(GL_DEPTH_CLAMP);
}

}  // namespace saddle
