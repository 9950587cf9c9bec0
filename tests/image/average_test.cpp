#include "render/gl/average.h"

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "render/picture/tiles.h"

namespace saddle {
namespace {

/// Noise without a library: the high byte of a linear congruential generator.
std::vector<std::uint8_t> noise(std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  std::uint32_t state = 1;
  for (auto& byte : bytes) {
    state = state * 1664525 + 1013904223;
    byte = static_cast<std::uint8_t>(state >> 24);
  }
  return bytes;
}

TEST(Average, IsTheRoundedMeanWithTheRowsTurnedOver) {
  constexpr int kWidth = 19;
  constexpr int kHeight = 5;
  for (int n = 1; n <= kMostSamplesPerSide; ++n) {
    std::vector<std::uint8_t> samples = noise(4UL * kWidth * n * kHeight * n);
    for (std::size_t i = 3; i < samples.size(); i += 4) samples[i] = 255;
    Image image(kWidth, kHeight);
    const std::size_t row = 4UL * kWidth * n;
    average_samples({samples.data(), row, n, true}, {0, 0, kWidth, kHeight}, image);
    Image general(kWidth, kHeight);
    average_samples({samples.data(), row, n, false}, {0, 0, kWidth, kHeight}, general);
    EXPECT_EQ(image.rgba, general.rgba) << n;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        int sum = 0;
        for (int k = 0; k < n * n; ++k) {
          sum += samples[((kHeight - 1 - y) * n + k / n) * row + 4UL * (x * n + k % n)];
        }
        EXPECT_EQ(image.pixel(x, y)[0], (2 * sum + n * n) / (2 * n * n)) << n;
      }
    }
  }
}

TEST(Average, HoldsTheLargestSquareOfWhite) {
  const std::vector<std::uint8_t> samples(4UL * 16 * 16, 255);
  Image image(1, 1);
  average_samples({samples.data(), 64, 16, true}, {0, 0, 1, 1}, image);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{255, 255, 255, 255}));
}

TEST(Average, WeightsColoursByTheirAlpha) {
  // Three quarters of nothing, with a colour that must not show, and one of opaque red.
  const std::vector<std::uint8_t> samples{200, 0, 0, 255, 0, 90, 0, 0, 0, 90, 0, 0, 0, 90, 0, 0};
  Image image(1, 1);
  average_samples({samples.data(), 8, 2, false}, {0, 0, 1, 1}, image);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{200, 0, 0, 64}));
}

TEST(Average, FillsOnlyItsRectangle) {
  const std::vector<std::uint8_t> samples(4UL * 2 * 3, 9);
  Image image(5, 5);
  average_samples({samples.data(), 8, 1, true}, {1, 2, 2, 3}, image);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(image.pixel(x, y)[0], x >= 1 && x < 3 && y >= 2 ? 9 : 0) << x << " " << y;
    }
  }
}

TEST(Tiles, CoverEveryPixelOnceAndStayWithinTheLimit) {
  for (const auto& [width, height] : {std::array{1, 1}, std::array{800, 600}, std::array{333, 7}}) {
    for (int limit : {1, 10, 64, 4096}) {
      for (const auto& [n, margin] : {std::array{1, 1}, std::array{2, 3}, std::array{5, 1}}) {
        const Tiling tiling = split_picture(width, height, n, limit, margin);
        std::vector<int> covered(static_cast<std::size_t>(width) * height);
        for (const PixelRect& tile : tiling.tiles) {
          EXPECT_LE(tile.width, tiling.tile_width);
          EXPECT_LE(tile.height, tiling.tile_height);
          for (int y = tile.y; y < tile.y + tile.height; ++y) {
            for (int x = tile.x; x < tile.x + tile.width; ++x) ++covered.at(y * width + x);
          }
        }
        EXPECT_EQ(covered, std::vector<int>(covered.size(), 1));
        const int least = n * (1 + 2 * margin);
        EXPECT_LE(n * (tiling.tile_width + 2 * margin), std::max(limit, least));
      }
    }
  }
}

TEST(Tiles, ALargePictureIsDrawnInManyPieces) {
  EXPECT_EQ(split_picture(800, 600, 2, kTileSamples, 1).tiles.size(), 1U);
  const Tiling large = split_picture(16384, 16384, 8, kTileSamples, 1);
  EXPECT_EQ(large.tiles.size(), 33U * 33U);
}

}  // namespace
}  // namespace saddle
