#include "study/uniform_grids.h"

#include <algorithm>

#include "mesh/mesher/mesher.h"
#include "mesh/model/clip.h"
#include "mesh/model/tidy.h"

namespace saddle {

std::vector<GridSize> uniform_grids(const Subject& subject, std::span<const int> squares) {
  std::vector<GridSize> grids;
  for (const int n : squares) grids.push_back({n, n});
  std::erase_if(grids, [&](const GridSize& grid) { return is_asked(subject, grid); });
  if (subject.samples) grids.push_back(*subject.samples);
  const auto cells = [](const GridSize& grid) { return static_cast<double>(grid.u) * grid.v; };
  std::ranges::stable_sort(grids, {}, cells);
  return grids;
}

bool is_asked(const Subject& subject, const GridSize& grid) {
  return subject.samples && subject.samples->u == grid.u && subject.samples->v == grid.v;
}

std::string setting_of(const GridSize& grid) {
  return std::to_string(grid.u) + "x" + std::to_string(grid.v);
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
