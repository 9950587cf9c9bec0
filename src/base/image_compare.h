// How different two pictures are.
#pragma once

#include "base/image.h"

namespace saddle {

/// All differences are over red, green, blue and alpha, on a scale of 0 to 1.
struct ImageDifference {
  double largest = 0;  ///< largest difference of any channel of any pixel
  double mean = 0;     ///< mean over all channels and pixels
  double ssim = 1;     ///< mean structural similarity of the luminance, 1 for equal pictures
  /// One number for a threshold: 1 - ssim, at least `mean` (colours count too), 1 if the sizes
  /// differ. 0: equal; 0.04: hard to tell apart; 0.1: visible; 0.5: other things in the picture.
  double error = 0;
};

/// Compares two pictures. Transparent pixels are compared as if over black.
/// Source: Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli, "Image quality assessment: from error
/// visibility to structural similarity", 2004 (8x8 windows, every 4 pixels; K1 0.01, K2 0.03).
ImageDifference compare_images(const Image& a, const Image& b);

/// A picture of the difference: grey where equal (a dimmed copy of `a`), red where not, the more
/// the brighter. The size is the larger of both; what only one has counts as different.
Image difference_image(const Image& a, const Image& b);

}  // namespace saddle
