// One surface of a scene as triangles, as the command line asks for them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/report.h"
#include "app/tolerance.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

namespace saddle {

/// A mesh, and all that there is to say about it.
struct Tessellation {
  Mesh mesh;
  SurfaceReport report;
  std::vector<std::string> warnings;
  bool moves = false;     ///< at another time it is another mesh
  double parse_ms = 0;    ///< text to graph
  double compile_ms = 0;  ///< derivatives and tapes
  double tessellate_ms = 0;
};

/// Triangles at most: what --max-triangles says; 4000000 for whoever asks for a tolerance, or for
/// cells; else about as many as the picture has pixels, from 1000000 to 4000000, which is more than
/// can be told apart in it.
std::size_t most_triangles(const Scene& scene);

/// Prepares and tessellates surface `spec` of `scene`: on the grid of --samples, or with the fewest
/// triangles that keep the tolerance of `purpose`. Throws Error as prepare_surface() and
/// mesh_on_grid() do.
Tessellation tessellate(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                        unsigned threads);

}  // namespace saddle
