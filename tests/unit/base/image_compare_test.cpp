#include "base/image_compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace saddle {
namespace {

using Color = std::array<std::uint8_t, 4>;

Image filled(int width, int height, const Color& color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) std::copy(color.begin(), color.end(), image.pixel(x, y));
  }
  return image;
}

constexpr Color kBlack = {0, 0, 0, 255};
constexpr Color kWhite = {255, 255, 255, 255};

/// A ball shaded from the upper left on black.
Image ball(int size) {
  Image image = filled(size, size, kBlack);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double a = 2.0 * x / size - 1;
      const double b = 2.0 * y / size - 1;
      const double c2 = 1 - a * a - b * b;
      if (c2 <= 0) continue;
      const double light = std::clamp((std::sqrt(c2) - a - b) / std::sqrt(3.0), 0.1, 1.0);
      image.pixel(x, y)[0] = image.pixel(x, y)[1] = static_cast<std::uint8_t>(255 * light);
      image.pixel(x, y)[2] = static_cast<std::uint8_t>(128 * light);
    }
  }
  return image;
}

TEST(CompareImages, FindsNothingBetweenEqualPictures) {
  const Image image = ball(61);
  const ImageDifference difference = compare_images(image, image);
  EXPECT_EQ(difference.largest, 0);
  EXPECT_EQ(difference.mean, 0);
  EXPECT_EQ(difference.ssim, 1);
  EXPECT_EQ(difference.error, 0);
}

TEST(CompareImages, MeasuresBlackAgainstWhite) {
  const ImageDifference difference = compare_images(filled(20, 20, kBlack), filled(20, 20, kWhite));
  EXPECT_EQ(difference.largest, 1);
  EXPECT_EQ(difference.mean, 0.75);  // alpha is equal
  // Means 0 and 1, no variance: C1 / (1 + C1). Luminances are floats.
  EXPECT_NEAR(difference.ssim, 1e-4 / 1.0001, 1e-9);
  EXPECT_NEAR(difference.error, 1 / 1.0001, 1e-9);
}

TEST(CompareImages, GivesTheSsimOfTwoStripedWindowsByHand) {
  // Columns of 0 and 1 against columns of 0 and 1/5: means 1/2 and 1/10, variances 1/4 and 1/100,
  // covariance 1/20.
  Image a = filled(8, 8, kBlack);
  Image b = filled(8, 8, kBlack);
  for (int y = 0; y < 8; ++y) {
    for (int x = 1; x < 8; x += 2) {
      std::fill_n(a.pixel(x, y), 3, std::uint8_t{255});
      std::fill_n(b.pixel(x, y), 3, std::uint8_t{51});
    }
  }
  const double c1 = 1e-4;
  const double c2 = 9e-4;
  const double expected = (2 * 0.05 + c1) * (2 * 0.05 + c2) / ((0.26 + c1) * (0.26 + c2));
  // Luminances are floats of up to 1, rounded three times: 2e-7 each, amplified fourfold at most.
  EXPECT_NEAR(compare_images(a, b).ssim, expected, 1e-6);
}

TEST(CompareImages, IsSymmetric) {
  const Image a = ball(40);
  const Image b = filled(40, 40, {90, 20, 70, 200});
  const ImageDifference ab = compare_images(a, b);
  const ImageDifference ba = compare_images(b, a);
  EXPECT_EQ(ab.largest, ba.largest);
  EXPECT_EQ(ab.mean, ba.mean);
  EXPECT_EQ(ab.ssim, ba.ssim);
}

TEST(CompareImages, CountsADifferenceOfColorsAlone) {
  // Nearly the same luminance: 0.299 * 196 = 58.6 and 0.587 * 100 = 58.7.
  const ImageDifference difference =
      compare_images(filled(20, 20, {196, 0, 0, 255}), filled(20, 20, {0, 100, 0, 255}));
  EXPECT_GT(difference.ssim, 0.999);
  EXPECT_DOUBLE_EQ(difference.mean, (196 + 100) / (4 * 255.0));
  EXPECT_EQ(difference.error, difference.mean);
}

TEST(CompareImages, SeesTransparentPixelsOverBlack) {
  const ImageDifference same_but_alpha =
      compare_images(filled(9, 9, {255, 0, 0, 0}), filled(9, 9, kBlack));
  EXPECT_EQ(same_but_alpha.ssim, 1);
  EXPECT_EQ(same_but_alpha.mean, 0.25);
  EXPECT_EQ(same_but_alpha.largest, 1);
  const ImageDifference both_clear =
      compare_images(filled(9, 9, {255, 0, 0, 0}), filled(9, 9, {0, 255, 7, 0}));
  EXPECT_EQ(both_clear.largest, 0);
  EXPECT_EQ(both_clear.error, 0);
}

TEST(CompareImages, SeesOnePixelWhereverItIs) {
  // Sizes that are and are not a multiple of the windows' step, and smaller than a window.
  for (const int size : {1, 3, 8, 10, 13, 16}) {
    const Image a = filled(size, size, kBlack);
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        Image b = a;
        std::fill_n(b.pixel(x, y), 3, std::uint8_t{255});
        const ImageDifference difference = compare_images(a, b);
        EXPECT_LT(difference.ssim, 1) << size << ": " << x << ", " << y;
        EXPECT_EQ(difference.largest, 1);
        EXPECT_DOUBLE_EQ(difference.mean, 3 / (4.0 * size * size));
      }
    }
  }
}

TEST(CompareImages, KeepsItsScale) {
  const Image image = ball(200);
  Image nearly = image;  // the last bit of everything: nobody sees that
  for (std::uint8_t& value : nearly.rgba) value ^= 1;
  for (std::size_t i = 3; i < nearly.rgba.size(); i += 4) nearly.rgba[i] = 255;
  Image turned = image;  // lit from the other side
  std::reverse(reinterpret_cast<std::uint32_t*>(turned.rgba.data()),
               reinterpret_cast<std::uint32_t*>(turned.rgba.data() + turned.rgba.size()));
  EXPECT_LT(compare_images(image, nearly).error, 0.04);
  EXPECT_GT(compare_images(image, turned).error, 0.1);
  EXPECT_LE(compare_images(image, turned).error, 1);
  EXPECT_GT(compare_images(image, filled(200, 200, kBlack)).error, 0.5);
}

TEST(CompareImages, IsAtItsEndForOtherSizes) {
  const ImageDifference difference = compare_images(filled(10, 9, kBlack), filled(9, 10, kBlack));
  EXPECT_EQ(difference.error, 1);
  EXPECT_EQ(difference.largest, 1);
  EXPECT_EQ(compare_images(Image(), Image()).error, 0);
}

Color color_at(const Image& image, int x, int y) {
  Color color;
  std::copy_n(image.pixel(x, y), 4, color.begin());
  return color;
}

TEST(DifferenceImage, IsGreyWhereEqualAndRedWhereNotTheMoreTheBrighter) {
  const Image a = filled(3, 1, {100, 200, 50, 255});
  Image b = a;
  b.pixel(1, 0)[2] = 51;
  b.pixel(2, 0)[2] = 255;
  const Image difference = difference_image(a, b);
  const Color grey = color_at(difference, 0, 0);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[0], grey[2]);
  EXPECT_GT(grey[0], 0);
  const Color slight = color_at(difference, 1, 0);
  const Color strong = color_at(difference, 2, 0);
  for (const Color& red : {slight, strong}) {
    EXPECT_EQ(red[1], 0);
    EXPECT_EQ(red[2], 0);
    EXPECT_EQ(red[3], 255);
  }
  EXPECT_GT(slight[0],
            color_at(difference_image(filled(1, 1, kWhite), filled(1, 1, kWhite)), 0, 0)[0])
      << "the weakest red must outshine the brightest grey";
  EXPECT_GT(strong[0], slight[0]);
  EXPECT_EQ(color_at(difference_image(filled(1, 1, kBlack), filled(1, 1, kWhite)), 0, 0)[0], 255);
}

TEST(DifferenceImage, IsAsLargeAsBothAndRedWhereOneIsMissing) {
  const Image difference = difference_image(filled(4, 2, kBlack), filled(3, 5, kBlack));
  ASSERT_EQ(difference.width, 4);
  ASSERT_EQ(difference.height, 5);
  EXPECT_EQ(color_at(difference, 2, 1), kBlack);
  const Color missing = {255, 0, 0, 255};
  EXPECT_EQ(color_at(difference, 3, 0), missing);  // only a
  EXPECT_EQ(color_at(difference, 0, 4), missing);  // only b
  EXPECT_EQ(color_at(difference, 3, 4), missing);  // neither
}

}  // namespace
}  // namespace saddle
