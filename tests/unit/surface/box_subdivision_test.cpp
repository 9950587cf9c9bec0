#include "surface/box_subdivision.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace saddle {
namespace {

constexpr ParameterBox kUnit = {dvec2(0), dvec2(1)};

bool holds(const ParameterBox& box, const dvec2& uv) {
  return box.low.x <= uv.x && uv.x <= box.high.x && box.low.y <= uv.y && uv.y <= box.high.y;
}

/// Open as long as a box holds a point.
auto holding(const dvec2& uv) {
  return [uv](const ParameterBox& box) {
    return holds(box, uv) ? ProofOutcome::Open : ProofOutcome::Proved;
  };
}

double area_of_all(const std::vector<ParameterBox>& boxes) {
  double area = 0;
  for (const ParameterBox& box : boxes) area += box.size().x * box.size().y;
  return area;
}

TEST(BoxSubdivision, NarrowsAPointDownToTheHalvingsThatItMayTake) {
  const dvec2 point(0.3, 0.7);
  const auto search = subdivide(kUnit, {.boxes = 1000, .halvings = 20}, holding(point));
  EXPECT_EQ(search.depth(), 20);
  ASSERT_EQ(search.open().size(), 2U);  // the halves of the last box are not tested
  const dvec2 size = search.open()[0].size();
  EXPECT_EQ(size, dvec2(0x1p-10));
  EXPECT_TRUE(holds(search.open()[0], point) != holds(search.open()[1], point));
}

TEST(BoxSubdivision, TestsEachLevelInOrderBeforeTheNext) {
  std::vector<ParameterBox> tested;
  (void)subdivide(kUnit, {.boxes = 7}, [&](const ParameterBox& box) {
    tested.push_back(box);
    return ProofOutcome::Open;
  });
  ASSERT_EQ(tested.size(), 7U);
  EXPECT_EQ(tested[1].high, dvec2(0.5, 1));  // u first
  EXPECT_EQ(tested[2].low, dvec2(0.5, 0));
  const std::array<dvec2, 4> quarters = {dvec2(0, 0), dvec2(0, 0.5), dvec2(0.5, 0),
                                         dvec2(0.5, 0.5)};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(tested[3 + k].low, quarters[k]);
}

TEST(BoxSubdivision, LosesNoBoxWhenItsBudgetEndsWithinALevel) {
  const auto open = [](const ParameterBox&) { return ProofOutcome::Open; };
  EXPECT_EQ(area_of_all(subdivide(kUnit, {.boxes = 6}, open).open()), 1);
  EXPECT_EQ(area_of_all(subdivide(kUnit, {.boxes = 7}, open).open()), 1);
  const auto proved = [](const ParameterBox&) { return ProofOutcome::Proved; };
  EXPECT_TRUE(subdivide(kUnit, {.boxes = 1}, proved).open().empty());
  EXPECT_FALSE(subdivide(kUnit, {.boxes = 0}, proved).open().empty());
}

TEST(BoxSubdivision, EndsBeforeItsHalvingsWhereTooManyBoxesAreOpen) {
  const auto on_line = [](const ParameterBox& box) {
    return box.low.x <= 0.3 && 0.3 <= box.high.x ? ProofOutcome::Open : ProofOutcome::Proved;
  };
  const SubdivisionLimits limits = {.boxes = 100000, .halvings = 40, .most_open = 64};
  EXPECT_LT(subdivide(kUnit, limits, on_line).depth(), 40);
}

TEST(BoxSubdivision, KeepsABoxWholeThatHasNoDoublesBetweenItsSides) {
  const ParameterBox narrow = {{1, 0}, {1 + 0x1p-52, 1}};
  BoxSubdivision<ParameterBox> search({narrow});
  search.halve(0, AtLastDigit::Keep);
  EXPECT_EQ(search.open().size(), 1U);
  search.halve(0, AtLastDigit::Halve);
  EXPECT_EQ(search.open().size(), 2U);
}

TEST(BoxSubdivision, KeepsWhatAPartHasBesideItsBox) {
  struct Part {
    ParameterBox box;
    int number;
  };
  BoxSubdivision<Part> search({{kUnit, 4}, {kUnit, 5}});
  search.test([](const Part& part) {
    return part.number == 5 ? ProofOutcome::Open : ProofOutcome::Refuted;
  });
  search.halve_in_turn();
  ASSERT_EQ(search.open().size(), 2U);
  EXPECT_EQ(search.open()[1].number, 5);
  EXPECT_EQ(search.open()[1].box.low, dvec2(0.5, 0));
}

TEST(BoxSubdivision, GoesAlongARangeThatRunsBackwards) {
  const std::array<ParameterBox, 2> halves = halves_of({{1, 0}, {-1, 2}}, 0);
  EXPECT_EQ(halves[0].high, dvec2(0, 2));
  EXPECT_EQ(halves[1].low, dvec2(0, 0));
  EXPECT_EQ(halves[1].high, dvec2(-1, 2));
}

}  // namespace
}  // namespace saddle
