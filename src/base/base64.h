// Bytes as letters. Source: S. Josefsson, "The Base16, Base32, and Base64 data encodings", RFC
// 4648.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace saddle {

/// In groups of four letters, the last filled up with '='.
std::string base64_of(std::string_view bytes);

/// The bytes again; nothing for text that base64_of() does not make.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace saddle
