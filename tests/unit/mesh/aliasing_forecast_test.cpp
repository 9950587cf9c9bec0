#include "mesh/sizing/aliasing_forecast.h"

#include <limits>

#include <gtest/gtest.h>

namespace saddle {
namespace {

/// A forecast from 3 x 3 samples, of which those in `steep` have large errors, and those in
/// `undefined` none.
AliasingForecast forecast_of(const std::vector<int>& steep, const std::vector<int>& undefined) {
  LinearizationErrors errors{{0, 1, 2}, {0, 1, 2}, std::vector<dvec2>(9, dvec2(0))};
  for (const int k : steep) errors.values[static_cast<std::size_t>(k)] = dvec2(1e4, 0);
  for (const int k : undefined) {
    errors.values[static_cast<std::size_t>(k)] = dvec2(std::numeric_limits<double>::quiet_NaN());
  }
  return AliasingForecast(errors);
}

TEST(AliasingForecast, SeesWavesThatFillAnArea) {
  EXPECT_TRUE(forecast_of({0, 1, 2, 3, 4}, {}).at({1, 1}).x);
  EXPECT_FALSE(forecast_of({0, 1, 2, 3, 4}, {}).at({1, 1}).y);
  EXPECT_TRUE(forecast_of({0, 2, 4, 6, 8}, {1, 3, 5, 7}).at({1, 1}).x) << "defined in places";
  EXPECT_TRUE(forecast_of({0, 4, 8}, {1, 2, 3, 5, 6, 7}).at({1, 1}).x) << "in few";
}

TEST(AliasingForecast, TakesNoSteepBoundaryForWaves) {
  EXPECT_FALSE(forecast_of({0, 1, 2}, {}).at({1, 1}).x) << "a line";
  EXPECT_FALSE(forecast_of({0}, {1, 2, 3, 4, 5, 6, 7, 8}).any()) << "one of one";
  EXPECT_FALSE(forecast_of({1, 4}, {0, 2, 5, 7, 8}).at({1, 1}).x) << "two of four";
}

}  // namespace
}  // namespace saddle
