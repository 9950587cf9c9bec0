#include "export/stl.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include <glm/vec3.hpp>

#include "base/error.h"
#include "exported.h"

namespace saddle {
namespace {

constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlFacet = 50;

dvec3 vector_in(const std::string& stl, std::size_t at) {
  dvec3 v;
  for (int k = 0; k < 3; ++k) v[k] = number_in<float>(stl, at + 4 * static_cast<std::size_t>(k));
  return v;
}

/// Six times the volume that the facets enclose.
double sixfold_volume(const std::string& stl) {
  double sum = 0;
  for (std::size_t at = kStlHeader; at < stl.size(); at += kStlFacet) {
    sum += glm::dot(vector_in(stl, at + 12),
                    glm::cross(vector_in(stl, at + 24), vector_in(stl, at + 36)));
  }
  return sum;
}

std::string stl_of(const Mesh& mesh, const Scene& scene = kSurfaceScene) {
  return bytes_of(write_stl, {{&mesh, 1}, scene});
}

TEST(Stl, HasAHeaderACountAndFacetsWithNormals) {
  const std::string stl = stl_of(tetrahedron());
  EXPECT_TRUE(stl.starts_with("saddle")) << "one that begins with solid is a text";
  EXPECT_EQ(number_in<std::uint32_t>(stl, 80), 4U);
  ASSERT_EQ(stl.size(), kStlHeader + 4 * kStlFacet);
  EXPECT_EQ(vector_in(stl, kStlHeader), dvec3(0, 0, -1));
  for (std::size_t at = kStlHeader; at < stl.size(); at += kStlFacet) {
    EXPECT_EQ(number_in<std::uint16_t>(stl, at + 48), 0);
  }
}

TEST(Stl, LeavesTheWallOfAHollowSolidHollow) {
  const double full = sixfold_volume(stl_of(tetrahedron()));
  const Mesh outside = thicken(tetrahedron(), {0.01, 0});
  const Mesh inside = thicken(tetrahedron({}, true), {0, 0.01});
  for (const Mesh& hollow : {outside, inside}) {
    const double volume = sixfold_volume(stl_of(hollow));
    EXPECT_GT(volume, 0);
    EXPECT_LT(volume, 0.3 * full);
  }
}

TEST(Stl, FacesOutwardWhateverTheSurfaceDoes) {
  EXPECT_NEAR(sixfold_volume(stl_of(tetrahedron())), 1, 1e-6);
  EXPECT_NEAR(sixfold_volume(stl_of(tetrahedron({}, true))), 1, 1e-6);
}

TEST(Stl, KeepsTheWindingOfAnOpenSurface) {
  const std::string stl = stl_of(open_square());
  EXPECT_EQ(vector_in(stl, kStlHeader), dvec3(0, 0, 1));
}

TEST(Stl, LeavesOutTrianglesThatRoundingFlattens) {
  const Mesh mesh = tetrahedron({1e9, 0, 0});
  const Scene scene = scene_of_surface();
  EXPECT_EQ(flattened_triangles(placed_meshes({{&mesh, 1}, scene})), 2U);
  const std::string stl = stl_of(mesh);
  EXPECT_EQ(number_in<std::uint32_t>(stl, 80), 2U) << "those that do not run along x";
  EXPECT_EQ(stl.size(), kStlHeader + 2 * kStlFacet);
}

TEST(Stl, HasEachNodesCopyWithTheFrontInFront) {
  Scene scene = scene_of_surface();
  SceneNode mirror{"mirror", "", {{Transform::Kind::Scale, dvec3(-2, 2, 2), 0}}};
  SceneNode still{"still", "", {}};
  scene.nodes = {mirror, still};
  scene.surfaces[0].in = {"still", "mirror"};
  const std::string stl = stl_of(tetrahedron(), scene);
  EXPECT_EQ(number_in<std::uint32_t>(stl, 80), 8U);
  EXPECT_NEAR(sixfold_volume(stl), 1 + 8, 1e-5);
}

TEST(Stl, TurnsTheAxisThatPointsUpAndScales) {
  const Mesh mesh = tetrahedron();
  const Scene scene = scene_of_surface();
  MeshContent content{{&mesh, 1}, scene};
  content.y_up = true;
  content.factor = 10;
  const std::string stl = bytes_of(write_stl, content);
  double top = 0;
  for (std::size_t at = kStlHeader; at < stl.size(); at += kStlFacet) {
    for (const std::size_t corner : {12U, 24U, 36U}) {
      top = std::max(top, vector_in(stl, at + corner).y);
      EXPECT_LE(vector_in(stl, at + corner).z, 0) << "y has become -z";
    }
  }
  EXPECT_EQ(top, 10);
  EXPECT_NEAR(sixfold_volume(stl), 1000, 1e-2);
}

TEST(Stl, RefusesWhatFloatsCannotHold) {
  const Mesh mesh = tetrahedron({1e39, 0, 0});
  EXPECT_THROW(stl_of(mesh), Error);
}

}  // namespace
}  // namespace saddle
