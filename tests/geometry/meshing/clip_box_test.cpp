// The box that a surface with thin poles is clipped to: it cuts no strips of what is beside them.
#include "meshing/clip_box.h"

#include <gtest/gtest.h>

#include <string>

#include "mesh_checks.h"
#include "meshing/tessellate.h"
#include "scene/model/assignments.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

TEST(ClipBox, ShowsThinPolesAndCutsNothingElse) {
  constexpr double kPole = 0.378522;
  for (const double c : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    Scene scene;
    assign(scene, "c=" + std::to_string(c));
    assign(scene, "z=c/(u-" + std::to_string(kPole) + ")");
    scene = resolve(scene);
    const Tessellation result = tessellate(scene, scene.surfaces.at(0), {.mesh = true}, 1);
    const Bounds box = result.mesh.bounds;
    EXPECT_GT(box.size().z, 0.499) << c << ": a quarter of the sides of its square";
    // A height h is exceeded within c/h of the pole. The mesh ends on the box up to a tolerance,
    // along two edges of length 2.
    const double left_out = 2 * (c / box.high.z - c / box.low.z);
    EXPECT_NEAR(area_in_uv(result.mesh), 4 - left_out, 4 * *result.report.tolerance) << c;
    EXPECT_GT(result.report.pole_count, 0U) << c;
  }
}

TEST(ClipBox, HoldsLogarithmsBesideZero) {
  // At (0, 0) doubles come as near to the pole as 5e-324, elsewhere as near as 1e-19.
  Scene scene;
  assign(scene, "z=0.002*ln(abs(u-v))");
  scene = resolve(scene);
  const Tessellation result = tessellate(scene, scene.surfaces.at(0), {.mesh = true}, 1);
  EXPECT_GT(result.mesh.bounds.low.z, -0.5) << "a quarter of the sides of its square";
}

TEST(ClipBox, IsNotAsFarAsRoundingGoesOnAnEdgeOfTheDomain) {
  // The sine of 2 pi is 2e-16: there the radius is -7.
  Scene scene;
  for (const char* const text : {"r=2+ln(abs(sin(3*u)*cos(4*v)))/4", "x=r*cos(v)*cos(u)",
                                 "y=r*cos(v)*sin(u)", "z=r*sin(v)", "u=0:2*pi", "v=-pi/2:pi/2"})
    assign(scene, text);
  scene = resolve(scene);
  const Tessellation result = tessellate(scene, scene.surfaces.at(0), {.mesh = true}, 1);
  for (const int axis : {0, 1, 2}) {
    EXPECT_GT(result.mesh.bounds.low[axis], -2.5);
    EXPECT_LT(result.mesh.bounds.high[axis], 2.5);
  }
  // A first mesh is cut by four faces of the box: it ends once it has seen that all six are needed.
  EXPECT_GT(result.mesh.triangles.size(), 100'000U) << "the work is left for the last mesh";
}

}  // namespace
}  // namespace saddle
