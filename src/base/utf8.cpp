#include "base/utf8.h"

#include <algorithm>
#include <array>
#include <span>

namespace saddle {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};

constexpr std::array kZeroWidth = {
    Range{0x0300, 0x036F},    // combining marks
    Range{0x0483, 0x0489},    // Cyrillic marks
    Range{0x0591, 0x05BD},    // Hebrew points
    Range{0x0610, 0x061A},    // Arabic marks
    Range{0x064B, 0x065F},    // Arabic vowels
    Range{0x1AB0, 0x1AFF},    // combining marks, extended
    Range{0x1DC0, 0x1DFF},    // combining marks, supplement
    Range{0x200B, 0x200D},    // zero width space and joiners
    Range{0x2060, 0x2064},    // word joiner, invisible operators
    Range{0x20D0, 0x20FF},    // combining marks for symbols
    Range{0xFE00, 0xFE0F},    // variation selectors
    Range{0xFE20, 0xFE2F},    // combining half marks
    Range{0xFEFF, 0xFEFF},    // byte order mark
    Range{0xE0100, 0xE01EF},  // variation selectors, supplement
};

constexpr std::array kWide = {
    Range{0x1100, 0x115F},    // Hangul Jamo, leading
    Range{0x2E80, 0x303E},    // CJK radicals and punctuation
    Range{0x3041, 0xA4CF},    // kana to Yi
    Range{0xA960, 0xA97F},    // Hangul Jamo, extended
    Range{0xAC00, 0xD7A3},    // Hangul
    Range{0xF900, 0xFAFF},    // CJK compatibility
    Range{0xFE30, 0xFE6F},    // CJK compatibility forms
    Range{0xFF00, 0xFF60},    // full-width forms
    Range{0xFFE0, 0xFFE6},    // full-width signs
    Range{0x1F300, 0x1F64F},  // emoji
    Range{0x1F900, 0x1F9FF},  // emoji, supplement
    Range{0x20000, 0x3FFFD},  // CJK extensions
};

bool contains(std::span<const Range> ranges, char32_t code) {
  const auto after = std::upper_bound(ranges.begin(), ranges.end(), code,
                                      [](char32_t c, const Range& r) { return c < r.first; });
  return after != ranges.begin() && code <= std::prev(after)->last;
}

unsigned char byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

bool is_scalar(char32_t code) {
  return code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
}

}  // namespace

Character decode_utf8(std::string_view text, std::size_t at) {
  constexpr Character kBad{kReplacementCharacter, 1};
  // The least code that needs 1, 2, 3 and 4 bytes; less is an overlong form.
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const unsigned char lead = byte_at(text, at);
  if (lead < 0x80) return {lead, 1};
  if (lead < 0xC2 || lead > 0xF4) return kBad;
  const std::size_t bytes = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (text.size() - at < bytes) return kBad;
  char32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    const unsigned char next = byte_at(text, at + i);
    if ((next & 0xC0u) != 0x80) return kBad;
    code = code << 6 | (next & 0x3Fu);
  }
  return code >= kLeast[bytes] && is_scalar(code) ? Character{code, bytes} : kBad;
}

int display_width(char32_t code) {
  if (contains(kZeroWidth, code)) return 0;
  return contains(kWide, code) ? 2 : 1;
}

}  // namespace saddle
