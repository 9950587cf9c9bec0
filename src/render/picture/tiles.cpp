#include "render/picture/tiles.h"

#include <algorithm>
#include <cmath>

namespace saddle {
namespace {

/// The length of each piece when `length` is split into the fewest equal ones of at most `most`.
int piece_length(int length, int most) {
  const int pieces = (length + most - 1) / most;
  return (length + pieces - 1) / pieces;
}

}  // namespace

int tile_margin(double widest) {
  return std::max(1, static_cast<int>(std::ceil(widest / 2)));
}

Tiling split_picture(int width, int height, int per_side, int limit, int margin) {
  const int most = std::max(1, limit / per_side - 2 * margin);
  Tiling tiling{piece_length(width, most), piece_length(height, most), {}};
  for (int y = 0; y < height; y += tiling.tile_height) {
    for (int x = 0; x < width; x += tiling.tile_width) {
      tiling.tiles.push_back(
          {x, y, std::min(tiling.tile_width, width - x), std::min(tiling.tile_height, height - y)});
    }
  }
  return tiling;
}

glm::dmat4 clip_to_rect(int width, int height, const PixelRect& rect, int margin) {
  const double left = rect.x - margin;
  const double right = rect.x + rect.width + margin;
  const double bottom = height - (rect.y + rect.height) - margin;
  const double top = height - rect.y + margin;
  glm::dmat4 m(1);
  m[0][0] = width / (right - left);
  m[1][1] = height / (top - bottom);
  m[3][0] = (width - left - right) / (right - left);
  m[3][1] = (height - bottom - top) / (top - bottom);
  return m;
}

}  // namespace saddle
