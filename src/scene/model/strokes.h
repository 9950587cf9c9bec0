// Curves and points among the surfaces of a scene, so that meshing and drawing know one kind of
// thing.
#pragma once

#include "scene/model/scene.h"

namespace saddle {

/// A resolved scene whose surfaces are followed by one for each of its curves, then its points,
/// that stands for it: with its name, label, colour, width and nodes. A scene that has them
/// already gets them anew. Scene files leave them out.
Scene with_strokes(Scene scene);

/// The radius of the tube or ball that it stands for; 0 without one.
double stroke_radius(const Scene& scene, const SurfaceSpec& spec);

}  // namespace saddle
