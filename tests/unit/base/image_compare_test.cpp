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

/// Left of the column `edge` black, right of it white; the column itself is mixed by its part.
Image half_white(double edge) {
  Image image = filled(32, 32, kBlack);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      std::fill_n(image.pixel(x, y), 3,
                  static_cast<std::uint8_t>(std::lround(255 * std::clamp(x + 1 - edge, 0.0, 1.0))));
    }
  }
  return image;
}

/// The distance of two colours that fill their pictures.
double error_between(const Color& a, const Color& b) {
  return compare_images(filled(16, 16, a), filled(16, 16, b)).error;
}

TEST(CompareImages, FindsNothingBetweenEqualPictures) {
  const Image image = ball(61);
  const ImageDifference difference = compare_images(image, image);
  EXPECT_EQ(difference.largest, 0);
  EXPECT_EQ(difference.mean, 0);
  EXPECT_EQ(difference.error, 0);
}

TEST(CompareImages, MeasuresColorsInCielab) {
  // Lab of the corners of sRGB under D65, from tables, such as B. Lindbloom's; to their digits.
  EXPECT_NEAR(error_between(kBlack, kWhite), 1, 1e-3);
  EXPECT_NEAR(error_between(kBlack, {0, 0, 255, 255}), 1, 1e-9) << "137, which is past the end";
  EXPECT_NEAR(error_between(kWhite, {0, 255, 255, 255}), 0.5090, 2e-4);  // 91.117, -48.080, -14.138
  EXPECT_NEAR(error_between(kWhite, {255, 255, 0, 255}), 0.9695, 2e-4);  // 97.138, -21.556, 94.483
  EXPECT_NEAR(error_between(kBlack, {128, 128, 128, 255}), 0.5359, 2e-4);
  EXPECT_NEAR(error_between(kBlack, {8, 8, 8, 255}), 0.0219, 2e-4) << "the straight foot";
}

TEST(CompareImages, MeasuresBlackAgainstWhite) {
  const ImageDifference difference = compare_images(filled(20, 20, kBlack), filled(20, 20, kWhite));
  EXPECT_EQ(difference.largest, 1);
  EXPECT_EQ(difference.mean, 0.75);  // alpha is equal
}

TEST(CompareImages, LetsAnEdgeMoveByAPixelAndNoMore) {
  for (const double way : {0.1, 0.5, 0.9, 1.0}) {
    EXPECT_LT(compare_images(half_white(16), half_white(16 + way)).error, 0.03) << way;
  }
  // A column of 8 pixels that is as dark as the blur leaves it: at most 1/8, at least 1/16.
  EXPECT_GT(compare_images(half_white(16), half_white(18)).error, 1.0 / 16);
}

TEST(CompareImages, MissesALineOfOnePixel) {
  Image lined = filled(32, 32, kWhite);
  for (int y = 0; y < 32; ++y) std::fill_n(lined.pixel(14, y), 3, std::uint8_t{0});
  // All of its blur: an eighth of the window.
  EXPECT_NEAR(compare_images(lined, filled(32, 32, kWhite)).error, 1.0 / 8, 1e-3);
}

TEST(CompareImages, SaysWhereTheDifferenceIs) {
  Image a = filled(64, 48, kBlack);
  for (int y = 20; y < 28; ++y) {
    for (int x = 40; x < 48; ++x) a.pixel(x, y)[0] = 255;
  }
  const ImageDifference difference = compare_images(a, filled(64, 48, kBlack));
  EXPECT_EQ(difference.x, 44);
  EXPECT_EQ(difference.y, 24);
}

TEST(CompareImages, IsSymmetric) {
  const Image a = ball(40);
  const Image b = filled(40, 40, {90, 20, 70, 200});
  const ImageDifference ab = compare_images(a, b);
  const ImageDifference ba = compare_images(b, a);
  EXPECT_EQ(ab.largest, ba.largest);
  EXPECT_EQ(ab.mean, ba.mean);
  EXPECT_EQ(ab.error, ba.error);
}

TEST(CompareImages, SeesTransparentPixelsOverBlackAndOverWhite) {
  EXPECT_NEAR(error_between({255, 0, 0, 0}, kBlack), 1, 1e-3) << "over white";
  EXPECT_NEAR(error_between({255, 0, 0, 0}, kWhite), 1, 1e-3) << "over black";
  EXPECT_EQ(error_between({255, 0, 0, 0}, {0, 255, 7, 0}), 0);
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
        EXPECT_GT(difference.error, 0) << size << ": " << x << ", " << y;
        EXPECT_EQ(difference.largest, 1);
        EXPECT_DOUBLE_EQ(difference.mean, 3 / (4.0 * size * size));
      }
    }
  }
}

TEST(CompareImages, GivesTheSameInBandsAsInOne) {
  // The same difference anywhere along a picture of several bands of rows.
  for (const int y : {20, 60, 62, 64, 66, 126, 128, 150}) {
    Image a = filled(8, 200, kBlack);
    for (int x = 0; x < 8; ++x) std::fill_n(a.pixel(x, y), 3, std::uint8_t{255});
    EXPECT_NEAR(compare_images(a, filled(8, 200, kBlack)).error, 1.0 / 8, 1e-3) << y;
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
  EXPECT_LT(compare_images(image, nearly).error, 0.02);
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
