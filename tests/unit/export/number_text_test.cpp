#include "export/common/number_text.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace saddle {
namespace {

using Room = std::array<char, kMostNumberText>;

std::string written(float x) {
  Room room;
  return {room.data(), write_float(room.data(), x)};
}

std::string whole(std::size_t number) {
  Room room;
  return {room.data(), write_whole(room.data(), number)};
}

template <typename Number>
std::string expected(Number number) {
  Room room;
  return {room.data(), std::to_chars(room.data(), room.data() + room.size(), number).ptr};
}

float float_of(std::uint32_t bits) {
  return std::bit_cast<float>(bits);
}

TEST(NumberText, OfFloatsIsThatOfTheStandardLibrary) {
  // A prime step meets all exponents, both signs, infinities and NaN.
  for (std::uint64_t bits = 0; bits < std::uint64_t{1} << 32; bits += 4993) {
    const float x = float_of(static_cast<std::uint32_t>(bits));
    ASSERT_EQ(written(x), expected(x)) << bits;
  }
}

TEST(NumberText, OfFloatsBesidePowersOfTwoAndTen) {
  std::vector<float> places;
  for (int e = -12; e < 20; ++e) places.push_back(std::ldexp(1.F, e));
  for (float ten = 1e-4F; ten < 1e6F; ten *= 10) places.push_back(ten);
  for (const float place : places) {
    const auto bits = std::bit_cast<std::uint32_t>(place);
    for (std::uint32_t near = bits - 200; near <= bits + 200; ++near) {
      ASSERT_EQ(written(float_of(near)), expected(float_of(near)));
    }
  }
}

TEST(NumberText, OfShortFloats) {
  for (int i = 0; i <= 100'000; ++i) {
    const float x = static_cast<float>(i) / 1000;
    ASSERT_EQ(written(-x), expected(-x));
  }
}

TEST(NumberText, OfMillionths) {
  Room room;
  EXPECT_EQ(std::string(room.data(), write_millionths(room.data(), 1)), "0.000001");
  EXPECT_EQ(std::string(room.data(), write_millionths(room.data(), 720'531)), "0.720531");
}

TEST(NumberText, OfWholeNumbers) {
  for (std::size_t number = 0; number < 200'000; ++number) {
    ASSERT_EQ(whole(number), expected(number));
  }
  for (std::size_t ten = 1; ten < 1'000'000'000'000; ten *= 10) {
    for (const std::size_t number : {ten - 1, ten, ten + 1, 7 * ten}) {
      EXPECT_EQ(whole(number), expected(number));
      std::array<char, 2 * kMostNumberText> room;
      EXPECT_EQ(std::string(room.data(), write_twice(room.data(), number, '/')),
                expected(number) + "/" + expected(number));
    }
  }
}

}  // namespace
}  // namespace saddle
