#include "mesh/features/bisect_together.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "mesh/features/approach.h"
#include "mesh/model/tolerances.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// A line along u and the z that it is to be cut at.
struct Cut {
  Line line;
  double z;
  int rounds = 0;
};

bool narrow(Cut& cut, const dvec2& middle, const SurfacePoint& point) {
  ++cut.rounds;
  cut.line[point.position.z < cut.z ? 0 : 1] = middle;
  return has_no_middle(cut.line);
}

dvec2 next(const Cut& cut) {
  return middle_of(cut.line);
}

TEST(BisectTogether, NarrowsEachLineToNeighboursAroundItsOwnPlace) {
  const Surface surface = height_field("u^3");
  std::vector<Cut> cuts;
  for (const double z : {0.001, 0.125, 0.7}) cuts.push_back({{dvec2(0, 0.2), dvec2(1, 0.2)}, z});
  std::vector<std::size_t> open = all_open(cuts.size());
  bisect_together(surface, cuts, open, {kHalvingsToLeast, 1}, next, narrow);
  EXPECT_TRUE(open.empty());
  for (const Cut& cut : cuts) {
    EXPECT_EQ(std::nextafter(cut.line[0].x, 1), cut.line[1].x);
    EXPECT_NEAR(cut.line[1].x, std::cbrt(cut.z), 1e-15);
    EXPECT_EQ(cut.line[0].y, 0.2);
  }
}

TEST(BisectTogether, LeavesTheLinesThatHaveRoundsLeftOpen) {
  const Surface surface = height_field("u");
  std::vector<Cut> cuts = {{{dvec2(0), dvec2(1, 0)}, 0.3}, {{dvec2(0), dvec2(0x1p-1074, 0)}, 0}};
  std::vector<std::size_t> open = all_open(cuts.size());
  bisect_together(surface, cuts, open, {10, 1}, next, narrow);
  EXPECT_EQ(open, std::vector<std::size_t>{0});
  EXPECT_EQ(cuts[0].rounds, 10);
  EXPECT_EQ(cuts[1].rounds, 1);
  EXPECT_EQ(cuts[0].line[1].x - cuts[0].line[0].x, 0x1p-10);
  bisect_together(surface, cuts, open, {5, 1}, next, narrow);
  EXPECT_EQ(cuts[0].rounds, 15);
  EXPECT_EQ(cuts[1].rounds, 1);
}

TEST(BisectTogether, FindsTheLastDefinedPlaceOfManyLines) {
  const Surface surface = height_field("sqrt(u-v)");
  std::vector<Line> lines;
  for (const double v : {-0.7, 0.1, 0.6}) lines.push_back({dvec2(1, v), dvec2(-1, v)});
  const std::vector<dvec2> last = last_defined(surface, lines, kAllHalvings, 1);
  for (std::size_t k = 0; k < lines.size(); ++k) EXPECT_EQ(last[k], dvec2(lines[k][0].y));
}

/// No number of halvings comes to 0, whose neighbours are 5e-324.
TEST(BisectTogether, FindsAnEndAtZeroItself) {
  const Surface surface = height_field("sqrt(u)");
  const std::vector<Line> lines = {{dvec2(0.7, 0.1), dvec2(-0.3, 0.2)},
                                   {dvec2(1, -0.4), dvec2(-1, -0.4)}};
  const std::vector<dvec2> last = last_defined(surface, lines, kAllHalvings, 1);
  EXPECT_EQ(last[0].x, 0);
  EXPECT_NEAR(last[0].y, 0.17, 1e-15);
  EXPECT_EQ(last[1], dvec2(0, -0.4));
}

}  // namespace
}  // namespace saddle
