// Ears of polygons: which chords of a leaf's border become sides of triangles.
#include "mesh/tree/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/grid/grid.h"

namespace saddle {
namespace {

/// A wall from z = -1 to z = 1 along a circle: erf(2e3 (r - 0.5)).
SurfacePoint on_wall(const dvec2& uv) {
  const dvec2 from_middle = uv - dvec2(0.2, 0);
  const double steps = 2e3 * (glm::length(from_middle) - 0.5);
  const dvec2 slope =
      4e3 / std::sqrt(std::numbers::pi) * std::exp(-steps * steps) * glm::normalize(from_middle);
  return {{uv, std::erf(steps)}, {1, 0, slope.x}, {0, 1, slope.y}};
}

/// The wall crosses a cell. One side of it shows foot and top alone, with the plateaus' normals,
/// the other has vertices on the wall, of smaller cells.
TEST(Polygon, HasNoChordFromTheFootOfAWallToItsTop) {
  const double left = 0.8 / 3;
  Grid grid;
  grid.local_scale = 1;
  Polygon polygon;
  for (const dvec2& uv :
       {dvec2(left, 1.6 / 3), dvec2(left, 0.496874988), dvec2(left, 0.494205743),
        dvec2(left, 1.4 / 3), dvec2(0.3, 1.4 / 3), dvec2(0.3, 0.48333333), dvec2(0.3, 0.4875),
        dvec2(0.3, 0.48854167), dvec2(0.3, 0.48958333), dvec2(0.3, 0.490625),
        dvec2(0.3, 0.49166667), dvec2(0.3, 0.49583333), dvec2(0.3, 0.5), dvec2(0.3, 1.6 / 3)}) {
    const SurfacePoint point = on_wall(uv);
    const auto number = static_cast<std::uint32_t>(polygon.size());
    grid.mesh.position.push_back(point.position);
    const bool is_at_cliff = uv.x == left;
    grid.mesh.normal.push_back(is_at_cliff ? dvec3(0, 0, 1)
                                           : glm::normalize(glm::cross(point.r_u, point.r_v)));
    grid.mesh.uv.push_back(uv);
    grid.mesh.point.push_back(number);
    polygon.push_back({number, uv});
  }
  Array<Triangle> triangles;
  triangulate_polygon(grid, polygon, triangles);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3& a = grid.mesh.position[t[k]];
      const dvec3& b = grid.mesh.position[t[(k + 1) % 3]];
      const bool is_across_wall = std::fabs(a.z - b.z) > 1.9;
      EXPECT_TRUE(!is_across_wall || std::fabs(a.y - b.y) < 0.01)
          << a.x << " " << a.y << " to " << b.x << " " << b.y;
    }
  }
}

/// Two sectors that meet at (0, 0), where the last corner is up to rounding.
TEST(Polygon, IsCutWhereItTouchesItself) {
  Polygon polygon = {{0, {-1, 0}},   {1, {0, 0}},     {2, {0, 1}},
                     {3, {-0.4, 1}}, {4, {0, 1e-12}}, {5, {-1, 0.4}}};
  std::vector<Polygon> cut_off;
  cut_off_pinched(1e-9, polygon, cut_off);
  const auto corners_of = [](const Polygon& of) {
    std::vector<std::uint32_t> corners;
    for (const PolygonCorner& at : of) corners.push_back(at.corner);
    return corners;
  };
  EXPECT_EQ(corners_of(polygon), (std::vector<std::uint32_t>{0, 1, 5}));
  ASSERT_EQ(cut_off.size(), 1U);
  EXPECT_EQ(corners_of(cut_off[0]), (std::vector<std::uint32_t>{1, 2, 3}));
}

/// The last corner is beside the second: what is between the first of them and it is a line.
TEST(Polygon, IsNotCutIntoALine) {
  Polygon polygon = {{0, {-1, 0}}, {1, {0, 0}}, {2, {0, 1}}, {3, {-1, 1}}, {4, {0, 0}}};
  std::vector<Polygon> cut_off;
  cut_off_pinched(1e-9, polygon, cut_off);
  EXPECT_TRUE(cut_off.empty());
  EXPECT_EQ(polygon.size(), 5U);
}

TEST(Polygon, StaysWholeWhereNothingTouches) {
  Polygon polygon = {{0, {0, 0}}, {1, {1, 0}}, {2, {1, 1}}, {3, {0, 1}}};
  std::vector<Polygon> cut_off;
  cut_off_pinched(1e-9, polygon, cut_off);
  EXPECT_TRUE(cut_off.empty());
  EXPECT_EQ(polygon.size(), 4U);
}

}  // namespace
}  // namespace saddle
