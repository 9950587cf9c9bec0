// Text as a terminal shows it and obeys none of it: names come from files that others wrote.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace saddle {

/// A character of a line as it is shown, with the combining marks that follow it.
struct Glyph {
  std::string shown;
  std::size_t begin = 0;  ///< bytes of the line that it stands for
  std::size_t end = 0;
  std::size_t column = 0;
  std::size_t width = 1;
};

using Glyphs = std::vector<Glyph>;

/// A tab is a space; other control characters, line breaks among them, bytes that are no UTF-8, and
/// the marks that reverse the order of text are '?'.
Glyphs split_glyphs(std::string_view line);

/// Columns of a terminal that they take.
std::size_t columns(const Glyphs& glyphs);

std::string joined(const Glyphs& glyphs);

/// A line as split_glyphs() shows it.
std::string printable(std::string_view line);

}  // namespace saddle
