// Meshes and their colours as they stand in the world, once for each node that shows them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"
#include "scene/model/scene.h"

namespace saddle {

/// It stands for a curve or point without a radius, which has no triangles.
bool is_line(const Scene& scene, std::span<const Mesh> meshes, std::size_t surface);

using Rgb = std::array<std::uint8_t, 3>;

/// The meshes of the scene's instances, in their order; meshes[i] is that of scene.surfaces[i].
std::vector<Mesh> placed_meshes(const Scene& scene, std::span<const Mesh> meshes);

/// The colours of the corners of placed_meshes(), none for a mesh without numbers to colour by.
/// Empty if no mesh is coloured.
std::vector<std::vector<Rgb>> placed_colors(const Scene& scene, std::span<const Mesh> meshes);

}  // namespace saddle
