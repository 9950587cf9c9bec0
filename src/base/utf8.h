// UTF-8 text, one character at a time.
#pragma once

#include <cstddef>
#include <string_view>

namespace saddle {

struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;  ///< how many bytes of the text it is made of, at least 1
};

/// Replaces bytes that are not UTF-8.
inline constexpr char32_t kReplacementCharacter = 0xFFFD;

/// The character at byte `at` (< text.size()) of `text`. A byte that begins no well-formed
/// sequence (stray, overlong, surrogate, past U+10FFFF, cut off) is one kReplacementCharacter.
/// Source: F. Yergeau, "UTF-8, a transformation format of ISO 10646", RFC 3629, 2003.
Character decode_utf8(std::string_view text, std::size_t at);

/// Columns of a terminal that a printable character takes, whatever the locale: 0 for combining
/// marks and joiners, 2 for East Asian wide ones and emoji, else 1. The ranges are whole blocks of
/// Unicode, coarser than its tables. Source: Unicode Standard Annex 11, "East Asian Width".
int display_width(char32_t code);

}  // namespace saddle
