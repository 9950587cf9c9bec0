#include "study/measurement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "study/chart.h"
#include "study/study.h"

namespace saddle {
namespace {

Measurement point(double milliseconds, double error, StudyPanel panel = StudyPanel::Mesh) {
  Measurement m;
  m.panel = panel;
  m.method = "m";
  m.setting = "s";
  m.time = {milliseconds, milliseconds, milliseconds};
  m.error = error;
  m.unit = "px";
  return m;
}

std::vector<bool> fronts(std::vector<Measurement> measurements) {
  mark_pareto(measurements);
  std::vector<bool> result;
  for (const Measurement& m : measurements) result.push_back(m.pareto);
  return result;
}

TEST(Together, SumsTimesAndTakesTheLargestErrorOfWhatAllSurfacesHave) {
  Measurement slow = point(3, 0.5);
  slow.setting = "0.5 px";
  slow.triangles = 100;
  slow.is_choice = true;
  Measurement quick = slow;
  quick.time = {1, 1, 1};
  quick.error = 0.25;
  quick.triangles = 20;
  quick.no_answer = true;
  const Measurement alone = point(1, 1, StudyPanel::Image);
  const std::vector<Measurement> both = together({{slow, alone}, {quick}});
  ASSERT_EQ(both.size(), 1U);
  EXPECT_EQ(both[0].time.median, 4);
  EXPECT_EQ(both[0].error, 0.5);
  EXPECT_EQ(both[0].triangles, 120U);
  EXPECT_TRUE(both[0].is_choice && both[0].no_answer && both[0].pareto);
  EXPECT_EQ(together({{alone}}).size(), 1U);
}

TEST(PanelProgress, GoesForwardWithEachSettingAndEndsBeforeTheNextPanel) {
  std::vector<double> shares;
  std::string last;
  const StudyProgress record = [&](double share, const std::string& what) {
    shares.push_back(share);
    last = what;
  };
  PanelProgress progress(record, 3);
  EXPECT_EQ(last, "the truth");
  for (const char* setting : {"1x1", "2x2", "3x3"}) progress.next("uniform", setting);
  EXPECT_EQ(last, "uniform, 3x3");
  ASSERT_EQ(shares.size(), 4);
  EXPECT_EQ(shares.front(), 0);
  EXPECT_TRUE(std::ranges::is_sorted(shares, std::less_equal<>{}));
  EXPECT_LT(shares.back(), 1);
}

TEST(ParetoFront, IsWhatNothingBeatsInBothTimeAndError) {
  EXPECT_EQ(fronts({point(1, 9), point(2, 9), point(3, 4), point(4, 5), point(9, 1)}),
            (std::vector{true, false, true, false, true}));
}

TEST(ParetoFront, HoldsEqualsAndLooksAtEachPanelAlone) {
  EXPECT_EQ(fronts({point(1, 1), point(1, 1), point(2, 2, StudyPanel::Image)}),
            (std::vector{true, true, true}));
}

TEST(ParetoFront, LeavesLimitsOutAndIsNotBeatenByThem) {
  std::vector<Measurement> points = {point(1, 1), point(0.1, 0.1)};
  points[1].is_limit = true;
  EXPECT_EQ(fronts(points), (std::vector{true, false}));
}

TEST(ChartTable, HasARowForEachMeasurement) {
  std::vector<Measurement> rows = {point(1.5, 0.25), point(2, 3, StudyPanel::Normals)};
  rows[0].promise = 0.5;
  rows[0].triangles = 12;
  rows[0].pareto = true;
  std::ostringstream out;
  write_csv(out, rows);
  EXPECT_EQ(out.str(),
            "panel,method,setting,milliseconds,error,unit,promise,triangles,pareto\n"
            "mesh,m,s,1.5,0.25,px,0.5,12,1\n"
            "normals,m,s,2,3,px,,,0\n");
}

TEST(RepeatedTiming, IsAMedianBetweenItsQuartiles) {
  int runs = 0;
  const Timing time = time_repeatedly([&runs] { ++runs; });
  EXPECT_GE(runs, 9);
  EXPECT_LE(time.low, time.median);
  EXPECT_LE(time.median, time.high);
}

}  // namespace
}  // namespace saddle
