// Pictures piece by piece: render() with its limit exposed, for tests, and without its context, for
// a renderer that is there already.
#pragma once

#include "render/picture/picture.h"
#include "render/picture/renderer.h"
#include "render/picture/tiles.h"

namespace saddle {

/// The camera that render() draws a picture of this size with.
FittedCamera fit_to_meshes(const Scene& scene, std::span<const Mesh> meshes, const dvec2& size);

/// Draws a picture off screen, at most `tile_samples` samples a side at once, and reads it back.
/// Leaves another framebuffer bound than there was.
Image draw_image(Renderer& renderer, const Scene& scene, const FittedCamera& camera,
                 const PictureSettings& options, int tile_samples = kTileSamples);

/// render(), drawing at most `tile_samples` samples a side at once (see kTileSamples).
Rendering render_in_tiles(const Scene& scene, std::span<const Mesh> meshes,
                          const PictureSettings& options, int tile_samples,
                          Backend backend = Backend::Any);

}  // namespace saddle
