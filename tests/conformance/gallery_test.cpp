// Positions and normals of the gallery against 50 digits. `./dev accuracy` does the same at many
// more points, and prints a table.
#include "conformance/gallery_accuracy.h"

#include <gtest/gtest.h>

namespace saddle::testing {
namespace {

constexpr int kPoints = 8;
constexpr std::uint64_t kSeed = 1;

/// In last places of the surface's largest coordinate. Formulas of the gallery are some ten
/// operations deep, of which few are as large as that.
constexpr double kPositionUlps = 4;

/// A rounding of 1e-16 radians is 6e-15 degrees; what is left is for formulas that cancel.
constexpr double kNormalDegrees = 1e-9;

TEST(GalleryAccuracy, PositionsAreWithinLastPlacesAndNormalsWithinNanodegrees) {
  for (const GalleryEntry& entry : gallery()) {
    SCOPED_TRACE(entry.name);
    const GalleryAccuracy accuracy = measure_accuracy(entry, kPoints, kSeed);
    EXPECT_EQ(accuracy.points, kPoints);
    EXPECT_EQ(accuracy.normals, kPoints);
    // Past it only as far as rounding takes the formula as it is written.
    EXPECT_TRUE(accuracy.box_ulps <= kPositionUlps || accuracy.rounding <= 1)
        << accuracy.box_ulps << " " << accuracy.rounding;
    EXPECT_LE(accuracy.rounding, 1);
    EXPECT_LE(accuracy.normal_rounding, 1);
    EXPECT_LE(accuracy.degrees, kNormalDegrees);
  }
}

}  // namespace
}  // namespace saddle::testing
