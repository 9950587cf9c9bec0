#include "base/printable.h"

#include <utility>

#include "base/utf8.h"

namespace saddle {
namespace {

/// A terminal would obey these instead of showing them: control characters, line separators, and
/// the marks that reverse the order of text.
bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x200E || c == 0x200F ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

}  // namespace

Glyphs split_glyphs(std::string_view line) {
  Glyphs glyphs;
  std::size_t column = 0;
  for (std::size_t at = 0; at < line.size();) {
    const Character c = decode_utf8(line, at);
    std::string shown(line.substr(at, c.bytes));
    if (c.code == U'\t') {
      shown = " ";
    } else if (is_control(c.code) || c.code == kReplacementCharacter) {
      shown = "?";
    }
    const auto width = static_cast<std::size_t>(display_width(c.code));
    if (width == 0 && !glyphs.empty()) {
      glyphs.back().shown += shown;
      glyphs.back().end = at + c.bytes;
    } else {
      glyphs.push_back({std::move(shown), at, at + c.bytes, column, width});
      column += width;
    }
    at += c.bytes;
  }
  return glyphs;
}

std::size_t columns(const Glyphs& glyphs) {
  return glyphs.empty() ? 0 : glyphs.back().column + glyphs.back().width;
}

std::string joined(const Glyphs& glyphs) {
  std::string text;
  for (const Glyph& glyph : glyphs) text += glyph.shown;
  return text;
}

std::string printable(std::string_view line) {
  return joined(split_glyphs(line));
}

}  // namespace saddle
