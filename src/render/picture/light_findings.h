// Findings about a picture's lights.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"
#include "mesh/model/mesh.h"
#include "meshing/findings.h"
#include "scene/model/scene.h"

namespace saddle {

/// A finding about a scene, or about one of its surfaces.
struct SceneFinding {
  std::string surface;  ///< its name; empty: about all of the scene
  Finding finding;
};

/// The sentence, after the surface's name.
std::string warning_of(const SceneFinding& found);

/// A surface of the resolved scene would be lit, and no light is on. Tells which values the
/// parameters take that turn lights on and off.
std::optional<SceneFinding> no_light(const Scene& scene);

/// Surfaces that are lit per vertex and lose part of a spot light's cone between their vertices, at
/// most one finding for each surface. `meshes[i]` is that of `scene.surfaces[i]`; `size`: pixels of
/// the picture.
std::vector<SceneFinding> lost_cones(const Scene& scene, std::span<const Mesh> meshes,
                                     const dvec2& size);

}  // namespace saddle
