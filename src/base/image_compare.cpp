#include "base/image_compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace saddle {
namespace {

// The window and constants of the paper named in the header, for luminances of 0 to 1.
constexpr int kWindow = 8;
constexpr int kWindowStep = 4;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

/// A channel over black is the product of two bytes, an exact integer up to this.
constexpr int kFull = 255 * 255;

// The picture of the difference: the copy is dim enough that the weakest red stands out.
constexpr double kDimming = 0.25;
constexpr double kWeakestRed = 96;

using Channels = std::array<int, 4>;

/// Red, green and blue over black, and alpha, each 0 to kFull.
Channels over_black(const std::uint8_t* pixel) {
  const int alpha = pixel[3];
  return {pixel[0] * alpha, pixel[1] * alpha, pixel[2] * alpha, 255 * alpha};
}

/// ITU-R BT.601 luminance over black, 0 to 1.
float luminance(const std::uint8_t* pixel) {
  const Channels c = over_black(pixel);
  return (0.299F * static_cast<float>(c[0]) + 0.587F * static_cast<float>(c[1]) +
          0.114F * static_cast<float>(c[2])) /
         kFull;
}

std::vector<float> luminances(const Image& image) {
  std::vector<float> result(image.rgba.size() / 4);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = luminance(&image.rgba[4 * i]);
  return result;
}

/// Largest and summed difference of channels, in units of 1 / kFull.
struct ChannelDifference {
  int largest = 0;
  std::uint64_t sum = 0;
};

ChannelDifference compare_channels(const Image& a, const Image& b) {
  ChannelDifference difference;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    const Channels ca = over_black(&a.rgba[i]);
    const Channels cb = over_black(&b.rgba[i]);
    for (int k = 0; k < 4; ++k) {
      const int d = std::abs(ca[k] - cb[k]);
      difference.largest = std::max(difference.largest, d);
      difference.sum += static_cast<std::uint64_t>(d);
    }
  }
  return difference;
}

/// Where windows of `window` pixels begin along a side of `size`: every kWindowStep, and the last
/// one flush with the end.
std::vector<int> window_starts(int size, int window) {
  std::vector<int> starts;
  for (int at = 0; at + window < size; at += kWindowStep) starts.push_back(at);
  starts.push_back(size - window);
  return starts;
}

/// Two planes of luminances, one value per pixel, rows of `stride`.
struct Planes {
  const float* a;
  const float* b;
  int stride;
};

/// Structural similarity of one window. Exactly 1 for equal windows: numerator and denominator
/// then round the same way.
double window_similarity(const Planes& planes, int width, int height) {
  double sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double a = planes.a[y * planes.stride + x];
      const double b = planes.b[y * planes.stride + x];
      sum_a += a;
      sum_b += b;
      sum_aa += a * a;
      sum_bb += b * b;
      sum_ab += a * b;
    }
  }
  const double n = static_cast<double>(width) * height;
  const double mean_a = sum_a / n;
  const double mean_b = sum_b / n;
  const double mean_product = mean_a * mean_b;
  const double mean_squares = mean_a * mean_a + mean_b * mean_b;
  const double variances = (sum_aa + sum_bb) / n - mean_squares;
  const double covariance = sum_ab / n - mean_product;
  return (2 * mean_product + kC1) * (2 * covariance + kC2) /
         ((mean_squares + kC1) * (variances + kC2));
}

double mean_similarity(const Image& a, const Image& b) {
  const std::vector<float> plane_a = luminances(a);
  const std::vector<float> plane_b = luminances(b);
  const int width = std::min(kWindow, a.width);
  const int height = std::min(kWindow, a.height);
  const std::vector<int> columns = window_starts(a.width, width);
  const std::vector<int> rows = window_starts(a.height, height);
  double sum = 0;
  for (const int y : rows) {
    for (const int x : columns) {
      const std::size_t at = static_cast<std::size_t>(y) * a.width + x;
      sum += window_similarity({&plane_a[at], &plane_b[at], a.width}, width, height);
    }
  }
  return sum / (static_cast<double>(rows.size()) * static_cast<double>(columns.size()));
}

/// Largest difference of the channels at a place, 0 to 1; 1 where only one picture has a pixel.
double pixel_difference(const Image& a, const Image& b, int x, int y) {
  const bool in_both = x < std::min(a.width, b.width) && y < std::min(a.height, b.height);
  if (!in_both) return 1;
  const Channels ca = over_black(a.pixel(x, y));
  const Channels cb = over_black(b.pixel(x, y));
  int largest = 0;
  for (int k = 0; k < 4; ++k) largest = std::max(largest, std::abs(ca[k] - cb[k]));
  return static_cast<double>(largest) / kFull;
}

}  // namespace

ImageDifference compare_images(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return {1, 1, 0, 1};
  if (a.rgba.empty()) return {};
  const ChannelDifference channels = compare_channels(a, b);
  ImageDifference difference;
  difference.largest = static_cast<double>(channels.largest) / kFull;
  difference.mean =
      static_cast<double>(channels.sum) / (static_cast<double>(a.rgba.size()) * kFull);
  difference.ssim = mean_similarity(a, b);
  difference.error = std::clamp(1 - difference.ssim, difference.mean, 1.0);
  return difference;
}

Image difference_image(const Image& a, const Image& b) {
  Image result(std::max(a.width, b.width), std::max(a.height, b.height));
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      std::uint8_t* pixel = result.pixel(x, y);
      pixel[3] = 255;
      const double difference = pixel_difference(a, b, x, y);
      if (difference > 0) {
        const double red = kWeakestRed + (255 - kWeakestRed) * difference;
        pixel[0] = static_cast<std::uint8_t>(std::lround(red));
      } else {
        const double grey = 255 * kDimming * luminance(a.pixel(x, y));
        std::fill_n(pixel, 3, static_cast<std::uint8_t>(std::lround(grey)));
      }
    }
  }
  return result;
}

}  // namespace saddle
