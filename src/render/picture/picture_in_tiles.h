// A picture by a renderer that is there already, piece by piece.
#pragma once

#include <span>

#include "base/image.h"
#include "base/vec.h"
#include "mesh/model/mesh.h"
#include "render/picture/renderer.h"
#include "render/picture/tiles.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

/// The camera that render() draws a picture of this size with.
FittedCamera fit_to_meshes(const Scene& scene, std::span<const Mesh> meshes, const dvec2& size);

/// Draws a picture off screen, at most `tile_samples` samples a side at once, and reads it back.
/// Leaves another framebuffer bound than there was.
Image draw_image(Renderer& renderer, const Scene& scene, const FittedCamera& camera,
                 const PictureSettings& options, int tile_samples = kTileSamples,
                 const Look& look = {});

}  // namespace saddle
