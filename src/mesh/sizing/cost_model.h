// The cost of meshes: a linear model of counted work, fitted to times of the gallery's surfaces by
// `./dev bench choose --fit`.
#pragma once

#include "mesh/model/mesh.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Nanoseconds on one machine. Only their ratios matter, which differ little between machines.
struct CostModel {
  double grid_sample;    ///< a point of a grid, with its share of cells and triangles
  double leaf_sample;    ///< a point of a cell tree
  double operation;      ///< an operation of a formula at a point; a function counts as 25
  double box;            ///< a box of parameters in a proof
  double box_operation;  ///< an operation of a formula over a box
  double triangle;       ///< drawing it once
};
inline constexpr CostModel kCosts = {67.4, 131, 0.289, 761, 0, 988};

/// Operations of a surface's formulas at a point of a grid, at any other point, and over a box. On
/// a grid, operations on u alone or v alone do not count.
struct Operations {
  double of_grid, of_point, of_box;
};
Operations count_operations(const Surface& surface);

/// Milliseconds for making a mesh, and for drawing its triangles `times` times.
double cost(const MeshWork& work, const Operations& operations);
double drawing_cost(double triangles, double times);

/// Estimated work of a grid, and of a cell tree, with this number of cells.
MeshWork work_of_grid(double cells);
MeshWork work_of_halving(double cells);

}  // namespace saddle
