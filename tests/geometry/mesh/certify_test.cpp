// What is proved of a mesh, and how much work goes into proofs where there are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/gallery/samples.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/topology.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshReport report_on(const Surface& surface, double share = 1e-3) {
  return try_mesh(surface, within_share(share))->report;
}

MeshReport report_on_gallery(const char* name, double share) {
  const Scene scene = scene_of(name);
  const Surface surface = prepare_surface(scene, scene.surfaces.front(), Order::Second).surface;
  return mesh_of(surface, scene, share).report;
}

Surface surface_over(const char* x, const char* y, const char* z, const Domain& domain) {
  return surface_from_text(x, y, z, domain, {}, Order::Second);
}

TEST(Proofs, HoldForSurfacesThatAreSmooth) {
  const Domain around = {0, 2 * kPi, 0, 2 * kPi};
  const MeshReport torus =
      report_on(surface_over("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)", around));
  EXPECT_TRUE(torus.certified);
  EXPECT_LE(torus.boxes, 10U);
  // Bounds of these are wide in large boxes.
  const MeshReport ripple =
      report_on(surface_over("u", "v", "sin(9*sqrt(u^2+v^2+0.1))/9", {-2, 2, -2, 2}));
  EXPECT_TRUE(ripple.certified);
  EXPECT_GT(ripple.boxes, 100U);
}

TEST(Proofs, TakeThousandsOfBoxesForATubeAroundAKnot) {
  const MeshReport tube = report_on_gallery("trefoil-tube", 1e-3);
  EXPECT_TRUE(tube.certified);
  EXPECT_GT(tube.boxes, 2000U);
}

/// What bounds leave open in one place alone is narrowed down, there and nowhere else.
TEST(Proofs, FindPeaksThatNoSampleMeets) {
  for (const char* const z :
       {"exp(-1e7*((u-0.123)^2+(v+0.321)^2))", "exp(-1e8*((u-0.123)^2+(v+0.321)^2))",
        "-1/(1+1e9*((u-0.6)^2+v^2))"}) {
    const MeshResult found = try_mesh(height_field(z, {-1, 1, -1, 1}), within_share(1e-3)).value();
    EXPECT_GT(found.mesh.bounds.size().z, 0.99) << z;
    EXPECT_LE(found.report.max_error, found.report.tolerance) << z;
    EXPECT_LT(found.report.boxes, 6000U) << z;
  }
}

/// The height of each is 1, on a line or at a point that lies between all samples.
TEST(Proofs, FindRidgesAndPeaksOfAnyWidth) {
  for (const char* const z :
       {"exp(-((u-0.378522)/1e-4)^2)", "exp(-(((u-0.312)/1e-4)^2+((v-0.17)/1e-4)^2))",
        "exp(-((u-0.378522)/1e-6)^2)", "exp(-((u^2+v^2-0.5)/1e-6)^2)",
        "exp(-(((u-0.312)/1e-6)^2+((v-0.17)/1e-6)^2))", "min(1,abs(u-0.378522)/1e-3)"}) {
    const MeshResult found = try_mesh(height_field(z, {-1, 1, -1, 1}), within_share(1e-3)).value();
    const bool is_meshed = found.mesh.bounds.size().z > 0.99;
    const bool is_told = found.report.max_error > found.report.tolerance;
    EXPECT_TRUE(is_meshed || is_told) << z;
    EXPECT_FALSE(found.report.certified && is_told) << z;
  }
}

/// Second derivatives along a surface are large under polar parameters, and make no error.
TEST(Proofs, HoldWhereDerivativesAreLargeAlongTheSurface) {
  EXPECT_TRUE(
      report_on(surface_over("v*cos(u)", "v*sin(u)", "log(v)", {0, 2 * kPi, 1e-3, 1})).certified);
  for (const char* const name : {"boy", "kuen-log", "dini", "scherk-1", "bour"})
    EXPECT_TRUE(report_on_gallery(name, 1e-3).certified) << name;
}

/// Both sides are flat or waves without a place of their own on the line.
TEST(Proofs, HoldOnBothSidesOfJumpsAlongLinesOfParameters) {
  for (const char* const z : {"(v<0.1234?-1:1)*cos(u*v)", "u<0?u:2-u*u", "u<=0?v:3", "u>0.3?1+v:0"})
    EXPECT_TRUE(report_on(height_field(z, {-2, 2, -2, 2})).certified) << z;
}

/// The line u = 0 is farther from all triangles than 1000 tolerances. No halving mends that.
TEST(Proofs, DoNotHoldForALineOfItsOwnOnAJump) {
  for (const char* const z : {"sign(u)", "u<0?1:(u>0?2:7)"}) {
    const MeshReport report = report_on(height_field(z, {-2, 2, -2, 2}));
    EXPECT_FALSE(report.certified) << z;
    EXPECT_LT(report.cells, 1000U) << z;
    EXPECT_LT(report.boxes, 1000U) << z;
  }
}

TEST(Proofs, HoldAlongLinesOfEndlessDerivatives) {
  const MeshReport fold =
      report_on(surface_over("u", "v", "abs(u-0.1)^1.5+abs(v-0.3)^1.5", {-1, 1, -1, 1}));
  EXPECT_TRUE(fold.certified);
  EXPECT_LE(fold.boxes, 2500U);
}

/// A hole of two opposite quarters of a disc lies between all samples. The place at 2 - sqrt(2) of
/// the radius is deepest in it: sqrt(2) - 1 radii from its edge.
TEST(Proofs, FindHolesBetweenSamples) {
  constexpr dvec2 kMiddle(-0.5562, -0.2279);
  for (const double radius : {0.0135, 0.0145, 0.0155, 0.01663}) {
    const std::string z = "(hypot(u+0.5562,v+0.2279)<" + std::to_string(radius) +
                          "&&abs(v+0.2279)<abs(u+0.5562))?nan:0";
    const MeshResult found = try_mesh(height_field(z, {-1, 1, -1, 1}), within_share(1e-3)).value();
    const double depth = (std::sqrt(2) - 1) * radius;
    const dvec3 deepest(kMiddle.x + (2 - std::sqrt(2)) * radius, kMiddle.y, 0);
    const double off = depth - TriangleTree(found.mesh).distance(deepest);
    EXPECT_LE(off, std::max(1.02 * *found.report.tolerance, 1.1 * found.report.max_error)) << z;
    EXPECT_FALSE(found.report.certified) << z;
  }
}

/// A spire of radius exp(u) from z = -20 up: its end is 1e-9 of its size wide, yet no point.
TEST(Proofs, HoldForASpireThatIsMeshedToItsEnd) {
  const Domain domain{-20, 2, 0, 2 * kPi};
  const Surface spire =
      surface_from_text("exp(u)*cos(v)", "exp(u)*sin(v)", "u", domain, {}, Order::Second);
  const MeshResult result = try_mesh(spire, within_share(1e-3)).value();
  EXPECT_EQ(result.mesh.bounds.low.z, -20);
  EXPECT_EQ(topology(result.mesh).boundary_loops, 2U);
  EXPECT_TRUE(result.report.certified);
}

/// Farther down, triangles have no area in doubles.
TEST(Proofs, DoNotHoldForMeshesThatLackPartsWithoutArea) {
  for (const double end : {-60.0, -700.0}) {
    const Domain domain{end, 2, 0, 2 * kPi};
    const Surface spire =
        surface_from_text("exp(u)*cos(v)", "exp(u)*sin(v)", "u", domain, {}, Order::Second);
    const MeshResult result = try_mesh(spire, within_share(1e-3)).value();
    EXPECT_GT(result.mesh.bounds.low.z, end + 1);
    EXPECT_FALSE(result.report.certified) << end;
    EXPECT_LT(result.report.proved_fraction, 0.9) << end;
    // The rest of the spire is a needle: its end is as far away as it is long.
    const double missing = result.mesh.bounds.low.z - end;
    EXPECT_NEAR(result.report.max_error, missing, 1e-6 * missing) << end;
  }
}

}  // namespace
}  // namespace saddle
