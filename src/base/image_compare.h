// How different two pictures are.
#pragma once

#include "base/image.h"

namespace saddle {

/// Differences are on a scale of 0 to 1.
struct ImageDifference {
  double largest = 0;  ///< largest difference of red, green, blue or alpha of any pixel
  double mean = 0;     ///< mean over these channels and all pixels
  /// One number for a threshold: the mean perceptual difference of the 8x8 pixels that differ most,
  /// 1 if the sizes differ. 0.05: hard to tell apart; 0.1: a line is missing; 1: black and white.
  double error = 0;
  int x = 0;  ///< the middle of these pixels, from the left and from the top
  int y = 0;
};

/// Compares two pictures. Colours are taken over black, and over white too where pixels are
/// transparent. They are blurred, and compared in CIELAB with the colours of the other picture up
/// to a pixel away, so that a rim may move by a part of a pixel.
/// Sources: X. Zhang, B. Wandell, "A spatial extension of CIELAB for digital color-image
/// reproduction", 1997 (blurred Lab colours); CIE 15, "Colorimetry", 2004 (CIELAB, 1976).
ImageDifference compare_images(const Image& a, const Image& b);

/// A picture of the difference: grey where equal (a dimmed copy of `a`), red where not, the more
/// the brighter. The size is the larger of both; what only one has counts as different.
Image difference_image(const Image& a, const Image& b);

}  // namespace saddle
