#include "mesh/distance/overlay.h"

#include <gtest/gtest.h>

#include <utility>

namespace saddle {
namespace {

/// A square of side 1 in the plane z=0, folded up along its diagonal from (0, 0) to (1, 1).
Grid folded_square(double height) {
  Grid grid;
  grid.mesh.position = {{0, 0, 0}, {1, 0, height}, {1, 1, 0}, {0, 1, height}};
  return grid;
}
const std::vector<Triangle> kSquare = {{0, 1, 2}, {0, 2, 3}};

TEST(IsOver, MeasuresFoldsUnderATriangle) {
  // The corners of the triangle are on the mesh; the fold is about 0.1 below the middle of its
  // long side.
  const Grid grid = folded_square(0.1);
  const std::array<dvec3, 3> triangle = {dvec3(0, 1, 0.1), dvec3(1, 0, 0.1), dvec3(1, 1, 0)};
  EXPECT_TRUE(is_over(triangle, grid, kSquare, 0.102));
  EXPECT_FALSE(is_over(triangle, grid, kSquare, 0.098));
}

TEST(IsOver, MeasuresWhatSticksOut) {
  const Grid grid = folded_square(0);
  const std::array<dvec3, 3> triangle = {dvec3(0.5, 0.5, 0), dvec3(1.3, 0.5, 0),
                                         dvec3(0.5, 0.7, 0)};
  EXPECT_TRUE(is_over(triangle, grid, kSquare, 0.301));
  EXPECT_FALSE(is_over(triangle, grid, kSquare, 0.299));
}

TEST(IsOver, FindsATriangleMissing) {
  const Grid grid = folded_square(0);
  const std::vector<Triangle> half = {kSquare[0]};
  const std::array<dvec3, 3> triangle = {dvec3(0.1, 0.3, 0), dvec3(0.2, 0.9, 0),
                                         dvec3(0.7, 0.9, 0)};
  EXPECT_TRUE(is_over(triangle, grid, kSquare, 0));
  EXPECT_FALSE(is_over(triangle, grid, half, 0.4));
  EXPECT_TRUE(is_over(triangle, grid, half, 0.5));
}

TEST(IsOver, DoesNotDependOnWhichSideIsUp) {
  const Grid grid = folded_square(0);
  std::array<dvec3, 3> triangle = {dvec3(0.1, 0.3, 0.2), dvec3(0.2, 0.9, 0.2),
                                   dvec3(0.7, 0.9, 0.2)};
  EXPECT_TRUE(is_over(triangle, grid, kSquare, 0.2));
  std::swap(triangle[0], triangle[1]);
  EXPECT_TRUE(is_over(triangle, grid, kSquare, 0.2));
}

TEST(IsOver, LeavesMeshesThatFoldBackAlone) {
  // The second triangle comes back over the first one.
  Grid grid = folded_square(0);
  grid.mesh.position[3] = {0.9, 0.1, 0.01};
  const std::array<dvec3, 3> triangle = {dvec3(0.5, 0.2, 0), dvec3(0.6, 0.2, 0),
                                         dvec3(0.6, 0.3, 0)};
  EXPECT_FALSE(is_over(triangle, grid, kSquare, 0.1));
}

TEST(IsOver, HoldsForNoTriangleWithoutArea) {
  const Grid grid = folded_square(0);
  const std::array<dvec3, 3> line = {dvec3(0.1, 0.1, 0), dvec3(0.2, 0.2, 0), dvec3(0.3, 0.3, 0)};
  EXPECT_FALSE(is_over({line[0], line[0], line[0]}, grid, kSquare, 1));
  EXPECT_FALSE(is_over(line, grid, kSquare, 1));
  EXPECT_FALSE(is_over({line[0], line[1], line[2]}, grid, {}, 1));
}

}  // namespace
}  // namespace saddle
