// Triangles in the order of their leaves.
#include "mesh/error/validated_mesh.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/random.h"

namespace saddle {
namespace {

/// Gives a leaf new triangles, at the end of all; the old ones stay.
void replace_triangles(std::size_t leaf, std::uint32_t count, std::uint32_t name,
                       ValidatedMesh& mesh) {
  LeafTriangles::Range& range = mesh.triangles.ranges[leaf];
  range.first = static_cast<std::uint32_t>(mesh.triangles.all.size());
  range.count = count;
  for (std::uint32_t k = 0; k < count; ++k) mesh.triangles.all.push_back({name, k, 0});
}

TEST(ValidatedMesh, SortsTrianglesByTheirLeaves) {
  constexpr std::size_t kLeaves = 50;
  for (std::uint64_t round = 0; round < 200; ++round) {
    ValidatedMesh mesh;
    mesh.triangles.ranges.resize(kLeaves);
    std::vector<std::vector<Triangle>> wanted(kLeaves);
    std::uint64_t drawn = round * 1000;
    const auto draw = [&drawn](double most) {
      return static_cast<std::uint32_t>(most * random_unit(drawn++));
    };
    const auto give = [&](std::size_t leaf) {
      replace_triangles(leaf, draw(5), draw(1e6), mesh);
      const std::span<const Triangle> own = mesh.triangles.of(leaf);
      wanted[leaf].assign(own.begin(), own.end());
    };
    for (std::size_t leaf = 0; leaf < kLeaves; ++leaf) give(leaf);
    for (std::uint32_t again = draw(40); again > 0; --again) give(draw(kLeaves));
    mesh.tidy_triangles();
    std::size_t count = 0;
    for (std::size_t leaf = 0; leaf < kLeaves; ++leaf) {
      const std::span<const Triangle> own = mesh.triangles.of(leaf);
      ASSERT_EQ(std::vector<Triangle>(own.begin(), own.end()), wanted[leaf]) << round;
      ASSERT_EQ(mesh.triangles.ranges[leaf].first, count) << round;
      count += own.size();
    }
    ASSERT_EQ(mesh.triangles.all.size(), count) << round;
  }
}

}  // namespace
}  // namespace saddle
