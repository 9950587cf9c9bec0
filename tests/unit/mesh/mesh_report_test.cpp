// Which of many singular points a report lists.
#include "mesh/model/mesh_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

TEST(SingularPoints, OfBothLinesAreListedWhereOneWouldFillTheList) {
  constexpr std::size_t kOnEach = 4 * kMaxListed;
  MeshReport report;
  for (const double v : {-1.0, 1.0}) {
    for (std::size_t k = 0; k < kOnEach; ++k) {
      add_singular_point({double(k), v}, report);
    }
  }
  EXPECT_EQ(report.singular_point_count, 2 * kOnEach);
  EXPECT_LE(report.singular_points.size(), kMaxListed);
  const auto on_first = std::ranges::count_if(
      report.singular_points, [](const SingularPoint& point) { return point.uv.y < 0; });
  EXPECT_EQ(2 * on_first, std::ssize(report.singular_points));
}

TEST(SingularPoints, WithoutALimitStayInTheList) {
  MeshReport report;
  for (std::size_t k = 0; k < 4 * kMaxListed; ++k) {
    add_singular_point({double(k), 0}, report);
    if (k == 1) mark_without_limit(report);
  }
  const auto is_known = [](const SingularPoint& point) {
    return point.uv.x == 1 && !point.has_limit;
  };
  EXPECT_TRUE(std::ranges::any_of(report.singular_points, is_known));
}

}  // namespace
}  // namespace saddle
