// The nearest triangles of small and large trees, against a look at each triangle.
#include "mesh/distance/nearest_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "mesh/model/triangle_tree.h"

namespace saddle {
namespace {

dvec3 random_point(std::uint64_t number) {
  return {random_unit(3 * number), random_unit(3 * number + 1), random_unit(3 * number + 2)};
}

/// Small triangles that wander through a box.
Array<Triangle> random_triangles(std::size_t count, Grid& grid) {
  Array<Triangle> triangles;
  for (std::size_t k = 0; k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(grid.mesh.position.size());
    const dvec3 middle = random_point(k / 16);
    for (std::uint64_t corner = 0; corner < 3; ++corner)
      grid.mesh.position.push_back(middle + 0.01 * random_point(3 * k + corner));
    triangles.push_back({first, first + 1, first + 2});
  }
  return triangles;
}

TEST(NearestTriangles, AreThoseOfALookAtEach) {
  // The boxes of the last are made when they are asked for.
  for (const std::size_t count : {0, 1, 5, 1000, 140'000}) {
    Grid grid;
    const Array<Triangle> triangles = random_triangles(count, grid);
    const NearestTriangles tree(grid, triangles);
    for (std::uint64_t k = 0; k < 20; ++k) {
      const dvec3 place = random_point(1'000'000 + k);
      double distance = NearestTriangle().distance;
      for (const Triangle& triangle : triangles)
        distance = std::min(distance, nearest_point(grid, triangle, place).distance);
      std::size_t visited = 0;
      EXPECT_EQ(tree.nearest(place, 0, {}, visited).distance, distance) << count;
    }
  }
}

TEST(TriangleTree, NamesTheNearestTriangle) {
  // The numbers of nodes follow from these counts: full levels, one triangle more, and many.
  for (const std::size_t count : {1, 4, 5, 8, 9, 16, 17, 31, 33, 1000, 5001}) {
    Grid grid;
    const Array<Triangle> triangles = random_triangles(count, grid);
    for (const unsigned threads : {1U, 3U}) {
      const TriangleTree tree(grid.mesh.position, triangles, threads);
      for (std::uint64_t k = 0; k < 20; ++k) {
        const dvec3 place = random_point(1'000'000 + k);
        const auto [distance, which] = tree.nearest(place);
        ASSERT_TRUE(which);
        EXPECT_NEAR(nearest_point(grid, triangles[*which], place).distance, distance, 1e-12);
        for (const Triangle& triangle : triangles)
          EXPECT_GE(nearest_point(grid, triangle, place).distance, distance - 1e-12) << count;
        const auto [known, none] = tree.nearest(place, 0.5 * distance);
        EXPECT_FALSE(none);
        EXPECT_EQ(known, 0.5 * distance);
      }
    }
  }
}

TEST(TriangleTree, NamesTheNearestCorner) {
  Grid grid;
  const Array<Triangle> triangles = random_triangles(1000, grid);
  auto& position = grid.mesh.position;
  const std::vector<dvec3> corners(position.begin(), position.end());
  // Vertices that are corners of no triangle do not count.
  for (std::uint64_t k = 0; k < 20; ++k) position.push_back(random_point(1'000'000 + k));
  const TriangleTree tree(position, triangles);
  for (std::uint64_t k = 0; k < 20; ++k) {
    const dvec3 place = random_point(1'000'000 + k);
    const auto distance_of = [&](const dvec3& p) { return glm::distance(place, p); };
    const double least = distance_of(*std::ranges::min_element(corners, {}, distance_of));
    const auto [distance, corner] = tree.nearest_corner(place, 2 * least);
    ASSERT_TRUE(corner);
    EXPECT_EQ(distance_of(position[*corner]), least);
    EXPECT_EQ(distance, least);
    EXPECT_FALSE(tree.nearest_corner(place, 0.5 * least).corner);
  }
}

}  // namespace
}  // namespace saddle
