// Grids whose cells are checked row by row come out as they would place by place.
#include "mesh/error/check_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "base/random.h"
#include "mesh/error/error_loops.h"
#include "mesh/grid/grid.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/grid/vertex_columns.h"
#include "surface/parameter_box.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// Cells are cut along either diagonal.
Surface waves(bool flip) {
  Surface surface =
      surface_from_text("u+v^2/9", "v", "sin(3*u)*cos(2*v)", {-2, 3, -2, 2}, {}, Order::Second);
  surface.flip = flip;
  return surface;
}

/// More than a strip wide.
Grid sample(const Surface& surface) {
  static_assert(kTileCells < 300);
  const Domain& d = surface.domain;
  return sample_grid(surface, even_lines(d.u0, d.u1, 300), even_lines(d.v0, d.v1, 40), 1);
}

MeasuredError check(const Surface& surface, const Grid& grid, bool is_seen = false) {
  const auto lines = [is_seen](std::size_t count) {
    return std::vector<std::uint8_t>(count, is_seen ? 1 : 0);
  };
  return check_cells(surface, grid, {lines(grid.u.size()), lines(grid.v.size())}, 2);
}

/// The largest deviation of some places that are spread over each cell.
SampledError by_places(const Surface& surface, const Grid& grid) {
  SampledError worst;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto vertices = grid.vertices(cell);
    const dvec2 low = grid.uv(vertices[0]);
    const dvec2 high = grid.uv(vertices[2]);
    std::vector<dvec2> places;
    for (const double p : {0.02, 0.25, 0.5, 0.75, 0.98}) {
      for (const double q : {0.03, 0.26, 0.51, 0.76, 0.97}) {
        places.push_back(low + dvec2(p, q) * (high - low));
      }
    }
    const std::vector<SurfacePoint> points = evaluate(surface, places);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const SampledError d =
          sampled_error(grid, grid.triangles(cell), places[k], points[k], surface.flip);
      worst.distance = std::max(worst.distance, d.distance);
      worst.degrees = std::max(worst.degrees, d.degrees);
    }
  }
  return worst;
}

TEST(CheckCells, TellsWhatPlacesTellOneByOne) {
  for (const bool flip : {false, true}) {
    const Surface surface = waves(flip);
    const Grid grid = sample(surface);
    const SampledError worst = by_places(surface, grid);
    const MeasuredError error = check(surface, grid);
    EXPECT_NEAR(error.distance, worst.distance, 0.05 * worst.distance);
    EXPECT_NEAR(error.normal_degrees, worst.degrees, 0.15 * worst.degrees);
  }
}

TEST(CheckCells, SeesTheOneVertexThatIsOff) {
  const Surface surface = waves(false);
  const Grid grid = sample(surface);
  const MeasuredError usual = check(surface, grid);
  for (const std::size_t column : {0UL, 1UL, 7UL, 255UL, 256UL, 257UL, 299UL, 300UL}) {
    for (const std::size_t row : {0UL, 19UL, 40UL}) {
      const std::size_t vertex = grid.vertex(column, row);
      Grid spoilt = grid;
      spoilt.mesh.position[vertex] += 0.02 * grid.mesh.normal[vertex];
      const MeasuredError off = check(surface, spoilt);
      EXPECT_GT(off.distance, 0.009) << column << ", " << row;
      EXPECT_LT(off.distance, 0.021) << column << ", " << row;
      EXPECT_NEAR(off.normal_degrees, usual.normal_degrees, 0.1);

      spoilt = grid;
      spoilt.mesh.normal[vertex] = -grid.mesh.normal[vertex];
      const MeasuredError turned = check(surface, spoilt);
      EXPECT_GT(turned.normal_degrees, 90) << column << ", " << row;
      EXPECT_NEAR(turned.distance, usual.distance, 1e-12);
    }
  }
}

TEST(CheckCells, LooksCloserWhereACellIsNotPlain) {
  const Surface surface = waves(false);
  Grid grid = sample(surface);
  const std::size_t cell = grid.cell(256, 20);
  const double usual = check(surface, grid).distance;
  std::swap(grid.mesh.triangles[2 * cell], grid.mesh.triangles[2 * cell + 1]);
  EXPECT_NEAR(check(surface, grid).distance, usual, 1e-12);
  grid.cells[cell] = GridCell::One;  // half of it is not covered
  EXPECT_GT(check(surface, grid).distance, 3 * usual);
}

TEST(CheckCells, FindsWhatHasNoNormalInfinitelyFarOff) {
  const Surface cusp = surface_from_text("u^2", "u^3", "v", {-1, 1, 0, 1}, {}, Order::Second);
  const Grid grid = sample_grid(cusp, even_lines(-1, 1, 4), even_lines(0, 1, 4), 1);
  EXPECT_FALSE(std::isfinite(check(cusp, grid).distance));
}

TEST(CheckCells, HoldsSeenLinesToTheirChords) {
  // Along a wave of small steps aside, the surface is a plane.
  const Surface plane =
      surface_from_text("u", "v+0.05*sin(9*u)", "0*u", {0, 1, 0, 1}, {}, Order::Second);
  const Grid grid = sample_grid(plane, even_lines(0, 1, 10), even_lines(0, 1, 10), 1);
  EXPECT_LT(check(plane, grid).distance, 1e-12);
  EXPECT_GT(check(plane, grid, true).distance, 1e-3);
}

TEST(CheckCells, TellsTheSameOnEveryCpuLevel) {
  // A wavy strip, and places straight above it, a few of them far aside.
  const auto strips = std::make_unique<std::array<Strip, 2>>();
  std::array<std::vector<double>, 9> surface;
  std::vector<double> along_u;
  std::vector<double> second;
  for (std::size_t i = 0; i <= kTileCells; ++i) {
    const double s = 0.01 * static_cast<double>(i);
    const dvec3 normal = glm::normalize(dvec3(-std::cos(s), 0, 1));
    for (std::size_t k = 0; k < 2; ++k) {
      put_vertex({s, 0.02 * static_cast<double>(k), std::sin(s)}, normal, i, (*strips)[k]);
    }
    along_u.push_back(0.1 + 0.8 * random_unit(i));
    second.push_back(std::floor(3 * random_unit(1000 + i)) - 1);  // -1, 0 or 1
    const double at = s + 0.01 * along_u.back() + (i % 9 == 0 ? 1 : 0);
    const std::array row = {at, 0.01, std::sin(at), normal.x, normal.y, normal.z, 1.0, 1.0, 1.0};
    for (std::size_t k = 0; k < row.size(); ++k) surface[k].push_back(row[k]);
  }
  RowPlaces places{along_u.data(), 0.5, second.data(), {}, 1, 1};
  for (std::size_t k = 0; k < surface.size(); ++k) places.surface[k] = surface[k].data();
  const auto check = [&](CpuLevel level) {
    auto result = std::make_unique<RowErrors>();
    check_loop(level)((*strips)[0], (*strips)[1], places, kTileCells, *result);
    return result;
  };
  const auto lowest = check(CpuLevel::Sse2);
  const auto known = std::count(lowest->is_known.begin(), lowest->is_known.end() - 1, 1.0);
  EXPECT_GT(known, 100);
  EXPECT_LT(known, 200);
  for (std::size_t level = 1; level < supported_level_count(); ++level) {
    const auto result = check(static_cast<CpuLevel>(level));
    for (std::size_t i = 0; i < kTileCells; ++i) {
      ASSERT_EQ(result->is_known[i], lowest->is_known[i]) << i;
      ASSERT_EQ(result->distance[i], lowest->distance[i]) << i;
      ASSERT_EQ(result->chord[i], lowest->chord[i]) << i;
    }
  }
}

}  // namespace
}  // namespace saddle
