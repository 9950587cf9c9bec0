// Level lines on a mesh: of any number that depends on u and v. Their vertices are on the surface
// itself, roots of the number minus the level; the mesh only says where to look for them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "mesh/color/color_mesh.h"
#include "mesh/model/mesh.h"
#include "surface/surface.h"

namespace saddle {

struct ContourOptions {
  double tolerance = 0;   ///< largest distance of a line from the true one
  double mesh_error = 0;  ///< distance of mesh and surface
  double rounding = 0;    ///< numbers that differ by no more are equal
  /// The levels, given the range of the numbers that are drawn.
  std::function<std::vector<double>(const ColorRange&)> levels;
  std::optional<Bounds> clip = {};  ///< the box that the mesh was cut along
  std::size_t max_triangles = 4'000'000;
  unsigned threads = 0;
};

struct ContourReport {
  std::optional<ColorRange> range;  ///< of the numbers on what is drawn; nothing: there are none
  std::vector<double> levels;
  std::vector<double> on_areas;  ///< levels that the number has on whole areas: these have no line
  std::size_t lines = 0;
  bool reached_limit = false;  ///< of max_triangles
};

/// Adds the level lines of the surface's colour tape to `mesh`, which stays as it is otherwise. A
/// copy of its triangles is halved until no side is longer than kFirstSide of the ranges and none
/// has a level twice, by its samples and their parabola, or its sides are as short as the
/// tolerance. A closed line that is smaller, and is met by no sample, is missed. Lines end where
/// the mesh does, and where the number jumps over the level or is not defined.
ContourReport add_contours(const Surface& surface, const ContourOptions& options, Mesh& mesh);

}  // namespace saddle
