// What meshes cost, from what can be counted before or after they are made: a linear model, fitted
// to times of the gallery's surfaces by `./dev bench choose --fit`.
#pragma once

#include "mesh/model/mesh.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Nanoseconds on one machine; between machines their ratios change little, and only those matter.
struct CostModel {
  double grid_sample;  ///< of a point of a grid, with its share of cells and triangles
  double leaf_sample;  ///< of a point of a mesh whose cells are halved
  double operation;    ///< of a formula, at a point; functions count as several
  double box;          ///< of parameters, that a proof tries
  double box_operation;
  double triangle;  ///< drawn once
};
inline constexpr CostModel kCosts = {67.4, 131, 0.289, 761, 0, 988};

/// Operations of a surface's formulas that a point takes on a grid, where what depends on u alone
/// or v alone is computed once, elsewhere, and in a box.
struct Operations {
  double of_grid, of_point, of_box;
};
Operations count_operations(const Surface& surface);

/// Milliseconds, of making a mesh and of drawing its triangles so many times.
double cost(const MeshWork& work, const Operations& operations);
double drawing_cost(double triangles, double times);

/// What a grid, and a mesh whose cells are halved, of so many cells is going to take, about.
MeshWork work_of_grid(double cells);
MeshWork work_of_halving(double cells);

}  // namespace saddle
