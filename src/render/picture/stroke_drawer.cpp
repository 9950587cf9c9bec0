#include "render/picture/stroke_drawer.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "render/picture/placed_mesh.h"
#include "render/picture/tiles.h"
#include "scene/model/instances.h"
#include "scene/model/strokes.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// Strokes are drawn nearer to the eye by so many half widths, and pixels, so that they win over
/// the surface that they lie on, also where that is inclined by 60 degrees, and where both are
/// within their tolerance.
constexpr double kHalfWidthsNearer = 2;
constexpr double kPixelsNearer = 2;

/// A camera that shows all in the same place, but nearer by this share of half the picture's height
/// there.
FittedCamera camera_nearer(FittedCamera camera, bool ortho, double share) {
  glm::dmat4 toward(1);
  if (ortho) {
    toward[3][2] = share * camera.half_height;
  } else {
    const double factor = 1 - share * camera.half_height / camera.distance;
    for (int k = 0; k < 3; ++k) toward[k][k] = factor;
  }
  camera.eye_to_clip = camera.eye_to_clip * toward;
  return camera;
}

}  // namespace

void StrokeDrawer::set_mesh(std::size_t surface, const Mesh& mesh) {
  strokes_.resize(std::max(strokes_.size(), surface + 1));
  anchors_.resize(strokes_.size());
  strokes_[surface].reset();
  if (mesh.triangles.empty() && !mesh.lines.empty()) strokes_[surface].emplace(mesh);
  anchors_[surface] = mesh.anchor;
}

void StrokeDrawer::keep_meshes(std::size_t count) {
  strokes_.resize(std::min(count, strokes_.size()));
  anchors_.resize(strokes_.size());
}

bool StrokeDrawer::has_strokes() const {
  return std::ranges::any_of(strokes_, [](const auto& strokes) { return strokes.has_value(); });
}

void StrokeDrawer::draw(const Scene& scene, std::span<const GpuMesh> meshes, const Screen& screen,
                        Program& program) {
  const auto& [camera, viewport, unit] = screen;
  const double n = viewport.per_side;
  const PixelRect& rect = viewport.rect;
  const dvec2 samples(viewport.samples_across(), viewport.samples_down());
  for (const Instance& instance : instances(scene)) {
    const auto& strokes = strokes_[instance.surface];
    const SurfaceSpec& surface = scene.surfaces[instance.surface];
    if (!strokes || !surface.is_stroke()) continue;
    const double half_width =
        line_width_of(surface, dvec2(scene.picture.width, scene.picture.height)) / 2;
    const FittedCamera nearer =
        camera_nearer(camera, scene.camera.ortho,
                      (kHalfWidthsNearer * half_width + kPixelsNearer) * 2 / viewport.height);
    const PlacedMesh item(instance, meshes[instance.surface], nearer, unit);
    if (!item.is_visible()) continue;
    program.use();
    program.set(
        "model_to_clip",
        clip_to_rect(viewport.width, viewport.height, rect, viewport.margin) * item.model_to_clip);
    program.set("half_size", dvec3(samples / 2.0, n * half_width));
    const Color& color = surface.line_color;
    program.set("line_color", dvec3(color.r, color.g, color.b));
    program.check_all_set();
    glEnable(GL_DEPTH_CLAMP);  // the camera's near plane may touch them
    strokes->draw();
    glDisable(GL_DEPTH_CLAMP);
  }
}

std::vector<SpaceLabel> StrokeDrawer::labels(const Scene& scene, const FittedCamera& camera,
                                             const dvec2& size) const {
  std::vector<SpaceLabel> result;
  for (const Instance& instance : instances(scene)) {
    const SurfaceSpec& surface = scene.surfaces[instance.surface];
    const auto& anchor = anchors_[instance.surface];
    if (surface.label.empty() || !anchor) continue;
    const dvec3 place(instance.to_world * glm::dvec4(*anchor, 1));
    const auto at = pixel_of(camera, place, size);
    if (!at) continue;
    double clear =
        surface.is_stroke()
            ? line_width_of(surface, dvec2(scene.picture.width, scene.picture.height)) / 2
            : 0;
    const double radius = stroke_radius(scene, surface) * largest_stretch(instance.to_world);
    if (radius > 0) {
      const dvec3 up(camera.world_to_eye[0][1], camera.world_to_eye[1][1],
                     camera.world_to_eye[2][1]);
      const auto rim = pixel_of(camera, place + radius * up, size);
      if (rim) clear = glm::length(*rim - *at);
    }
    result.push_back({surface.label, *at, clear});
  }
  return result;
}

}  // namespace saddle
