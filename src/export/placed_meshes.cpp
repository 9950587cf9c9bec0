#include "export/placed_meshes.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "scene/model/color_scale.h"
#include "scene/model/instances.h"

namespace saddle {

bool is_line(const Scene& scene, std::span<const Mesh> meshes, std::size_t surface) {
  return scene.surfaces[surface].is_stroke() && meshes[surface].triangles.empty();
}

std::vector<Mesh> placed_meshes(const Scene& scene, std::span<const Mesh> meshes) {
  std::vector<Mesh> result;
  for (const Instance& instance : instances(scene, World::True)) {
    if (is_line(scene, meshes, instance.surface)) continue;
    result.push_back(transformed(meshes[instance.surface], instance.to_world));
  }
  return result;
}

std::vector<std::vector<Rgb>> placed_colors(const Scene& scene, std::span<const Mesh> meshes) {
  std::vector<std::optional<ColorRange>> ranges;
  for (const Mesh& mesh : meshes) ranges.push_back(color_range_of(mesh));
  const std::vector<ColorScale> scales = color_scales(scene, ranges);
  if (scales.empty()) return {};
  std::vector<std::vector<Rgb>> result;
  for (const Instance& instance : instances(scene, World::True)) {
    if (is_line(scene, meshes, instance.surface)) continue;
    std::vector<Rgb>& colors = result.emplace_back();
    const SurfaceSpec& spec = scene.surfaces[instance.surface];
    for (const double number : meshes[instance.surface].color) {
      const dvec3 color = color_of(scale_of(spec, scales), number);
      Rgb& rgb = colors.emplace_back();
      for (int k = 0; k < 3; ++k) {
        rgb[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(255 * color[k]));
      }
    }
  }
  return result;
}

}  // namespace saddle
