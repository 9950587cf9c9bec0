#include "render/overlay/font.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <stb_truetype.h>

#include "base/utf8.h"

namespace saddle {
namespace {

/// Heights in ems: of digits and capital letters above the line, with room for superscripts, and of
/// letters with a tail below it.
constexpr double kAbove = 0.8;
constexpr double kBelow = 0.24;

}  // namespace

struct Font::Face {
  stbtt_fontinfo info{};

  float scale(double size) const {
    return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size));
  }

  /// Calls `visit` with each glyph and its place on the line; returns where the line ends.
  template <typename Visit>
  double walk(const std::string& text, double size, const Visit& visit) const {
    double pen = 0;
    int previous = 0;
    for (std::size_t at = 0; at < text.size();) {
      const Character letter = decode_utf8(text, at);
      at += letter.bytes;
      const int glyph = stbtt_FindGlyphIndex(&info, static_cast<int>(letter.code));
      if (previous != 0)
        pen += scale(size) * static_cast<float>(stbtt_GetGlyphKernAdvance(&info, previous, glyph));
      visit(glyph, pen);
      int advance = 0;
      int bearing = 0;
      stbtt_GetGlyphHMetrics(&info, glyph, &advance, &bearing);
      pen += scale(size) * static_cast<float>(advance);
      previous = glyph;
    }
    return pen;
  }
};

Font::Font() : face_(std::make_unique<Face>()) {
  const unsigned char* const file = font_file().data();
  stbtt_InitFont(&face_->info, file, stbtt_GetFontOffsetForIndex(file, 0));
}

Font::~Font() = default;

double Font::width(const std::string& text, double size) const {
  return face_->walk(text, size, [](int, double) {});
}

std::string Font::unknown_in(const std::string& text) const {
  std::string unknown;
  for (std::size_t at = 0; at < text.size();) {
    const Character letter = decode_utf8(text, at);
    const std::string bytes = text.substr(at, letter.bytes);
    at += letter.bytes;
    if (stbtt_FindGlyphIndex(&face_->info, static_cast<int>(letter.code)) != 0) continue;
    if (unknown.find(bytes) == std::string::npos) unknown += bytes;
  }
  return unknown;
}

double Font::height(double size) const {
  return (kAbove + kBelow) * size;
}

TextBitmap Font::draw(const std::string& text, double size) const {
  TextBitmap bitmap;
  bitmap.width = static_cast<int>(std::ceil(width(text, size))) + 1;
  bitmap.height = static_cast<int>(std::ceil(height(size)));
  bitmap.coverage.assign(static_cast<std::size_t>(bitmap.width) * bitmap.height, 0);
  const double line = std::round(kAbove * size);
  const float scale = face_->scale(size);
  face_->walk(text, size, [&](int glyph, double pen) {
    const double whole = std::floor(pen);
    const auto part = static_cast<float>(pen - whole);
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&face_->info, glyph, scale, scale, part, 0, &left, &top, &right,
                                    &bottom);
    const int columns = right - left;
    const int rows = bottom - top;
    if (columns <= 0 || rows <= 0) return;
    std::vector<std::uint8_t> letter(static_cast<std::size_t>(columns) * rows);
    stbtt_MakeGlyphBitmapSubpixel(&face_->info, letter.data(), columns, rows, columns, scale, scale,
                                  part, 0, glyph);
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const int to_x = static_cast<int>(whole) + left + x;
        const int to_y = static_cast<int>(line) + top + y;
        if (to_x < 0 || to_x >= bitmap.width || to_y < 0 || to_y >= bitmap.height) continue;
        std::uint8_t& to = bitmap.coverage[static_cast<std::size_t>(to_y) * bitmap.width + to_x];
        to = std::max(to, letter[static_cast<std::size_t>(y) * columns + x]);
      }
    }
  });
  return bitmap;
}

TextBitmap rim_of(const TextBitmap& letters, int pixels) {
  // In its column a pixel is so far from the nearest ink; farther than the rim is wide: nowhere.
  constexpr int kInk = 96;  // of 255: the outline goes through such pixels
  const int far = pixels + 1;
  TextBitmap rim{letters.width + 2 * pixels, letters.height + 2 * pixels, {}};
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * rim.width + x; };
  std::vector<int> above(at(0, rim.height), far);
  for (int y = 0; y < letters.height; ++y) {
    for (int x = 0; x < letters.width; ++x) {
      const bool is_ink = letters.coverage[static_cast<std::size_t>(y) * letters.width + x] > kInk;
      if (is_ink) above[at(x + pixels, y + pixels)] = 0;
    }
  }
  for (int y = 1; y < rim.height; ++y) {
    for (int x = 0; x < rim.width; ++x) {
      above[at(x, y)] = std::min(above[at(x, y)], above[at(x, y - 1)] + 1);
    }
  }
  for (int y = rim.height - 2; y >= 0; --y) {
    for (int x = 0; x < rim.width; ++x) {
      above[at(x, y)] = std::min(above[at(x, y)], above[at(x, y + 1)] + 1);
    }
  }
  rim.coverage.reserve(above.size());
  for (int y = 0; y < rim.height; ++y) {
    for (int x = 0; x < rim.width; ++x) {
      double nearest = far * far;
      for (int k = std::max(0, x - pixels); k <= std::min(rim.width - 1, x + pixels); ++k) {
        const double d = above[at(k, y)];
        nearest = std::min(nearest, d * d + (k - x) * (k - x));
      }
      const double share = std::clamp(pixels + 1 - std::sqrt(nearest), 0.0, 1.0);
      rim.coverage.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  }
  return rim;
}

std::vector<OutlinePiece> Font::outlines(const std::string& text, double size) const {
  std::vector<OutlinePiece> pieces;
  const double line = std::round(kAbove * size);
  const double scale = face_->scale(size);
  face_->walk(text, size, [&](int glyph, double pen) {
    const auto place = [&](int x, int y) { return dvec2(pen + scale * x, line - scale * y); };
    stbtt_vertex* vertices = nullptr;
    const int count = stbtt_GetGlyphShape(&face_->info, glyph, &vertices);
    for (int i = 0; i < count; ++i) {
      const stbtt_vertex& v = vertices[i];
      OutlinePiece piece{OutlinePiece::Kind::Line, place(v.x, v.y)};
      if (v.type == STBTT_vmove) piece.kind = OutlinePiece::Kind::Move;
      if (v.type == STBTT_vcurve) {
        piece.kind = OutlinePiece::Kind::Curve;
        piece.control = place(v.cx, v.cy);
      }
      pieces.push_back(piece);
    }
    stbtt_FreeShape(&face_->info, vertices);
  });
  return pieces;
}

}  // namespace saddle
