#include "base/base64.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace saddle {
namespace {

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64_of(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned char byte = k < count ? static_cast<unsigned char>(bytes[i + k]) : 0;
      bits = bits << 8U | byte;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kLetters[bits >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::optional<std::string> bytes_of_base64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t bits = 0;
    std::size_t fill = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const char letter = text[i + k];
      const bool is_fill = letter == '=' && i + 4 == text.size() && k >= 2;
      const std::size_t value = is_fill ? 0 : kLetters.find(letter);
      if (value == std::string_view::npos || (fill > 0 && !is_fill)) return std::nullopt;
      if (is_fill) ++fill;
      bits = bits << 6U | static_cast<std::uint32_t>(value);
    }
    for (std::size_t k = 0; k + fill < 3; ++k) {
      bytes += static_cast<char>(bits >> (16 - 8 * k) & 255U);
    }
  }
  return bytes;
}

}  // namespace saddle
