// Identities of gallery surfaces with other parameters than their own; those of the surfaces as
// they are stand in table.cpp.
#include "geometry/gallery/forms.h"

namespace saddle {
namespace {

TEST(Gallery, MinimalSurfacesHaveNoMeanCurvatureWhateverTheirParameters) {
  expect_minimal(scene_of("catenoid", {"c=0.4"}));
  expect_minimal(scene_of("helicoid", {"h=2"}));
  expect_minimal(scene_of("catenoid-helicoid", {"t=0.7"}));
  expect_minimal(scene_of("enneper-polar", {"n=2"}));
}

TEST(Gallery, CurvaturesFollowParameters) {
  expect_gauss_curvature(scene_of("pseudosphere", {"a=2"}), -0.25);
  expect_gauss_curvature(scene_of("dini", {"b=0.5"}), -1 / 1.25);
  expect_gauss_curvature(scene_of("sphere", {"r=2"}), 0.25);
}

TEST(Gallery, TangentsOfATractrixAreAllOfOneLengthUpToItsAxis) {
  // Tractrix: the tangent from the curve to its axis has length a = 1.
  for (const SurfacePoint& p : sample(scene_of("pseudosphere"), 16).points) {
    const double radius = std::hypot(p.position.x, p.position.y);
    const double along = std::hypot(p.r_v.x, p.r_v.y);
    EXPECT_NEAR(radius * glm::length(p.r_v), along, 64 * kEpsilon);
  }
}

}  // namespace
}  // namespace saddle
