// Pictures that exceed GL's limits or a sensible amount of memory are drawn in tiles.
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "render/gl/viewport.h"

namespace saddle {

/// Longest side of a tile in samples. Colour and depth of 4096 x 4096 take 200 MB; a picture of
/// 1920x1080 at antialias 2 is still one piece. GL allows 16384.
inline constexpr int kTileSamples = 4096;

/// Pixels drawn around each tile and thrown away: GL drops a wide line whose middle is outside.
/// `widest`: pixels of the widest line.
int tile_margin(double widest);

struct Tiling {
  int tile_width = 0;  ///< of the largest tile in pixels, without margin
  int tile_height = 0;
  std::vector<PixelRect> tiles;  ///< cover the picture once, in rows from the top
};

/// Tiles of about equal size, each with its margin at most `limit` samples a side (but at least a
/// pixel); `per_side` samples per pixel.
Tiling split_picture(int width, int height, int per_side, int limit, int margin);

/// Takes clip coordinates of the whole picture to those of `rect`, `margin` pixels added all
/// around.
glm::dmat4 clip_to_rect(int width, int height, const PixelRect& rect, int margin);

}  // namespace saddle
