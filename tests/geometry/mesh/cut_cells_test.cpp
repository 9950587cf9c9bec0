// The one pass over a grid makes of plain cells what a look at each cell would.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "mesh/grid/cell_loops.h"
#include "mesh/grid/corners.h"
#include "mesh/grid/grid.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/grid/triangulate.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/model/mesh_report.h"
#include "surface/parameter_box.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

Surface plain_waves(bool flip = false) {
  Surface surface = surface_from_text("u+v^2/9", "v", "sin(3*u)*cos(2*v)", {-2, 3, -2, 2});
  surface.flip = flip;
  return surface;
}

/// More than a tile each way, and not a multiple of it.
GridOptions several_tiles() {
  GridOptions options;
  options.cells_u = 300;
  options.cells_v = 270;
  return options;
}

Grid sample_tiles(const Surface& surface) {
  const Domain& d = surface.domain;
  return sample_grid(surface, even_lines(d.u0, d.u1, 300), even_lines(d.v0, d.v1, 270), 2);
}

TEST(PlainCells, AreCutAsTheyWouldBeOneByOne) {
  for (const bool flip : {false, true}) {
    const Surface surface = plain_waves(flip);
    Grid grid = sample_tiles(surface);
    const auto is_plain = [](GridCell cell) { return cell == GridCell::Two; };
    ASSERT_TRUE(std::ranges::all_of(grid.cells, is_plain));
    const Array<Triangle> in_one_pass = grid.mesh.triangles;
    std::ranges::fill(grid.cells, GridCell::Open);
    MeshReport report;
    triangulate(grid, open_cells(surface, 1, grid, report));
    ASSERT_TRUE(std::ranges::all_of(grid.cells, is_plain));
    const auto corners = [](Triangle t) {  // from the smallest on, in the same sense
      std::ranges::rotate(t, std::ranges::min_element(t));
      return t;
    };
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      const std::array one = {corners(in_one_pass[2 * cell]), corners(in_one_pass[2 * cell + 1])};
      const std::array other = {corners(grid.mesh.triangles[2 * cell]),
                                corners(grid.mesh.triangles[2 * cell + 1])};
      ASSERT_TRUE(std::ranges::is_permutation(one, other)) << cell;
    }
  }
}

TEST(PlainCells, HaveTheirVerticesInPlace) {
  const Surface surface = plain_waves();
  const Grid grid = sample_tiles(surface);
  const std::vector<SurfacePoint> points = evaluate_on_grid(surface, grid.u, grid.v);
  for (std::size_t vertex = 0; vertex < grid.vertex_count(); ++vertex) {
    ASSERT_EQ(grid.mesh.position[vertex], points[vertex].position) << vertex;
    ASSERT_EQ(grid.mesh.uv[vertex], grid.uv(vertex));
    ASSERT_EQ(grid.mesh.point[vertex], vertex);
    ASSERT_NEAR(glm::dot(grid.mesh.normal[vertex], points[vertex].r_u), 0, 1e-14);
  }
}

TEST(PlainCells, AreTheSameForAnyNumberOfThreads) {
  GridOptions options = several_tiles();
  options.threads = 1;
  const MeshResult one = mesh_on_grid(plain_waves(), options);
  options.threads = 3;
  const MeshResult three = mesh_on_grid(plain_waves(), options);
  EXPECT_EQ(one.mesh.position, three.mesh.position);
  EXPECT_EQ(one.mesh.normal, three.mesh.normal);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
  EXPECT_EQ(one.report.max_error, three.report.max_error);
}

TEST(PlainCells, AreCutAlikeOnEveryCpuLevel) {
  auto lower = std::make_unique<Strip>();
  auto upper = std::make_unique<Strip>();
  lower->size = upper->size = 4;
  for (std::size_t i = 0; i <= kTileCells; ++i) {
    const double s = 0.01 * static_cast<double>(i);
    for (Strip* strip : {lower.get(), upper.get()}) {
      const double t = strip == upper.get() ? 0.01 : 0;
      strip->x[i] = s;
      strip->y[i] = t;
      strip->z[i] = s * s - t * std::sin(9 * s);
      const dvec3 normal =
          glm::normalize(dvec3(-2 * s + 9 * t * std::cos(9 * s), std::sin(9 * s), 1));
      strip->n_x[i] = normal.x;
      strip->n_y[i] = normal.y;
      strip->n_z[i] = i % 7 == 3 ? -normal.z : normal.z;  // not plain
    }
  }
  auto lowest = std::make_unique<Cuts>();
  auto cuts = std::make_unique<Cuts>();
  cell_loop(CpuLevel::Sse2)(*lower, *upper, kTileCells, 1, *lowest);
  EXPECT_GT(std::count_if(lowest->margin.begin(), lowest->margin.end() - 1,
                          [](double margin) { return margin > 0; }),
            100);
  for (std::size_t level = 1; level < supported_level_count(); ++level) {
    cell_loop(static_cast<CpuLevel>(level))(*lower, *upper, kTileCells, 1, *cuts);
    for (std::size_t i = 0; i < kTileCells; ++i) {
      ASSERT_EQ(cuts->second[i], lowest->second[i]) << i;
      ASSERT_EQ(cuts->margin[i], lowest->margin[i]) << i;
      ASSERT_EQ(cuts->sagitta[i], lowest->sagitta[i]) << i;
    }
  }
}

TEST(PlainCells, AreNoneWhereTheSurfaceFoldsOrIsFlat) {
  // A sheet folded along u = 0.013, inside a column of cells.
  const Surface folded = surface_from_text("abs(u-0.013)", "v", "u^2", {-1, 1, -1, 1});
  const Grid grid = sample_grid(folded, even_lines(-1, 1, 20), even_lines(-1, 1, 20), 1);
  for (std::size_t j = 0; j < grid.cells_v; ++j) {
    for (std::size_t i = 0; i < grid.cells_u; ++i) {
      EXPECT_EQ(grid.cells[grid.cell(i, j)] == GridCell::Open, i == 10) << i << ' ' << j;
    }
  }
}

}  // namespace
}  // namespace saddle
