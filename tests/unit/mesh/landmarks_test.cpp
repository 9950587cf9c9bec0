// Small features are found by interval bounds, whatever their size.
#include "mesh/proof/landmarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/format.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

Landmarks landmarks(const std::string& z) {
  return find_landmarks(height_field(z), 1);
}

std::string number(double value) {
  return formatted("%.17g", value);
}

std::size_t count_at(const Landmarks& landmarks, double height) {
  return static_cast<std::size_t>(std::ranges::count_if(
      landmarks.places, [&](const Landmark& l) { return l.position.z == height; }));
}

TEST(Landmarks, AreNoneOfSmoothSurfaces) {
  for (const char* const z : {"u*v", "sin(9*u)*cos(7*v)", "exp(-u^2-v^2)", "hypot(u,v)", "abs(u)"})
    EXPECT_TRUE(landmarks(z).places.empty()) << z;
}

TEST(Landmarks, LieOnBothSidesOfJumpsOfAnySize) {
  for (const double radius : {0.7, 0.3, 0.03, 1e-3, 1e-4, 1e-5}) {
    const Landmarks found = landmarks("(hypot(u-0.123,v+0.077)<" + number(radius) + ")?1:0");
    EXPECT_GE(count_at(found, 1), 1U) << radius;
    EXPECT_GE(count_at(found, 0), 1U) << radius;
    EXPECT_GE(found.highest_step, 1) << radius;
    EXPECT_FALSE(found.has_boundary) << radius;
  }
}

TEST(Landmarks, LieInIslandsOfAnySize) {
  for (const double radius : {0.3, 1e-2, 1e-4, 1e-5}) {
    const Landmarks found = landmarks("(hypot(u-0.123,v+0.077)<" + number(radius) + ")?2:nan");
    EXPECT_GE(count_at(found, 2), 1U) << radius;
    EXPECT_TRUE(found.has_boundary) << radius;
  }
}

TEST(Landmarks, LieInHolesOfAnySize) {
  for (const double radius : {0.3, 1e-2, 1e-4, 1e-5}) {
    const Landmarks found = landmarks("sqrt(hypot(u-0.123,v+0.077)-" + number(radius) + ")");
    EXPECT_TRUE(std::ranges::any_of(found.places, &Landmark::is_hole)) << radius;
    for (const Landmark& l : found.places)
      EXPECT_EQ(l.is_hole(), std::hypot(l.uv.x - 0.123, l.uv.y + 0.077) < radius) << radius;
  }
}

TEST(Landmarks, LieInNarrowSlots) {
  for (const char* const z :
       {"(abs(u-0.3)<1e-5)?1:0", "(abs(u-v/3-0.2)<1e-5)?1:0", "(abs(hypot(u,v)-0.6)<1e-4)?1:0"}) {
    EXPECT_GE(count_at(landmarks(z), 1), 10U) << z;
  }
}

TEST(Landmarks, TellHowDeepHolesAre) {
  // Half of the width of slots in any direction, the radius of discs.
  for (const double depth : {4.714e-4, 1e-3, 3e-3, 2e-2}) {
    for (const char* const hole :
         {"abs(v-0.18015)", "abs(u+v/5-0.18015)/sqrt(1.04)", "abs(v-0.7*u-0.2)/sqrt(1.49)",
          "abs(u+v-0.1)/sqrt(2)", "hypot(u-0.3,v+0.111)"}) {
      const std::string z = "(" + std::string(hole) + "<" + number(depth) + ")?nan:0";
      double deepest = 0;
      for (const Landmark& l : landmarks(z).places) {
        if (l.is_hole())
          deepest = std::max(deepest, depth_of(l.rim, dvec3(1, 0, 0), dvec3(0, 1, 0)));
      }
      EXPECT_GE(deepest, 0.9 * depth) << z;
      EXPECT_LE(deepest, 1.01 * depth) << z;
    }
  }
}

TEST(Landmarks, OfHolesEndAtTheNearestEdges) {
  for (const Landmark& l : landmarks("(abs(u-0.2)<1e-3||abs(u-0.203)<1e-3)?nan:0").places) {
    if (!l.is_hole()) continue;
    EXPECT_LE(depth_of(l.rim, dvec3(1, 0, 0), dvec3(0, 1, 0)), 1.01e-3) << l.uv.x << ' ' << l.uv.y;
  }
}

TEST(Landmarks, OfASmallDiscAreFoundBesideACurve) {
  for (const char* const z : {"((u-0.4)^2+(v-0.3)^2<1e-6)?2:((u>v/3-0.2)?1:0)",
                              "((u-0.4)^2+(v-0.3)^2<1e-6)?2:((abs(u-v/3+0.2)<1e-5)?1:0)"}) {
    EXPECT_GE(count_at(landmarks(z), 2), 1U) << z;
  }
}

}  // namespace
}  // namespace saddle
