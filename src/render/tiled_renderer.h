// render() with its inner limit exposed, for tests.
#pragma once

#include "render/renderer.h"

namespace saddle {

/// render(), drawing at most `tile_samples` samples a side at once (see kTileSamples).
Rendering render_in_tiles(const Scene& scene, std::span<const Mesh> meshes,
                          const RenderOptions& options, int tile_samples);

}  // namespace saddle
