// Where a surface is, from samples: what a camera is fitted to before there are meshes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "scene/model/prepare.h"
#include "scene/model/scene.h"

namespace saddle {

/// Finite positions on a grid over a surface, and a box around them, clipped as its mesh will be.
struct Sampled {
  std::vector<dvec3> positions;
  Bounds bounds;
  bool moves = false;
  std::optional<Thickness> thickness = {};  ///< with which it was sampled
  bool has_poles = false;                   ///< as it seems

  void keep_to(const Bounds& box);
};

/// Samples a surface of so many cells each way, clipped to the scene's box or beside poles. `spec`:
/// the surface, or the curve or point that it stands for; `bound`: its formulas.
Sampled sample(const Scene& scene, const SurfaceSpec& spec, BoundSurface bound, std::size_t cells,
               unsigned threads);

/// Clips a surface that outgrows its picture.
void clip_to_readable(const Scene& scene, Sampled& surface);

}  // namespace saddle
