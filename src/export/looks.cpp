#include "export/looks.h"

#include <algorithm>
#include <cstdint>

#include "export/placed_meshes.h"
#include "scene/model/colormap.h"

namespace saddle {
namespace {

constexpr int kImageColors = 256;
constexpr int kBandPixels = 16;

}  // namespace

dvec3 rgb_of(const Color& color) {
  return {color.r, color.g, color.b};
}

Image colormap_image(std::span<const ColorScale> scales) {
  Image image(kImageColors, kBandPixels * static_cast<int>(scales.size()));
  for (int y = 0; y < image.height; ++y) {
    const ColorScale& scale = scales[static_cast<std::size_t>(y / kBandPixels)];
    for (int x = 0; x < kImageColors; ++x) {
      const Rgb rgb = bytes_of(colormap_at(scale.colormap, x / (kImageColors - 1.0)));
      std::uint8_t* const pixel = image.pixel(x, y);
      std::ranges::copy(rgb, pixel);
      pixel[3] = 255;
    }
  }
  return image;
}

dvec2 place_in_image(double place, std::size_t row, std::size_t rows) {
  return {(0.5 + (kImageColors - 1) * place) / kImageColors,
          (static_cast<double>(row) + 0.5) / static_cast<double>(rows)};
}

}  // namespace saddle
