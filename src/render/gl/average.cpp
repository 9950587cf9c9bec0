#include "render/gl/average.h"

#include <cassert>
#include <cstring>
#include <vector>

namespace saddle {
namespace {

/// Plain sums along the columns, then along the rows: the compiler makes vectors of both loops.
/// `sums` has room for a row of samples.
template <int kPerSide>
void average_row_opaque(const RgbaSamples& samples, const std::uint8_t* row, std::uint8_t* out,
                        std::vector<std::uint16_t>& sums) {
  const int n = kPerSide != 0 ? kPerSide : samples.per_side;
  const std::size_t size = sums.size();
  for (std::size_t i = 0; i < size; ++i) sums[i] = row[i];
  for (int k = 1; k < n; ++k) {
    const std::uint8_t* next = row + k * samples.row_bytes;
    for (std::size_t i = 0; i < size; ++i) sums[i] += next[i];
  }
  const unsigned area = n * n;
  const std::size_t width = size / 4 / n;
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t c = 0; c < 4; ++c) {
      unsigned sum = area / 2;
      for (int k = 0; k < n; ++k) sum += sums[4 * (x * n + k) + c];
      out[4 * x + c] = static_cast<std::uint8_t>(sum / area);
    }
  }
}

void average_row_translucent(const RgbaSamples& samples, const std::uint8_t* row, std::uint8_t* out,
                             std::size_t width) {
  const std::size_t n = samples.per_side;
  const unsigned area = n * n;
  for (std::size_t x = 0; x < width; ++x) {
    unsigned sum[3] = {0, 0, 0};
    unsigned alpha = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint8_t* sample = row + k * samples.row_bytes + 4 * x * n;
      for (std::size_t i = 0; i < n; ++i, sample += 4) {
        for (int c = 0; c < 3; ++c) sum[c] += sample[c] * sample[3];
        alpha += sample[3];
      }
    }
    for (int c = 0; c < 3; ++c) {
      out[4 * x + c] = static_cast<std::uint8_t>(alpha > 0 ? (sum[c] + alpha / 2) / alpha : 0);
    }
    out[4 * x + 3] = static_cast<std::uint8_t>((alpha + area / 2) / area);
  }
}

void average_row(const RgbaSamples& samples, const std::uint8_t* row, std::uint8_t* out,
                 std::size_t width, std::vector<std::uint16_t>& sums) {
  if (samples.per_side == 1) {
    std::memcpy(out, row, 4 * width);
  } else if (!samples.opaque) {
    average_row_translucent(samples, row, out, width);
  } else if (samples.per_side == 2) {
    average_row_opaque<2>(samples, row, out, sums);
  } else {
    average_row_opaque<0>(samples, row, out, sums);
  }
}

}  // namespace

void average_samples(const RgbaSamples& samples, const PixelRect& rect, Image& image) {
  assert(samples.per_side >= 1 && samples.per_side <= kMostSamplesPerSide);
  const std::size_t width = rect.width;
  std::vector<std::uint16_t> sums(4 * width * samples.per_side);
  for (int y = 0; y < rect.height; ++y) {
    const std::uint8_t* row =
        samples.rgba + static_cast<std::size_t>(y) * samples.per_side * samples.row_bytes;
    average_row(samples, row, image.pixel(rect.x, rect.y + rect.height - 1 - y), width, sums);
  }
}

}  // namespace saddle
