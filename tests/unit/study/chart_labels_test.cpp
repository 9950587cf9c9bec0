#include "study/chart_labels.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

TEST(LabelPlacer, KeepsTextsApartThoughTheirAnchorsAreTheSame) {
  LabelPlacer placer({{0, 0}, {400, 300}});
  const dvec2 size(90, 14);
  std::vector<Rectangle> texts;
  for (int k = 0; k < 6; ++k) {
    const dvec2 low = placer.place({{200, 150}}, size);
    texts.push_back({low, low + size});
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(texts[i], texts[j])) << i << j;
  }
}

TEST(LabelPlacer, KeepsTextsInThePanel) {
  LabelPlacer placer({{0, 0}, {400, 300}});
  const dvec2 size(90, 14);
  for (const dvec2& anchor : {dvec2(0, 0), dvec2(400, 300), dvec2(399, 1)}) {
    const dvec2 low = placer.place({anchor}, size);
    EXPECT_GE(low.x, 0);
    EXPECT_GE(low.y, 0);
    EXPECT_LE(low.x + size.x, 400);
    EXPECT_LE(low.y + size.y, 300);
  }
}

TEST(LabelPlacer, KeepsTextsOffCurves) {
  LabelPlacer placer({{0, 0}, {400, 300}});
  placer.avoid_curve({{100, 150}, {300, 150}});
  const dvec2 low = placer.place({{300, 150}, {100, 150}}, {60, 14});
  const bool on_curve = low.y < 150 && low.y + 14 > 150 && low.x < 300 && low.x + 60 > 100;
  EXPECT_FALSE(on_curve);
}

}  // namespace
}  // namespace saddle
