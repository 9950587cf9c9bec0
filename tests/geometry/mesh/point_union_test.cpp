// Corners of a mesh that are one point, while the mesh grows.
#include <gtest/gtest.h>

#include "mesh/model/point_union.h"

namespace saddle {
namespace {

void add_corner(Mesh& mesh, double x) {
  mesh.point.push_back(static_cast<std::uint32_t>(mesh.point.size()));
  mesh.position.emplace_back(x, 0, 0);
}

TEST(PointUnion, AreNamedAfterTheirFirstCornersAndAreWhereThoseAre) {
  Mesh mesh;
  for (int k = 0; k < 6; ++k) add_corner(mesh, k);
  PointUnion points(mesh);
  points.unite(5, 3);
  points.unite(3, 1);
  points.unite(4, 2);
  points.settle();
  EXPECT_EQ(mesh.point, (Array<std::uint32_t>{0, 1, 2, 1, 2, 1}));
  EXPECT_EQ(mesh.position[5].x, 1);
  EXPECT_EQ(mesh.position[4].x, 2);
}

TEST(PointUnion, KnowCornersThatCameLaterAsOthersPoints) {
  Mesh mesh;
  for (int k = 0; k < 3; ++k) add_corner(mesh, k);
  PointUnion points(mesh);
  points.unite(1, 2);
  points.settle();
  add_corner(mesh, 3);
  mesh.point[3] = 1;  // a vertex that was found to be a pole
  add_corner(mesh, 4);
  points.unite(0, 1);
  points.settle();
  EXPECT_EQ(mesh.point, (Array<std::uint32_t>{0, 0, 0, 0, 4}));
  EXPECT_EQ(mesh.position[3].x, 0);
}

TEST(PointUnion, TellWhichOfThemHaveGrown) {
  Mesh mesh;
  for (int k = 0; k < 6; ++k) add_corner(mesh, k);
  PointUnion points(mesh);
  points.unite(0, 3);
  points.unite(1, 4);
  points.settle();
  EXPECT_EQ(points.take_changed(), (std::vector<std::uint32_t>{3, 4}));
  points.unite(4, 1);  // known
  points.unite(5, 3);
  points.settle();
  EXPECT_EQ(points.take_changed(), (std::vector<std::uint32_t>{3, 5}));
  EXPECT_TRUE(points.take_changed().empty());
}

}  // namespace
}  // namespace saddle
