// Numbers to streams in large pieces: as bytes, as text.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <ostream>
#include <string_view>
#include <vector>

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

  /// `doubles`: to all digits; else to those of a float.
  TextWriter& real(double number, bool doubles) {
    reserve();
    char* const begin = buffer_.data() + used_;
    const double plain = number + 0.0;  // no "-0"
    const auto end = doubles ? std::to_chars(begin, begin + kLongest, plain)
                             : std::to_chars(begin, begin + kLongest, static_cast<float>(plain));
    used_ += static_cast<std::size_t>(end.ptr - begin);
    return *this;
  }

  /// A coordinate of a unit vector, to kUnitDigits behind the point: many times quicker than
  /// real().
  TextWriter& unit(double number) {
    constexpr int kUnitDigits = 6;  // as near as a normal's angle in floats
    constexpr long kUnit = 1'000'000;
    const long count = std::lround(std::clamp(number, -1.0, 1.0) * kUnit);
    if (count == 0) return *this << "0";
    if (count < 0) *this << "-";
    long rest = std::abs(count);
    if (rest == kUnit) return *this << "1";
    std::array<char, kUnitDigits + 2> text{'0', '.'};
    for (std::size_t i = text.size(); i-- > 2; rest /= 10) {
      text[i] = static_cast<char>('0' + rest % 10);
    }
    return *this << std::string_view(text.data(), text.size());
  }

  TextWriter& whole(std::size_t number) {
    reserve();
    char* const begin = buffer_.data() + used_;
    used_ += static_cast<std::size_t>(std::to_chars(begin, begin + kLongest, number).ptr - begin);
    return *this;
  }

  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kBytes = std::size_t{1} << 16;
  static constexpr std::size_t kLongest = 32;  ///< characters of a number, 24 at most
  void reserve() {
    if (kBytes - used_ < kLongest) flush();
  }
  std::ostream& out_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace saddle
