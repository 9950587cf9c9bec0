// The distance of meshes and surfaces, where it is known on paper.
#include "study/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/mesher/grid_mesh.h"
#include "mesh/mesher/mesher.h"
#include "mesh_requests.h"
#include "study_subject.h"

namespace saddle {
namespace {

/// The worst points climb to within a thousandth.
constexpr double kShare = 1e-3;

TEST(MeshDistance, OfChordsOfACircleIsTheirSagitta) {
  const Scene scene = scene_of("cos(u)", "sin(u)", "v", {"0", "2*pi"});
  const Subject subject(scene, scene.surfaces[0]);
  const MeshDistance distance(subject);
  for (const int n : {12, 40}) {
    const Mesh mesh = mesh_on_grid(subject.surface, {n, 3, 0, 0, 0}).mesh;
    const double sagitta = 1 - std::cos(std::numbers::pi / n);
    EXPECT_NEAR(distance(mesh), sagitta, kShare * sagitta) << n;
  }
}

TEST(MeshDistance, FindsAPartOfTheSurfaceThatIsMissing) {
  const Scene scene = scene_of("u", "v", "0");
  const Subject subject(scene, scene.surfaces[0]);
  Mesh mesh = mesh_on_grid(subject.surface, {8, 8, 0, 0, 0}).mesh;
  Array<Triangle> left;
  for (const Triangle& t : mesh.triangles) {
    if (std::ranges::all_of(t, [&](std::uint32_t k) { return mesh.uv[k].x <= 0; })) {
      left.push_back(t);
    }
  }
  mesh.triangles = left;
  EXPECT_NEAR(MeshDistance(subject)(mesh), 1, kShare);
}

TEST(MeshDistance, FindsAHoleThatTheMeshCovers) {
  // Undefined nearer than 1/2 to the axis.
  const Scene holed = scene_of("u", "v", "0*sqrt(u^2+v^2-0.25)");
  const Scene plane = scene_of("u", "v", "0");
  const Subject subject(holed, holed.surfaces[0]);
  const Subject whole(plane, plane.surfaces[0]);
  const Mesh mesh = mesh_on_grid(whole.surface, {16, 16, 0, 0, 0}).mesh;
  // The middle is a corner; the nearest point that is looked at is an edge's middle.
  const double in_the_hole = MeshDistance(subject)(mesh);
  EXPECT_GT(in_the_hole, 0.5 - 1.0 / 16);
  EXPECT_LE(in_the_hole, 0.5 + kShare);
}

TEST(MeshDistance, FindsASpikeThatAMeshStepsOver) {
  const Scene scene = scene_of("u", "v", "exp(-20000*((u-0.313)^2+(v+0.217)^2))");
  const Subject subject(scene, scene.surfaces[0]);
  const Mesh mesh = mesh_on_grid(subject.surface, {4, 4, 0, 0, 0}).mesh;
  EXPECT_NEAR(MeshDistance(subject)(mesh), 1, kShare);
}

TEST(MeshDistance, FindsTheWayToARimWhereTheSurfaceStandsUpright) {
  // A chord of the rim, which is curved, is beyond it in the middle: no derivative leads back.
  const Scene scene = scene_of("u", "v", "asin(sinh(u)*sinh(v))", {"-3", "3"}, {"-3", "3"});
  const Subject subject(scene, scene.surfaces[0]);
  constexpr double kTolerance = 0.09;
  MeshRequest options = within_length(kTolerance);
  options.lines = {0, 0};
  const auto mesh = try_mesh(subject.surface, options);
  ASSERT_TRUE(mesh);
  const double distance = MeshDistance(subject)(mesh->mesh);
  EXPECT_GT(distance, 0.2 * kTolerance);
  EXPECT_LE(distance, kTolerance);
}

}  // namespace
}  // namespace saddle
