// Each band is deflated by itself and ends on a byte boundary, without the mark of the stream's end
// but in the last; the checksum of all is put together from theirs.
#include "base/png_pixels.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>

#include "base/deflate.h"
#include "base/parallel.h"

namespace saddle {
namespace {

constexpr std::uint8_t kSubFilter = 1;

/// Deflate, a window of 32 KiB, the least effort; the two bytes are a multiple of 31.
constexpr char kStreamHeader[] = {0x78, 0x01};

/// Rows of the picture as a PNG has them: the kind of filter, then each byte less the same one of
/// the pixel to the left. Each pixel has the first kChannels of its four bytes.
template <std::size_t kChannels>
std::vector<std::uint8_t> filtered(const Image& image, int begin, int end) {
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<std::uint8_t> rows((kChannels * width + 1) * static_cast<std::size_t>(end - begin));
  std::uint8_t* out = rows.data();
  for (int y = begin; y < end; ++y) {
    *out++ = kSubFilter;
    const std::uint8_t* pixel = image.pixel(0, y);
    out = std::copy_n(pixel, kChannels, out);
    for (std::size_t x = 1; x < width; ++x, pixel += 4) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        *out++ = static_cast<std::uint8_t>(pixel[4 + c] - pixel[c]);
      }
    }
  }
  return rows;
}

std::string big_endian(uLong number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
  return bytes;
}

}  // namespace

std::vector<std::string> pack_pixels(const Image& image, bool opaque, unsigned threads) {
  const std::size_t row_bytes = (opaque ? 3 : 4) * static_cast<std::size_t>(image.width) + 1;
  const std::size_t band_rows = (kBandBytes + row_bytes - 1) / row_bytes;
  const auto height = static_cast<std::size_t>(image.height);
  std::vector<std::string> bands((height + band_rows - 1) / band_rows);
  std::vector<uLong> checksums(bands.size());
  parallel_chunks(height, band_rows, threads, [&](std::size_t begin, std::size_t end) {
    const auto filter = opaque ? filtered<3> : filtered<4>;
    std::vector<std::uint8_t> rows = filter(image, static_cast<int>(begin), static_cast<int>(end));
    const std::size_t band = begin / band_rows;
    checksums[band] = adler32(1, rows.data(), static_cast<uInt>(rows.size()));
    bands[band] = deflated(rows, end == height);
  });
  uLong checksum = 1;
  for (std::size_t band = 0; band < bands.size(); ++band) {
    const std::size_t rows = std::min(band_rows, height - band * band_rows);
    checksum = adler32_combine(checksum, checksums[band], static_cast<z_off_t>(rows * row_bytes));
  }
  bands.front().insert(0, kStreamHeader, sizeof kStreamHeader);
  bands.back() += big_endian(checksum);
  return bands;
}

}  // namespace saddle
