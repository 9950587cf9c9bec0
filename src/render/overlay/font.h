// Letters: how wide a line of text is, and what of each pixel it covers.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"

namespace saddle {

/// A line of text as shares of pixels, 0 to 255, rows from the top.
struct TextBitmap {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> coverage;
};

/// Letters have a rim of the background's colour, this share of their size wide, where they stand
/// on lines and surfaces.
inline constexpr double kLetterRim = 0.14;

/// The rim around letters, this many pixels farther to each side: all that is so near to the ink.
TextBitmap rim_of(const TextBitmap& letters, int pixels);

/// A piece of a letter's outline. A curve is a parabola.
struct OutlinePiece {
  enum class Kind { Move, Line, Curve };
  Kind kind = Kind::Move;
  dvec2 to;
  dvec2 control{0, 0};  ///< of a curve
};

/// DejaVu Sans, not hinted, with kerning. Characters that it does not have are boxes.
class Font {
 public:
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// The width in pixels of a line of UTF-8 in letters of `size` pixels.
  double width(const std::string& text, double size) const;

  /// The characters of a text, each once, that the font has no letter for.
  std::string unknown_in(const std::string& text) const;

  /// From the top of the tallest to the bottom of the lowest letters, the same for all texts.
  double height(double size) const;

  /// The line in a bitmap of just that size, rounded up.
  TextBitmap draw(const std::string& text, double size) const;

  /// Its outlines where draw() has it, in pixels from the bitmap's upper left, y down; each begins
  /// with a move, and is closed. Ink is all that they wind round.
  std::vector<OutlinePiece> outlines(const std::string& text, double size) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

/// The font's file, which is part of the program.
std::span<const unsigned char> font_file();

}  // namespace saddle
