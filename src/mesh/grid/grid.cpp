#include "mesh/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "surface/normal.h"

namespace saddle {

namespace {

std::string format_point(const dvec3& p) {
  const auto number = [](double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", x + 0.0);  // -0 is 0
    return std::string(text.data());
  };
  return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
}

}  // namespace

void set_extent(Grid& grid, const Bounds& bounds) {
  grid.mesh.bounds = bounds;
  const double diagonal = safe_length(bounds.size());
  if (!std::isfinite(diagonal)) {
    throw Error(Status::Nothing, "the surface has no finite extent", {},
                "its finite samples reach from " + format_point(bounds.low) + " to " +
                    format_point(bounds.high));
  }
  const dvec3 least = rounding_of(glm::max(glm::abs(bounds.low), glm::abs(bounds.high)));
  const bool is_point = glm::all(glm::lessThanEqual(bounds.size(), least));
  if (is_point || diagonal < std::numeric_limits<double>::min()) {
    throw Error(Status::Nothing, "the surface is a single point, " + format_point(bounds.low), {},
                "x, y and z are the same at all samples; --samples takes more");
  }
  grid.local_scale = std::ldexp(1.0, -std::ilogb(diagonal));
  grid.diagonal = grid.local_scale * diagonal;
}

dvec2 Grid::cell_centre(std::size_t cell) const {
  const std::size_t i = cell % cells_u;
  const std::size_t j = cell / cells_u;
  return {0.5 * u[i] + 0.5 * u[i + 1], 0.5 * v[j] + 0.5 * v[j + 1]};
}

std::array<std::size_t, 4> Grid::vertices(std::size_t cell) const {
  const std::size_t first = cell + cell / cells_u;  // a row has one vertex more than cells
  const std::size_t above = first + cells_u + 1;
  return {first, first + 1, above + 1, above};
}

bool Grid::is_used(std::size_t vertex) const {
  if (left_out_count == 0) return true;
  bool used = false;
  for_cells_around(vertex, [&used](std::size_t, std::size_t) { used = true; });
  return used;
}

void Grid::forget_triangles() {
  for (GridCell& cell : cells) {
    if (cell <= GridCell::Two) cell = GridCell::Open;
  }
  mesh.triangles = Array<Triangle>();
}

void Grid::open_around(std::size_t vertex) {
  for_cells_around(vertex, [this](std::size_t cell, std::size_t) { cells[cell] = GridCell::Open; });
}

void require_defined_cells(const Grid& grid) {
  if (grid.left_out_count < grid.cell_count()) return;
  const auto& positions = grid.mesh.position;
  const auto samples = std::count_if(positions.begin(), positions.end(), is_finite);
  const std::string all = std::to_string(positions.size());
  if (samples == 0) {
    throw Error(Status::Nothing, "the surface is undefined everywhere", {},
                "none of the " + all + " samples has finite x, y and z");
  }
  throw Error(Status::Nothing, "the surface is defined at isolated samples only", {},
              std::to_string(samples) + " of " + all +
                  " samples are finite, but no four around a cell; --samples takes more");
}

}  // namespace saddle
