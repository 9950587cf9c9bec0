// How many triangles a surface may take when nobody says, and when somebody does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshing/tessellate.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"

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
  EXPECT_EQ(most_triangles(scene, {}), 750'000U);
  scene.surfaces.resize(10);
  EXPECT_EQ(most_triangles(scene, {}), 150'000U);
  scene.mesh.tolerance = ToleranceValue{1e-6, false};
  EXPECT_EQ(most_triangles(scene, {}), 150'000U);
  scene.surfaces.resize(20'000);
  EXPECT_EQ(most_triangles(scene, {}), 300U);
  scene.mesh.max_triangles = 5'000'000;
  EXPECT_EQ(most_triangles(scene, {}), 5'000'000U);
}

TEST(MostTriangles, AreSharedBySeveralSurfacesUnlessTheyAreAskedFor) {
  Scene scene = picture_of(800, 600);
  scene.surfaces.resize(1);
  EXPECT_FALSE(shares_limits(scene));
  scene.surfaces.resize(2);
  EXPECT_TRUE(shares_limits(scene));
  scene.mesh.max_triangles = 1000;
  EXPECT_FALSE(shares_limits(scene));
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

/// Pixels of a sphere's equator in a picture of a scene.
Scene sphere_of(double equator) {
  Scene scene = gallery_scene(*find_gallery_entry("sphere"));
  scene.camera.ortho = true;
  scene.camera.target = dvec3(0);
  scene.camera.distance = 5;
  // Half of the picture's height shows this much at the target; the sphere's radius is 1.
  const double shown = scene.picture.height / 2.0 * 2 * std::numbers::pi / equator;
  scene.camera.fov = 2 * std::atan(shown / 5) * 180 / std::numbers::pi;
  return resolve(scene);
}

std::size_t lines_on(const Scene& scene, const Purpose& purpose) {
  return tessellate(scene, scene.surfaces[0], purpose, 1).mesh.lines.size();
}

TEST(LinesInPictures, AreFewerOnWhatIsSmall) {
  // Of 16 lines of constant v, those at the poles are points.
  EXPECT_EQ(lines_on(sphere_of(600), {.picture = true}), 30U);
  EXPECT_EQ(lines_on(sphere_of(100), {.picture = true}), 16U + 4U);
  EXPECT_EQ(lines_on(sphere_of(25), {.picture = true}), 6U);
  EXPECT_EQ(lines_on(sphere_of(15), {.picture = true}), 0U);
}

TEST(LinesInPictures, AreThoseOfTheSceneWhereItSaysHowMany) {
  Scene scene = sphere_of(15);
  scene.surfaces[0].grid = kUsualGrid;
  EXPECT_EQ(lines_on(scene, {.picture = true}), 30U);
}

TEST(LinesInPictures, DoNotDependOnTheTolerance) {
  Scene scene = sphere_of(25);
  scene.mesh.tolerance = ToleranceValue{1e-3, false};
  EXPECT_EQ(lines_on(scene, {.picture = true}), 6U);
  scene.mesh.tolerance = ToleranceValue{0.1, true};
  EXPECT_EQ(lines_on(scene, {.picture = true}), 6U);
}

TEST(LinesInPictures, AreFewerOnACoarseGridOfCells) {
  Scene scene = sphere_of(15);
  scene.mesh.samples = GridSize{30, 30};
  EXPECT_EQ(lines_on(scene, {.picture = true}), 0U);
}

TEST(LinesInFilesOfMeshes, AreAllThere) {
  EXPECT_EQ(lines_on(sphere_of(15), {.mesh = true}), 30U);
}

}  // namespace
}  // namespace saddle
