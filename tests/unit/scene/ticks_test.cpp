#include "scene/model/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace saddle {
namespace {

std::vector<double> values(const Ticks& all) {
  std::vector<double> result;
  for (const Tick& tick : all.ticks) result.push_back(tick.value);
  return result;
}

std::string texts(const Ticks& all) {
  std::string result;
  for (const Tick& tick : all.ticks) result += (result.empty() ? "" : " ") + tick.text;
  return result;
}

TEST(Ticks, AreRoundNumbersWithinTheRange) {
  EXPECT_EQ(values(ticks(0, 10, 5)), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(values(ticks(-1, 1, 4)), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  EXPECT_EQ(values(ticks(100, 104, 5)), (std::vector<double>{100, 101, 102, 103, 104}));
  EXPECT_EQ(values(ticks(0.1, 0.9, 4)), (std::vector<double>{0.2, 0.4, 0.6, 0.8}));
}

TEST(Ticks, AreAboutAsManyAsAskedForWhateverTheRange) {
  for (double length = 1e-12; length < 1e12; length *= 1.7) {
    for (const int count : {1, 3, 5, 8}) {
      const auto n = static_cast<int>(ticks(-length / 3, length, count).ticks.size());
      EXPECT_LE(n, count * 4 / 3 + 2) << length;
      EXPECT_GE(n, count / 3) << length;
    }
  }
}

TEST(Ticks, HaveNoMoreDigitsThanTheirStepAndARealMinusSign) {
  EXPECT_EQ(texts(ticks(-0.6, 0.6, 6)), "\u22120.6 \u22120.4 \u22120.2 0.0 0.2 0.4 0.6");
  EXPECT_EQ(texts(ticks(0, 1, 2)), "0.0 0.5 1.0");
  EXPECT_EQ(texts(ticks(0, 3, 3)), "0 1 2 3");
  EXPECT_EQ(texts(ticks(0, 20000, 2)), "0 10000 20000");
  EXPECT_EQ(ticks(0, 3, 3).note, "");
}

TEST(Ticks, TakeAPowerOfTenOutOfLargeAndSmallNumbers) {
  const Ticks large = ticks(0, 4e6, 4);
  EXPECT_EQ(texts(large), "0 1 2 3 4");
  EXPECT_EQ(large.note, "\u00d710\u2076");
  const Ticks small = ticks(-2e-5, 2e-5, 4);
  EXPECT_EQ(texts(small), "\u22122 \u22121 0 1 2");
  EXPECT_EQ(small.note, "\u00d710\u207b\u2075");
  const Ticks tiny = ticks(0, 1e-300, 5);
  EXPECT_EQ(tiny.note, "\u00d710\u207b\u00b3\u2070\u2070");
  EXPECT_EQ(tiny.ticks.front().text, "0.0");
}

TEST(Ticks, TakeOutWhatNumbersThatAreCloseTogetherShare) {
  const Ticks shifted = ticks(1e7, 1e7 + 1, 5);
  EXPECT_EQ(texts(shifted), "0.0 0.2 0.4 0.6 0.8 1.0");
  EXPECT_EQ(shifted.note, "+ 10000000");
  EXPECT_EQ(values(shifted).back(), 1e7 + 1);
  const Ticks below = ticks(-1e7 - 1, -1e7, 5);
  EXPECT_EQ(below.note.substr(0, 4), "\u2212 ");
  // What is written and what was taken out make the value.
  for (const Tick& tick : ticks(12345678.9, 12345679.4, 5).ticks) {
    EXPECT_NEAR(tick.value, 12345678 + std::stod(tick.text), 1e-6);
  }
}

TEST(Ticks, AreOneWhereTheRangeHasNoLength) {
  EXPECT_EQ(texts(ticks(2, 2, 5)), "2");
  EXPECT_EQ(texts(ticks(0, 0, 5)), "0");
}

TEST(Ticks, AreNoneWhereNumbersEnd) {
  EXPECT_TRUE(ticks(0, std::numeric_limits<double>::infinity(), 5).ticks.empty());
  EXPECT_TRUE(ticks(1e300, std::nextafter(1e300, 2e300), 5).ticks.empty());
  EXPECT_TRUE(ticks(1, 0, 5).ticks.empty());
}

}  // namespace
}  // namespace saddle
