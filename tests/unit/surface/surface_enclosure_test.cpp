#include "surface/surface_enclosure.h"

#include <gtest/gtest.h>

#include <span>

#include "surface_from_text.h"

namespace saddle {
namespace {

TEST(SurfaceEnclosure, BoundsPositionsAndTangentsInBothDirectionsOfARange) {
  const Surface surface = height_field("u^2*v");
  SurfaceEnclosure enclosure(surface, Bounded::Tangents);
  for (const ParameterBox& box : {ParameterBox{{0.5, -1}, {1, 1}}, {{1, 1}, {0.5, -1}}}) {
    const std::span<const Interval> bounds = enclosure.enclose(box);
    ASSERT_EQ(bounds.size(), 9U);
    EXPECT_TRUE(contains(bounds[2], 1) && contains(bounds[2], -1));
    EXPECT_TRUE(contains(bounds[5], 2) && contains(bounds[5], -2));  // z_u = 2 u v
    EXPECT_TRUE(contains(bounds[8], 0.25) && !contains(bounds[8], 0.2));
    EXPECT_TRUE(are_continuous(bounds));
  }
}

TEST(SurfaceEnclosure, TellsJumpsFromWhereTheSurfaceIsUndefined) {
  const ParameterBox around = {dvec2(-0.5), dvec2(0.5)};
  const ParameterBox left = {{-0.5, -0.5}, {-0.1, 0.5}};
  const Surface jump = height_field("floor(u)");
  SurfaceEnclosure of_jump(jump, Bounded::Position);
  EXPECT_FALSE(are_continuous(of_jump.enclose(around)));
  EXPECT_EQ(least_defined(of_jump.last()), Defined::Yes);
  EXPECT_TRUE(are_continuous(of_jump.enclose(left)));
  const Surface root = height_field("sqrt(u)");
  SurfaceEnclosure of_root(root, Bounded::Position);
  EXPECT_EQ(least_defined(of_root.enclose(around)), Defined::Maybe);
  EXPECT_EQ(least_defined(of_root.enclose(left)), Defined::No);
}

}  // namespace
}  // namespace saddle
