#include "scene/model/strokes.h"

#include <algorithm>
#include <utility>

#include "scene/model/bind_stroke.h"

namespace saddle {
namespace {

SurfaceSpec stand_in(const Scene& scene, const StrokeSpec& stroke) {
  SurfaceSpec spec;
  spec.name = stroke.name;
  spec.label = stroke.label;
  spec.visible = stroke.visible;
  spec.grid = GridSize{0, 0};
  spec.front.diffuse = spec.back.diffuse = spec.line_color = stroke.color;
  spec.line_width = stroke.width;
  const bool is_on_surface = !stroke.u.empty() || !stroke.v.empty();
  spec.in = stroke.in.empty() && is_on_surface ? surface_under(scene, stroke).in : stroke.in;
  return spec;
}

}  // namespace

Scene with_strokes(Scene scene) {
  std::erase_if(scene.surfaces, [](const SurfaceSpec& spec) { return spec.is_stroke(); });
  std::vector<SurfaceSpec> strokes;
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    strokes.push_back(stand_in(scene, scene.curves[i]));
    strokes.back().curve = i;
  }
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    strokes.push_back(stand_in(scene, scene.points[i]));
    strokes.back().point = i;
  }
  std::ranges::move(strokes, std::back_inserter(scene.surfaces));
  return scene;
}

double stroke_radius(const Scene& scene, const SurfaceSpec& spec) {
  if (!spec.is_stroke()) return 0;
  const StrokeSpec& stroke = spec.curve ? static_cast<const StrokeSpec&>(scene.curves[*spec.curve])
                                        : scene.points[*spec.point];
  return stroke.radius.value_or(0);
}

}  // namespace saddle
