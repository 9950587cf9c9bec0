#include "mesh/features/way_out.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/numbers.h"
#include "mesh/model/tolerances.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

const Bounds kBelowHalf{dvec3(-kInfinity), dvec3(kInfinity, kInfinity, 0.5)};

/// Looks along a way until it ends. Returns how many places that took.
int look_along(const Surface& surface, WayOut& way) {
  for (int looks = 1;; ++looks) {
    const dvec2 place = way.next();
    const dvec3 position = evaluate_positions(surface, std::array{place}, 1)[0];
    if (way.narrow(place, position)) return looks;
  }
}

double height_at(const Surface& surface, const dvec2& uv) {
  return evaluate_positions(surface, std::array{uv}, 1)[0].z;
}

TEST(WayOut, EndsAtTheLastDoubleBeforeAFace) {
  for (const char* const z : {"u", "u^3", "exp(u)-1", "0.6-0.1/u", "ln(u)+1"}) {
    const Surface surface = height_field(z);
    WayOut way({dvec2(0.1, 0), dvec2(3, 0)}, kHalvingsToLeast, kBelowHalf);
    const int looks = look_along(surface, way);
    const double last = way.last_seen().x;
    EXPECT_LE(height_at(surface, {last, 0}), 0.5) << z;
    EXPECT_GT(height_at(surface, {std::nextafter(last, 3), 0}), 0.5) << z;
    EXPECT_LT(looks, 20) << z;  // 54 halvings
  }
}

TEST(WayOut, EndsInAFewPlacesWhereItBeginsAtAFace) {
  const Surface surface = height_field("u");
  WayOut way({dvec2(0.5, 0), dvec2(3, 0)}, kHalvingsToLeast, kBelowHalf);
  EXPECT_LT(look_along(surface, way), 12);
  EXPECT_EQ(way.last_seen().x, 0.5);
}

TEST(WayOut, LosesFourHalvingsAtMostWhereAChordMisleads) {
  const Surface surface = height_field("1e-9*u+(u>2.7?1e9*(u-2.7):0)");
  WayOut way({dvec2(0.1, 0), dvec2(3, 0)}, 24, kBelowHalf);
  EXPECT_LE(look_along(surface, way), 24);
  EXPECT_LE(way.last_seen().x, 2.7);
  EXPECT_GT(way.last_seen().x, 2.7 - 3 * 0x1p-20);
}

TEST(WayOut, HalvesToWhereTheSurfaceIsUndefined) {
  const Surface surface = height_field("sqrt(0.7-u)");
  WayOut way({dvec2(0, 0), dvec2(1, 0)}, kHalvingsToLeast, Bounds{dvec3(-9), dvec3(9)});
  look_along(surface, way);
  EXPECT_TRUE(std::isfinite(height_at(surface, way.last_seen())));
  EXPECT_TRUE(std::isnan(height_at(surface, {std::nextafter(way.last_seen().x, 1), 0})));
}

TEST(WayOut, StaysWhereTheFirstEndIsNotSeen) {
  const Surface surface = height_field("u");
  WayOut way({dvec2(1, 0), dvec2(3, 0)}, kHalvingsToLeast, kBelowHalf);
  look_along(surface, way);
  EXPECT_EQ(way.last_seen().x, 1);
}

}  // namespace
}  // namespace saddle
