#include "scene/model/color_scale.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scene/model/colormap.h"

namespace saddle {
namespace {

auto find_scale(const SurfaceSpec& spec, auto& scales) {
  return std::ranges::find_if(scales, [&](const ColorScale& scale) {
    return scale.formula == spec.color && scale.colormap == spec.colormap &&
           scale.ends == spec.color_ends;
  });
}

}  // namespace

std::vector<ColorScale> color_scales(const Scene& scene,
                                     std::span<const std::optional<ColorRange>> ranges) {
  assert(ranges.size() == scene.surfaces.size());
  std::vector<ColorScale> scales;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const SurfaceSpec& spec = scene.surfaces[i];
    if (!ranges[i] || spec.color.empty() || !spec.visible) continue;
    const auto known = find_scale(spec, scales);
    if (known == scales.end()) {
      scales.push_back({spec.color, spec.colormap, *ranges[i], spec.color_ends});
    } else {
      known->range.low = std::min(known->range.low, ranges[i]->low);
      known->range.high = std::max(known->range.high, ranges[i]->high);
      known->range.below = known->range.below || ranges[i]->below;
      known->range.above = known->range.above || ranges[i]->above;
    }
  }
  for (ColorScale& scale : scales) {
    if (scale.ends ? !scale.ends->symmetric : !is_diverging(scale.colormap)) continue;
    ColorRange& range = scale.range;
    // Numbers beyond one end may go to infinity: beyond the other one are none where it is moved.
    const double most = std::max(std::abs(range.low), std::abs(range.high));
    range = {-most, most, range.below && range.low == -most, range.above && range.high == most};
  }
  return scales;
}

const ColorScale& scale_of(const SurfaceSpec& spec, std::span<const ColorScale> scales) {
  return *find_scale(spec, scales);
}

double place_on(const ColorScale& scale, double number) {
  const double width = scale.range.high - scale.range.low;
  return width > 0 ? (number - scale.range.low) / width : 0.5;
}

dvec3 color_of(const ColorScale& scale, double number) {
  if (std::isnan(number)) return dvec3(0.5);
  return colormap_at(scale.colormap, place_on(scale, number));
}

}  // namespace saddle
