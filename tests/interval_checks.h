// Expectations about enclosures.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "eval/enclose.h"
#include "eval/interval.h"
#include "graph_value.h"

namespace saddle::testing {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Interval kAll = {-kInfinity, kInfinity};

/// Relative width that a few outward roundings add.
inline constexpr double kFewUlps = 1e-14;

/// Holds [low, high] and is hardly wider.
inline void expect_bounds(const Interval& r, double low, double high) {
  const double slack =
      kFewUlps * (std::isfinite(low - high) ? std::max(std::fabs(low), std::fabs(high)) : 1);
  EXPECT_LE(r.low, low);
  EXPECT_GE(r.high, high);
  EXPECT_GE(r.low, low - slack);
  EXPECT_LE(r.high, high + slack);
}

inline void expect_exact(const Interval& r, double low, double high) {
  EXPECT_EQ(r.low, low);
  EXPECT_EQ(r.high, high);
}

inline void expect_proved(const Interval& r) {
  EXPECT_EQ(r.defined, Defined::Yes);
  EXPECT_TRUE(r.continuous);
}

inline void expect_pole(const Interval& r) {
  EXPECT_EQ(r.defined, Defined::Maybe);
  EXPECT_FALSE(r.continuous);
}

inline Interval enclosure(const std::string& formula, const Interval& u, const Interval& v = {0, 0},
                          Powers powers = Powers::Whole) {
  Graph graph;
  const std::array roots = {parse(graph, formula)};
  Interval result;
  enclose(compile(graph, roots, powers), u, v, std::span(&result, 1));
  return result;
}

}  // namespace saddle::testing
