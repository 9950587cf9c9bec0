// Annotations of a picture: the box around all surfaces with ticks on its edges, the title, and a
// bar for each scale of colours. Places and lengths are in pixels from the picture's upper left.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/bounds.h"
#include "render/overlay/label_writer.h"
#include "scene/model/camera.h"
#include "scene/model/color_scale.h"
#include "scene/model/scene.h"

namespace saddle {

/// A colormap from its first colour at the bottom to its last at the top.
struct ColorBar {
  dvec2 upper_left;
  dvec2 size;
  std::string colormap;
};

struct Annotations {
  std::vector<std::array<dvec3, 2>> edges;    ///< of the box, in the world; the surfaces hide them
  std::vector<std::array<dvec2, 2>> strokes;  ///< on top of all
  std::vector<ColorBar> bars;
  std::vector<WrittenText> texts;
  std::string unknown;  ///< characters of the texts that have no letter: boxes stand for them

  bool empty() const { return edges.empty() && bars.empty() && texts.empty(); }
};

/// A text beside a place.
struct SpaceLabel {
  std::string text;
  dvec2 at;          ///< pixels
  double clear = 0;  ///< pixels around it that the text keeps off
};

/// The annotations of a scene in a picture of this size: the box with its ticks and the title if it
/// has `axes`, a bar for each of `scales`. Ticks and labels are outside of the box's outline, so
/// that they never hide a surface; labels keep clear of each other and of the picture's border, or
/// are left out. The offset and the power of ten that ticks leave out of their numbers are always
/// written: an axis without room for them has no labels. A title or a formula that is too long ends
/// in an ellipsis. Labels are written first, to the right of their places and above, or where there
/// is room.
Annotations annotate(const Scene& scene, const FittedCamera& camera, const Bounds& box,
                     std::span<const ColorScale> scales, const dvec2& size,
                     std::span<const SpaceLabel> labels = {});

/// A pyramid along the camera's view into which what is seen goes, so that there is room for all
/// that. It holds `box` if the scene has axes, else nothing yet.
ViewPyramid pyramid_beside_annotations(const Scene& scene, const Camera& camera, const Bounds& box,
                                       std::span<const ColorScale> scales, const dvec2& size);

}  // namespace saddle
