// Pictures that are drawn in more passes than they need.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <span>

#include "render/gl/context.h"
#include "render/picture/picture_in_tiles.h"

namespace saddle {

/// A square picture of one surface, lit by at most so many lights in a pass.
inline Image draw_in_passes(const Scene& scene, const Mesh& mesh, int size,
                            std::size_t lights_at_once) {
  const auto context = make_osmesa_context();
  Renderer renderer(lights_at_once);
  renderer.set_mesh(0, mesh);
  return draw_image(renderer, scene, fit_to_meshes(scene, std::span(&mesh, 1), dvec2(size)),
                    {size, size, 1});
}

/// Of any channel of any pixel, in levels of 8 bits.
inline int largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
  }
  return largest;
}

}  // namespace saddle
