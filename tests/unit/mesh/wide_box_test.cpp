// Boxes of floats are around the boxes of doubles that they stand for, at numbers of any size.
#include "mesh/model/wide_box.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "base/random.h"

namespace saddle {
namespace {

void expect_around(const Bounds& box) {
  const Bounds wide = WideBox(box).bounds();
  EXPECT_TRUE(glm::all(glm::lessThan(wide.low, box.low))) << box.low.x;
  EXPECT_TRUE(glm::all(glm::greaterThan(wide.high, box.high))) << box.high.x;
}

TEST(WideBox, IsAround) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const auto random = [k](std::uint64_t i) { return 4 * random_unit(6 * k + i) - 2; };
    const dvec3 a(random(0), random(1), random(2));
    const dvec3 b(random(3), random(4), random(5));
    for (const double scale : {0.0, 1e-300, 1e-42, 1e-38, 1e-6, 1.0, 1e6, 1e38, 1e39, 1e300})
      expect_around({scale * glm::min(a, b), scale * glm::max(a, b)});
  }
}

TEST(WideBox, IsHardlyWider) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const double x = 1 + random_unit(k);
    const dvec3 size = WideBox({dvec3(x), dvec3(x)}).bounds().size();
    EXPECT_LE(size.x, 4 * double{std::numeric_limits<float>::epsilon()} * x);
  }
}

}  // namespace
}  // namespace saddle
