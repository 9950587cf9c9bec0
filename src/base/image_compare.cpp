#include "base/image_compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/vec.h"

namespace saddle {
namespace {

/// Side and step of the windows in pixels. A missing line one pixel wide is an eighth of a window.
constexpr int kWindow = 8;
constexpr int kWindowStep = 4;
/// Pixels around one whose colours it may have: a rim moves by less than a pixel.
constexpr int kReach = 1;
/// Rows of Lab colours in memory at a time, so that large pictures need no more than small ones.
constexpr int kBand = 64;
/// The distance of black and white in CIELAB.
constexpr double kBlackToWhite = 100;

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
double luminance(const std::uint8_t* pixel) {
  const Channels c = over_black(pixel);
  return (0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]) / kFull;
}

/// The background that shows through transparent pixels.
enum class Behind { Black, White };

/// The linear light of an sRGB value, 0 to 1 (IEC 61966-2-1).
double linear_light(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// f of CIELAB, a cube root with a straight foot (CIE 15).
double lab_curve(double t) {
  constexpr double kFoot = 216.0 / 24389;
  constexpr double kSlope = 24389.0 / 27;
  return t > kFoot ? std::cbrt(t) : (kSlope * t + 16) / 116;
}

/// Colours of pixels in CIELAB under D65. The light of the 256 values is computed once.
class Lab {
 public:
  Lab() {
    for (std::size_t i = 0; i < light_.size(); ++i) {
      light_[i] = linear_light(static_cast<double>(i) / 255);
    }
  }

  dvec3 of(const std::uint8_t* pixel, Behind behind) const {
    std::array<double, 3> rgb{};
    for (int k = 0; k < 3; ++k) {
      const int back = behind == Behind::White ? 255 * (255 - pixel[3]) : 0;
      rgb[k] = light_[(pixel[k] * pixel[3] + back + 127) / 255];
    }
    const auto& [r, g, b] = rgb;
    const double x = lab_curve((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
    const double y = lab_curve(0.2126 * r + 0.7152 * g + 0.0722 * b);
    const double z = lab_curve((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
  }

 private:
  std::array<double, 256> light_{};
};

/// Rows of Lab colours, from the row `first` on.
struct Rows {
  int width = 0;
  int first = 0;
  std::vector<dvec3> colors;

  int end() const { return first + static_cast<int>(colors.size()) / width; }
  const dvec3& at(int x, int y) const {
    return colors[static_cast<std::size_t>(y - first) * width + x];
  }
};

/// The colours of the rows [first, end), averaged with their neighbours by the weights 1, 2, 1 each
/// way: the eye blurs pixels. Beyond the picture its border goes on.
Rows blurred_rows(const Lab& lab, const Image& image, Behind behind, int first, int end) {
  const int width = image.width;
  const std::size_t count = static_cast<std::size_t>(end - first) * width;
  Rows rows{width, first, std::vector<dvec3>(count, dvec3(0))};
  std::vector<dvec3> line(width);
  for (int y = first - 1; y <= end; ++y) {
    const int source = std::clamp(y, 0, image.height - 1);
    for (int x = 0; x < width; ++x) line[x] = lab.of(image.pixel(x, source), behind);
    for (int row = std::max(y - 1, first); row <= std::min(y + 1, end - 1); ++row) {
      const double weight = (row == y ? 2 : 1) / 16.0;
      for (int x = 0; x < width; ++x) {
        const dvec3 sum =
            line[std::max(x - 1, 0)] + 2.0 * line[x] + line[std::min(x + 1, width - 1)];
        rows.colors[static_cast<std::size_t>(row - first) * width + x] += weight * sum;
      }
    }
  }
  return rows;
}

/// How far a colour is from the box of the colours around (x, y), as a part of black to white.
double distance_to_neighbours(const dvec3& color, const Rows& rows, int x, int y) {
  dvec3 low = rows.at(x, y);
  dvec3 high = low;
  for (int j = std::max(y - kReach, rows.first); j <= std::min(y + kReach, rows.end() - 1); ++j) {
    for (int i = std::max(x - kReach, 0); i <= std::min(x + kReach, rows.width - 1); ++i) {
      low = glm::min(low, rows.at(i, j));
      high = glm::max(high, rows.at(i, j));
    }
  }
  const dvec3 nearest = glm::clamp(color, low, high);
  return std::min(glm::distance(color, nearest) / kBlackToWhite, 1.0);
}

/// Raises `map`, a value for each pixel, to the pictures' difference there before a background.
void add_differences(const Image& a, const Image& b, Behind behind, std::vector<float>& map) {
  const Lab lab;
  for (int begin = 0; begin < a.height; begin += kBand) {
    const int end = std::min(begin + kBand, a.height);
    const int first = std::max(begin - kReach, 0);
    const int last = std::min(end + kReach, a.height);
    const Rows rows_a = blurred_rows(lab, a, behind, first, last);
    const Rows rows_b = blurred_rows(lab, b, behind, first, last);
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < a.width; ++x) {
        const double difference = std::max(distance_to_neighbours(rows_a.at(x, y), rows_b, x, y),
                                           distance_to_neighbours(rows_b.at(x, y), rows_a, x, y));
        float& value = map[static_cast<std::size_t>(y) * a.width + x];
        value = std::max(value, static_cast<float>(difference));
      }
    }
  }
}

/// Where windows of `window` pixels begin along a side of `size`: every kWindowStep, and the last
/// one flush with the end.
std::vector<int> window_starts(int size, int window) {
  std::vector<int> starts;
  for (int at = 0; at + window < size; at += kWindowStep) starts.push_back(at);
  starts.push_back(size - window);
  return starts;
}

/// Fills in the window whose mean of `map` is the largest.
void find_worst_window(const std::vector<float>& map, const Image& image,
                       ImageDifference& difference) {
  const int width = std::min(kWindow, image.width);
  const int height = std::min(kWindow, image.height);
  for (const int top : window_starts(image.height, height)) {
    for (const int left : window_starts(image.width, width)) {
      double sum = 0;
      for (int y = top; y < top + height; ++y) {
        const float* const row = &map[static_cast<std::size_t>(y) * image.width + left];
        for (int x = 0; x < width; ++x) sum += row[x];
      }
      const double mean = sum / (width * height);
      if (mean <= difference.error) continue;
      difference.error = mean;
      difference.x = left + width / 2;
      difference.y = top + height / 2;
    }
  }
}

void compare_channels(const Image& a, const Image& b, ImageDifference& difference) {
  int largest = 0;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    const Channels ca = over_black(&a.rgba[i]);
    const Channels cb = over_black(&b.rgba[i]);
    for (int k = 0; k < 4; ++k) {
      const int d = std::abs(ca[k] - cb[k]);
      largest = std::max(largest, d);
      sum += static_cast<std::uint64_t>(d);
    }
  }
  difference.largest = static_cast<double>(largest) / kFull;
  difference.mean = static_cast<double>(sum) / (static_cast<double>(a.rgba.size()) * kFull);
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
  ImageDifference difference;
  if (a.width != b.width || a.height != b.height) {
    difference.largest = difference.mean = difference.error = 1;
    return difference;
  }
  if (a.rgba == b.rgba) return difference;
  compare_channels(a, b, difference);
  std::vector<float> map(a.rgba.size() / 4);
  add_differences(a, b, Behind::Black, map);
  if (!is_opaque(a) || !is_opaque(b)) add_differences(a, b, Behind::White, map);
  find_worst_window(map, a, difference);
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
