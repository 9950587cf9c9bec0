// The picture that a surface really gives: no mesh, no interpolated normals, no floats.
#pragma once

#include <vector>

#include "base/image.h"
#include "study/subject.h"

namespace saddle {

/// Colours of 0 to 1, rows from the top.
struct ExactImage {
  int width = 0;
  int height = 0;
  std::vector<dvec3> color;
};

/// The subject's picture by its camera, on black, in the default colours and lights, without grid
/// lines: each pixel the mean of 8x8 samples. Method: the surface is diced into cells of about a
/// pixel; the nearest one that covers a sample says where on the surface to start, and Newton's
/// method finds the (u, v) whose point is on the sample's ray.
/// Source: R. Cook, L. Carpenter, E. Catmull, "The Reyes image rendering architecture", 1987.
ExactImage draw_exactly(const Subject& subject);

/// Root of the mean square of the differences of colours.
double rms_error(const Image& image, const ExactImage& exact);

}  // namespace saddle
