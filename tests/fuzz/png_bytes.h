// PNG files whose checksums a fuzzer need not guess.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>

namespace saddle {

inline std::size_t png_number_at(const std::string& bytes, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return number;
}

/// Makes the checksums of all chunks right. A chunk: its length, its kind, its data and a checksum
/// of both.
inline void repair_png_checksums(std::string& bytes) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kAround = 12;
  for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
    const std::size_t length = png_number_at(bytes, at);
    if (length > bytes.size() - at - kAround) return;
    const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data()) + at + 4;
    const unsigned long sum = crc32(0, data, static_cast<unsigned>(length + 4));
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i) & 0xFF);
    }
    at += kAround + length;
  }
}

}  // namespace saddle
