// Bytes as text: base64, and what is deflated before.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace saddle {

/// Source: S. Josefsson, "The Base16, Base32, and Base64 data encodings", RFC 4648, 2006.
std::string base64(std::span<const std::uint8_t> bytes);
std::string base64(std::string_view bytes);

/// A zlib stream of the bytes, as small as zlib makes it. Throws std::bad_alloc.
/// Source: P. Deutsch, J.-L. Gailly, "ZLIB compressed data format specification", RFC 1950, 1996.
std::string zlib_stream(std::string_view bytes);

}  // namespace saddle
