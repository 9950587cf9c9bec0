// Boxes in which bounds do not exclude a jump.
#include "mesh/proof/jump_search.h"

#include <gtest/gtest.h>

#include <vector>

#include "surface_from_text.h"

namespace saddle {
namespace {

/// Boxes of [0, 1] x [0, 1], 32 each way.
std::vector<JumpBox> boxes_of_square(double least) {
  constexpr int kEachWay = 32;
  std::vector<JumpBox> boxes;
  for (int j = 0; j < kEachWay; ++j) {
    for (int i = 0; i < kEachWay; ++i) {
      const dvec2 low = dvec2(i, j) / double{kEachWay};
      boxes.push_back({{low, low + 1.0 / kEachWay}, least});
    }
  }
  return boxes;
}

std::vector<std::size_t> search(const char* z, const std::vector<JumpBox>& boxes,
                                unsigned threads = 1, double share = 1) {
  const Surface surface = height_field(z);
  ProofBudget budget(surface.bounds, share);
  return find_may_jump(surface, boxes, budget, threads);
}

TEST(JumpSearch, FindsTheBoxesOnALineOfJumps) {
  const std::vector<JumpBox> boxes = boxes_of_square(0.01);
  std::vector<std::size_t> expected;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const ParameterBox& box = boxes[k].box;
    if (box.low.x <= 0.3 && 0.3 <= box.high.x) expected.push_back(k);
  }
  EXPECT_EQ(search("sign(u-0.3)", boxes), expected);
  EXPECT_EQ(search("sign(u-0.3)", boxes, 3), expected) << "on several threads";
}

TEST(JumpSearch, FindsNothingWhereTheSurfaceIsContinuous) {
  for (const char* z : {"u*v", "abs(u-0.3)", "sin(40*u)*sqrt(v)", "max(u,v)"})
    EXPECT_TRUE(search(z, boxes_of_square(0.01)).empty()) << z;
}

TEST(JumpSearch, LeavesOutWhatIsTooSmallOrUndefined) {
  EXPECT_TRUE(search("0.001*sign(u-0.3)", boxes_of_square(0.01)).empty()) << "less than counts";
  EXPECT_TRUE(search("1/(u-0.3)", boxes_of_square(0.01)).empty()) << "undefined at its pole";
  EXPECT_TRUE(search("floor(u)+sqrt(-1-v)", boxes_of_square(0.01)).empty()) << "nowhere defined";
}

TEST(JumpSearch, TellsTheCellsOfALineByFewBoxes) {
  std::vector<double> lines;
  for (int k = 0; k <= 400; ++k) lines.push_back(k / 400.0);
  const Surface surface = height_field("floor(v-0.7232)");
  ProofBudget budget(surface.bounds);
  const std::vector<std::uint8_t> cells = cells_that_may_jump(surface, {lines, lines}, budget);
  ASSERT_EQ(cells.size(), 400U * 400U);
  for (std::size_t k = 0; k < cells.size(); ++k) ASSERT_EQ(cells[k], k / 400 == 289 ? 1 : 0) << k;
  EXPECT_LT(budget.boxes(), 3000U);
}

TEST(JumpSearch, EndsWithItsBudget) {
  EXPECT_TRUE(search("sign(u-0.3)", boxes_of_square(0.01), 1, 0).empty());
}

}  // namespace
}  // namespace saddle
