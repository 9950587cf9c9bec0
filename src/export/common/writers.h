// Numbers to streams in large pieces: as bytes, as text.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ostream>
#include <string_view>
#include <vector>

#include "export/common/number_text.h"

namespace saddle {

/// Gathers numbers, little endian.
class ByteWriter {
 public:
  explicit ByteWriter(std::ostream& out) : out_(out), buffer_(kBytes) {}

  template <typename Number>
  void put(Number number) {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) {
      std::reverse(bytes.begin(), bytes.end());
    }
    if (used_ + sizeof(Number) > kBytes) flush();
    std::memcpy(buffer_.data() + used_, bytes.data(), sizeof(Number));
    used_ += sizeof(Number);
  }

  void put_text(std::string_view text) {
    for (const char c : text) put(c);
  }

  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kBytes = std::size_t{1} << 16;
  std::ostream& out_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

/// Gathers text. Numbers are the shortest that read back the same.
class TextWriter {
 public:
  explicit TextWriter(std::ostream& out) : out_(out), buffer_(kBytes) {}

  TextWriter& operator<<(std::string_view text) {
    if (text.size() > kBytes - used_) flush();
    if (text.size() > kBytes) {
      out_ << text;
    } else {
      std::memcpy(buffer_.data() + used_, text.data(), text.size());
      used_ += text.size();
    }
    return *this;
  }

  TextWriter& put(char c) {
    reserve();
    buffer_[used_++] = c;
    return *this;
  }

  /// `doubles`: to all digits; else to those of a float.
  TextWriter& real(double number, bool doubles) {
    reserve();
    char* const begin = buffer_.data() + used_;
    const double plain = number + 0.0;  // no "-0"
    const char* const end = doubles ? std::to_chars(begin, begin + kLongest, plain).ptr
                                    : write_float(begin, static_cast<float>(plain));
    used_ += static_cast<std::size_t>(end - begin);
    return *this;
  }

  /// A coordinate of a unit vector, to six digits behind the point: many times quicker than
  /// real().
  TextWriter& unit(double number) {
    constexpr long kUnit = 1'000'000;  // as near as a normal's angle in floats
    const long count = std::lround(std::clamp(number, -1.0, 1.0) * kUnit);
    if (count == 0) return put('0');
    if (count < 0) put('-');
    if (std::abs(count) == kUnit) return put('1');
    reserve();
    char* const begin = buffer_.data() + used_;
    const char* const end = write_millionths(begin, static_cast<std::uint32_t>(std::abs(count)));
    used_ += static_cast<std::size_t>(end - begin);
    return *this;
  }

  TextWriter& whole(std::size_t number) {
    reserve();
    char* const begin = buffer_.data() + used_;
    used_ += static_cast<std::size_t>(write_whole(begin, number) - begin);
    return *this;
  }

  /// A corner of a face in OBJ, " v/corner/corner".
  TextWriter& corner(std::size_t v, std::size_t corner) {
    reserve(3 * kLongest);
    char* at = buffer_.data() + used_;
    char* const begin = at;
    *at++ = ' ';
    at = write_whole(at, v);
    *at++ = '/';
    at = write_twice(at, corner, '/');
    used_ += static_cast<std::size_t>(at - begin);
    return *this;
  }

  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kBytes = std::size_t{1} << 16;
  static constexpr std::size_t kLongest = kMostNumberText;  ///< characters of a number, 24 at most
  void reserve(std::size_t bytes = kLongest) {
    if (kBytes - used_ < bytes) flush();
  }
  std::ostream& out_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace saddle
