// What is proved of a mesh, and how much work goes into proofs where there are none.
#include <gtest/gtest.h>

#include "adaptive_options.h"
#include "geometry/gallery_samples.h"
#include "mesh/adaptive_mesh.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshReport report_on(const Surface& surface, double share = 1e-3) {
  return mesh_within_tolerance(surface, within_share(share))->report;
}

Surface surface_over(const char* x, const char* y, const char* z, const Domain& domain) {
  return surface_from_text(x, y, z, domain, {}, Order::Second);
}

TEST(Proofs, HoldForSurfacesThatAreSmooth) {
  const Domain around = {0, 2 * kPi, 0, 2 * kPi};
  const MeshReport torus =
      report_on(surface_over("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)", around));
  EXPECT_TRUE(torus.certified);
  EXPECT_LE(torus.work.boxes, 10U);
  // Bounds of these are wide in large boxes.
  const MeshReport ripple =
      report_on(surface_over("u", "v", "sin(9*sqrt(u^2+v^2+0.1))/9", {-2, 2, -2, 2}));
  EXPECT_TRUE(ripple.certified);
  EXPECT_GT(ripple.work.boxes, 100U);
}

TEST(Proofs, TakeThousandsOfBoxesForATubeAroundAKnot) {
  const Scene scene = scene_of("trefoil-tube");
  const Surface surface = prepare_surface(scene, scene.surfaces.front(), Order::Second).surface;
  const MeshReport tube = mesh_of(surface, scene, 1e-3).report;
  EXPECT_TRUE(tube.certified);
  EXPECT_GT(tube.work.boxes, 2000U);
}

TEST(Proofs, AreGivenUpSoonWhereDerivativesAreKnownAndTooLarge) {
  // Heights above the axis grow along a surface that is nearly upright there.
  const MeshReport funnel =
      report_on(surface_over("v*cos(u)", "v*sin(u)", "log(v)", {0, 2 * kPi, 1e-3, 1}));
  EXPECT_FALSE(funnel.certified);
  EXPECT_LE(funnel.work.boxes, 2500U);
}

TEST(Proofs, AreGivenUpSoonAlongLinesOfEndlessDerivatives) {
  const MeshReport fold =
      report_on(surface_over("u", "v", "abs(u-0.1)^1.5+abs(v-0.3)^1.5", {-1, 1, -1, 1}));
  EXPECT_FALSE(fold.certified);
  EXPECT_LE(fold.work.boxes, 2500U);
}

}  // namespace
}  // namespace saddle
