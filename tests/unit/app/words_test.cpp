// What `saddle check` says of places.
#include "app/report/words.h"

#include <gtest/gtest.h>

#include <limits>

namespace saddle {
namespace {

TEST(Words, HaveAsManyDigitsAsAreKnown) {
  EXPECT_EQ(words::number(Estimate{12.345678, 0}), "12.3457");
  EXPECT_EQ(words::number(Estimate{12.345678, 1e-7}), "12.3457");
  EXPECT_EQ(words::number(Estimate{12.345678, 4e-3}), "about 12.3");
  EXPECT_EQ(words::number(Estimate{-12.345678, 30}), "0 within 42.4");
  EXPECT_EQ(words::number(Estimate{0, 0}), "0");
}

TEST(Words, TellOfSingularPlacesThatAreNowhere) {
  Facts facts;
  facts.domain = {-1, 1, -1, 1};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 3; ++k) facts.singular.push_back({{0.1 * k, 0.3}, dvec3(nan), {}, false});
  const std::string text = words::singular(facts, 1);
  EXPECT_EQ(text.substr(0, 10), "3 points: ") << text;
}

}  // namespace
}  // namespace saddle
