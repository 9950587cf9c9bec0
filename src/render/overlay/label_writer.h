// Lines of text on a picture that keep clear of each other and of its border.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"
#include "render/overlay/font.h"

namespace saddle {

/// A line of text around a place, its letters `size` pixels large.
struct WrittenText {
  dvec2 middle;
  std::string text;
  double size = 0;
};

/// Part of a picture, in pixels from its upper left.
struct Rect {
  dvec2 low{0, 0}, high{0, 0};

  bool overlaps(const Rect& r) const {
    return low.x < r.high.x && r.low.x < high.x && low.y < r.high.y && r.low.y < high.y;
  }
};

class LabelWriter {
 public:
  /// `size` of the picture.
  explicit LabelWriter(const dvec2& size) : size_(size) {}

  const std::vector<WrittenText>& texts() const { return texts_; }
  double width(const std::string& text, double size) const { return font_.width(text, size); }
  double height(double size) const { return font_.height(size); }
  /// Characters of the texts that have no letter.
  std::string unknown() const;

  /// Nothing is written here.
  void keep_clear(const Rect& rect) { taken_.push_back(rect); }

  /// The rectangle of a text that touches `at` and lies in the direction `way` of it, of length 1
  /// or 0.
  Rect rect_beside(const std::string& text, const dvec2& at, const dvec2& way, double size) const;

  /// Writes there if nothing is there and it is in the picture.
  bool write(const std::string& text, const dvec2& at, const dvec2& way, double size);

  /// The same, or else as near as can be without `avoid`: letters shrink until the line is no wider
  /// than the picture, and it moves in from the border, then up or down.
  bool write_near(const std::string& text, const dvec2& at, const dvec2& way, double size,
                  const Rect& avoid = {});

  /// The text, shortened by an ellipsis where it is wider than `most`.
  std::string shortened(const std::string& text, double most, double size) const;

 private:
  bool place(const std::string& text, const dvec2& middle, double size);

  dvec2 size_;
  Font font_;
  std::vector<Rect> taken_;
  std::vector<WrittenText> texts_;
};

/// Line ends and other controls, which have no letters, as spaces; no more of a text than the
/// largest picture has pixels in a line.
std::string one_line(const std::string& text);

}  // namespace saddle
