// How many triangles a surface may take when nobody says, and when somebody does.
#include <gtest/gtest.h>

#include "meshing/tessellate.h"

namespace saddle {
namespace {

Scene picture_of(int width, int height) {
  Scene scene;
  scene.picture.width = width;
  scene.picture.height = height;
  return scene;
}

TEST(MostTriangles, AreAsManyAsThePictureHasPixels) {
  EXPECT_EQ(most_triangles(picture_of(1600, 1200), {}), 1'920'000U);
  EXPECT_EQ(most_triangles(picture_of(1200, 1600), {}), 1'920'000U);
}

TEST(MostTriangles, AreEnoughForAThumbnailAndBoundedForAPoster) {
  EXPECT_EQ(most_triangles(picture_of(64, 48), {}), 1'000'000U);
  EXPECT_EQ(most_triangles(picture_of(800, 600), {}), 1'000'000U);
  EXPECT_EQ(most_triangles(picture_of(16000, 12000), {}), 4'000'000U);
}

TEST(MostTriangles, AreFourMillionForWhoeverAsksForATolerance) {
  Scene scene = picture_of(64, 48);
  scene.mesh.tolerance = ToleranceValue{1e-6, false};
  EXPECT_EQ(most_triangles(scene, {}), 4'000'000U);
}

TEST(MostTriangles, AreFourMillionForWhoeverAsksForCells) {
  Scene scene = picture_of(64, 48);
  scene.mesh.samples = GridSize{.u = 10, .v = 10};
  EXPECT_EQ(most_triangles(scene, {}), 4'000'000U);
}

TEST(MostTriangles, OfSeveralSurfacesAreSharedEvenly) {
  Scene scene = picture_of(800, 600);
  scene.surfaces.resize(2);
  EXPECT_EQ(most_triangles(scene, {}), 1'000'000U);
  scene.surfaces.resize(10);
  EXPECT_EQ(most_triangles(scene, {}), 250'000U);
  scene.mesh.tolerance = ToleranceValue{1e-6, false};
  EXPECT_EQ(most_triangles(scene, {}), 250'000U);
  scene.surfaces.resize(20'000);
  EXPECT_EQ(most_triangles(scene, {}), 300U);
  scene.mesh.max_triangles = 5'000'000;
  EXPECT_EQ(most_triangles(scene, {}), 5'000'000U);
}

TEST(MostTriangles, AreThoseThatAreAskedForAboveAll) {
  Scene scene = picture_of(1600, 1200);
  scene.mesh.tolerance = ToleranceValue{1e-6, false};
  scene.mesh.samples = GridSize{.u = 10, .v = 10};
  for (const int asked : {2, 5'000'000}) {
    scene.mesh.max_triangles = asked;
    EXPECT_EQ(most_triangles(scene, {}), static_cast<std::size_t>(asked));
  }
}

}  // namespace
}  // namespace saddle
