// Surfaces of any size and place: products that would overflow, and rounding above the tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/mesher/mesher.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshResult mesh_of_torus(const std::string& scale, const std::string& offset) {
  const Surface surface =
      surface_from_text("c+s*(2+cos(v))*cos(u)", "s*(2+cos(v))*sin(u)", "s*sin(v)",
                        {0, 2 * kPi, 0, 2 * kPi}, {{"s", scale}, {"c", offset}}, Order::Second);
  return make_mesh(surface, within_share(1e-3), {{60, 60, 16, 16, 0}, 1e-3, {}});
}

TEST(Scales, HaveTheNormalsOfATorus) {
  for (const char* scale : {"1e-300", "1e-153", "1e-100", "1e100", "1e104", "1e150", "1e300"}) {
    const MeshResult result = mesh_of_torus(scale, "0");
    EXPECT_FALSE(result.report.oscillates) << scale;
    EXPECT_LE(result.report.max_error, 1e-3 * result.mesh.bounds.diagonal()) << scale;
    for (std::size_t k = 0; k < result.mesh.normal.size(); ++k) {
      const dvec2 uv = result.mesh.uv[k];
      const dvec3 exact(std::cos(uv.x) * std::cos(uv.y), std::sin(uv.x) * std::cos(uv.y),
                        std::sin(uv.y));
      // Derivatives round by some of a double's 16 digits.
      ASSERT_LT(glm::distance(result.mesh.normal[k], exact), 1e-12) << scale;
    }
  }
}

TEST(Scales, TellTheRoundingOfLargeCoordinates) {
  // Doubles between 2^46 and 2^47 are 2^-6 apart, so that the mesh is off by half of that at least.
  const MeshResult far = mesh_of_torus("1", "1e14");
  EXPECT_GT(far.report.max_error, 0x1p-7);
  EXPECT_GT(far.report.max_error, *far.report.tolerance);
  EXPECT_TRUE(far.report.rounding);
  EXPECT_LT(far.mesh.triangles.size(), 10'000U) << "no refinement of rounding";
  EXPECT_LT(far.report.evaluations, 500'000U);
  const MeshResult farther = mesh_of_torus("1", "1e15");
  EXPECT_GT(farther.report.max_error, 0x1p-4);  // half of the distance of doubles there
  EXPECT_TRUE(farther.report.rounding);
  EXPECT_LT(farther.report.evaluations, 500'000U);
  EXPECT_FALSE(mesh_of_torus("1", "1e12").report.rounding);
}

TEST(Scales, OfATinyToleranceLeaveNothingOut) {
  const Surface sphere = surface_from_text("cos(v)*cos(u)", "cos(v)*sin(u)", "sin(v)",
                                           {0, 2 * kPi, -kPi / 2, kPi / 2}, {}, Order::Second);
  MeshRequest request = within_share(1e-9);
  request.max_triangles = 100'000;
  const MeshResult result = try_mesh(sphere, request).value();
  EXPECT_EQ(result.report.undefined_fraction, 0);
  EXPECT_GT(result.report.max_error, *result.report.tolerance) << "the limit is told";
  EXPECT_EQ(euler_number(result.mesh), 2);
}

}  // namespace
}  // namespace saddle
