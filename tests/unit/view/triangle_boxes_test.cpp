// The hierarchy of boxes finds what a look at each triangle finds.
#include "view/model/triangle_boxes.h"

#include <gtest/gtest.h>

#include <set>

#include "base/random.h"
#include "view/model/pick.h"

namespace saddle {
namespace {

/// Triangles of some size, anywhere in a cube.
Mesh random_mesh(std::size_t count) {
  Mesh mesh;
  std::uint64_t key = 0;
  const auto number = [&] { return 2 * random_unit(key++) - 1; };
  for (std::uint32_t i = 0; i < count; ++i) {
    const dvec3 middle(number(), number(), number());
    for (int corner = 0; corner < 3; ++corner) {
      mesh.position.push_back(middle + 0.3 * dvec3(number(), number(), number()));
      mesh.uv.emplace_back(i, corner);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// The nearest hit among those of meshes of one triangle each.
std::optional<Hit> first_of_all(const Mesh& mesh, const Ray& ray) {
  std::optional<Hit> nearest;
  for (const Triangle& triangle : mesh.triangles) {
    Mesh one = mesh;
    one.triangles = {triangle};
    const auto hit = first_hit(one, TriangleBoxes(one), ray);
    if (hit && (!nearest || hit->distance < nearest->distance)) nearest = hit;
  }
  return nearest;
}

TEST(TriangleBoxes, MissNoTriangle) {
  for (const std::size_t count : {1, 8, 9, 70, 600}) {
    const Mesh mesh = random_mesh(count);
    const TriangleBoxes boxes(mesh);
    std::uint64_t key = 1000;
    for (int i = 0; i < 40; ++i) {
      const dvec3 from = 3.0 * dvec3(random_unit(key), random_unit(key + 1), random_unit(key + 2));
      const dvec3 to(random_unit(key + 3) - 0.5, random_unit(key + 4) - 0.5, 0);
      key += 5;
      const Ray ray{from, glm::normalize(to - from)};
      const auto found = first_hit(mesh, boxes, ray);
      const auto wanted = first_of_all(mesh, ray);
      ASSERT_EQ(found.has_value(), wanted.has_value()) << count << " triangles, ray " << i;
      if (!found) continue;
      EXPECT_EQ(found->distance, wanted->distance);
    }
  }
}

TEST(TriangleBoxes, MeetRaysAlongAnAxisAndBoxesWithoutThickness) {
  Mesh mesh;
  mesh.position = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  mesh.uv = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  const TriangleBoxes boxes(mesh);
  for (const dvec2& at : {dvec2(0.2, 0.2), dvec2(0, 0), dvec2(0.5, 0), dvec2(0, 0.5)}) {
    const auto hit = first_hit(mesh, boxes, {{at, 5}, {0, 0, -1}});
    ASSERT_TRUE(hit) << at.x << ' ' << at.y;
    EXPECT_EQ(hit->distance, 4);
  }
  EXPECT_FALSE(first_hit(mesh, boxes, {{0.2, 0.2, 5}, {0, 0, 1}}));
}

TEST(TriangleBoxes, LookAtFewTrianglesOfManyThatFollowEachOther) {
  Mesh mesh;
  constexpr std::uint32_t kCount = 4096;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    for (const dvec3& corner : {dvec3(i, 0, 0), dvec3(i + 1, 0, 0), dvec3(i, 1, 0)}) {
      mesh.position.push_back(corner);
      mesh.uv.emplace_back(0, 0);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  std::set<std::size_t> seen;
  TriangleBoxes(mesh).along(
      {{1000.2, 0.2, 3}, {0, 0, -1}}, [] { return 1e9; },
      [&](std::size_t triangle) { seen.insert(triangle); });
  EXPECT_TRUE(seen.contains(1000));
  EXPECT_LE(seen.size(), 16U);
}

}  // namespace
}  // namespace saddle
