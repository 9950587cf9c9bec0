// The surface that is studied, and for which picture.
#pragma once

#include <array>
#include <optional>

#include "base/bounds.h"
#include "base/vec.h"
#include "scene/model/camera.h"
#include "scene/model/prepare.h"
#include "study/truth.h"

namespace saddle {

struct Subject {
  const Scene& scene;
  const SurfaceSpec& spec;
  BoundSurface bound;  ///< the formulas
  Surface surface;     ///< of second order
  Truth truth;
  unsigned threads = 0;
  int width = 0;  ///< of the picture, in pixels
  int height = 0;
  int antialias = 1;
  double pixel = 0;            ///< side of a pixel on the surface, in units of length
  std::optional<Bounds> clip;  ///< what of the surface is drawn
  FittedCamera camera{};
  std::size_t max_triangles = 4'000'000;
  double normal_tolerance = 180;    ///< degrees, of meshes that are drawn
  std::optional<GridSize> samples;  ///< the scene's own grid, to compare

  Subject(const Scene& of, const SurfaceSpec& in_it)
      : scene(of),
        spec(in_it),
        bound(bind_surface(of, in_it)),
        surface(make_surface(bound.graph, bound.r, bound.domain, bound.flip, Order::Second)),
        truth(of, in_it) {}
};

}  // namespace saddle
