// Uniform grids that a study compares: squares, and the one that the scene asks for.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/model/mesh_report.h"
#include "study/measurement.h"
#include "study/subject.h"

namespace saddle {

/// Grids of `squares` cells each way, and that of --samples, by their number of cells.
std::vector<GridSize> uniform_grids(const Subject& subject, std::span<const int> squares);

/// "60x60".
std::string setting_of(const GridSize& grid);

/// Marks the measurement on the grid of --samples. All of them are on grids.
void mark_asked(const Subject& subject, std::span<Measurement> measurements);

/// The part of the surface that is drawn, on a grid. Throws Error (Nothing) if it has none.
MeshResult uniform_mesh(const Subject& subject, const GridSize& grid);

}  // namespace saddle
