#include "study/uniform_grids.h"

#include <algorithm>

#include "mesh/mesher/mesher.h"
#include "mesh/model/clip.h"
#include "mesh/model/tidy.h"

namespace saddle {

std::vector<GridSize> uniform_grids(const Subject& subject, std::span<const int> squares) {
  std::vector<GridSize> grids;
  for (const int n : squares) grids.push_back({n, n});
  if (const auto& asked = subject.samples) {
    std::erase_if(grids, [&](const GridSize& g) { return g.u == asked->u && g.v == asked->v; });
    grids.push_back(*asked);
  }
  const auto cells = [](const GridSize& grid) { return static_cast<double>(grid.u) * grid.v; };
  std::ranges::stable_sort(grids, {}, cells);
  return grids;
}

std::string setting_of(const GridSize& grid) {
  return std::to_string(grid.u) + "x" + std::to_string(grid.v);
}

void mark_asked(const Subject& subject, std::span<Measurement> measurements) {
  if (!subject.samples) return;
  for (Measurement& m : measurements) m.is_asked = m.setting == setting_of(*subject.samples);
}

MeshResult uniform_mesh(const Subject& subject, const GridSize& grid) {
  MeshResult mesh = mesh_on_grid(subject.surface, {grid.u, grid.v, 0, 0, subject.threads});
  if (subject.clip) {
    clip_mesh(*subject.clip, mesh.mesh);
    keep_used_corners(mesh.mesh);
  }
  return mesh;
}

}  // namespace saddle
