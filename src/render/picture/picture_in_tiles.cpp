#include "render/picture/picture_in_tiles.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/activity.h"
#include "base/bounds.h"
#include "render/gl/target.h"
#include "render/overlay/annotations.h"
#include "render/picture/placed_mesh.h"
#include "scene/model/color_scale.h"
#include "scene/model/instances.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// The ranges of the numbers that the meshes are coloured by.
std::vector<std::optional<ColorRange>> ranges_of(std::span<const Mesh> meshes) {
  std::vector<std::optional<ColorRange>> ranges;
  for (const Mesh& mesh : meshes) ranges.push_back(color_range_of(mesh));
  return ranges;
}

}  // namespace

FittedCamera fit_to_meshes(const Scene& scene, std::span<const Mesh> meshes, const dvec2& size) {
  const std::vector<Instance> all = instances(scene);
  Bounds bounds;
  for (const Instance& instance : all) {
    bounds.add(transformed(meshes[instance.surface].bounds, instance.to_world));
  }
  if (bounds.empty()) bounds.add(dvec3(0));  // nothing but background
  ViewPyramid seen = pyramid_beside_annotations(scene, scene.camera, bounds,
                                                color_scales(scene, ranges_of(meshes)), size);
  for (const Instance& instance : all) {
    const Mesh& mesh = meshes[instance.surface];
    add_points(mesh.position, mesh.bounds, instance.to_world, seen);
  }
  return fit_camera(drawn_camera(scene), bounds, size.x / size.y, &seen);
}

Image draw_image(Renderer& renderer, const Scene& scene, const FittedCamera& camera,
                 const PictureSettings& options, int tile_samples, const Look& look) {
  const int n = options.antialias;
  const int margin = tile_margin(widest_line(scene, dvec2(options.width, options.height)));
  const Tiling tiling = split_picture(options.width, options.height, n, tile_samples, margin);
  const Target target(n * (tiling.tile_width + 2 * margin), n * (tiling.tile_height + 2 * margin));
  const bool opaque = scene.background.a >= 1;  // no sample is see-through
  Image image(options.width, options.height);
  Activity tiles("tile", tiling.tiles.size());
  for (const PixelRect& tile : tiling.tiles) {
    renderer.draw(scene, camera, {options.width, options.height, tile, margin, double(n)}, look);
    target.read(margin * n, margin * n, n, opaque, tile, image);
    tiles.advance();
  }
  return image;
}

}  // namespace saddle
