// Supersampling: squares of samples become pixels.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/image.h"
#include "render/gl/viewport.h"

namespace saddle {

/// Most samples per pixel and side: a square of 16x16 8-bit samples is the largest whose sum fits
/// in 16 bits.
inline constexpr int kMostSamplesPerSide = 16;

/// RgbaSamples as GL leaves them: straight RGBA, rows from the bottom.
struct RgbaSamples {
  const std::uint8_t* rgba = nullptr;  ///< the sample at the lower left
  std::size_t row_bytes = 0;           ///< from a row to the one above it
  int per_side = 1;                    ///< samples per pixel and side, 1 to kMostSamplesPerSide
  bool opaque = true;                  ///< all alphas are 255
};

/// Fills `rect` of `image` with the mean of each pixel's samples, rounded to nearest. Colours are
/// weighted by their alpha, as light adds up, and are straight again in the result.
void average_samples(const RgbaSamples& samples, const PixelRect& rect, Image& image);

}  // namespace saddle
