#include "render/overlay/label_writer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>

#include "base/utf8.h"

namespace saddle {
namespace {

/// The least height of letters that can be read, in pixels.
constexpr double kLeastReadable = 6;
/// The width of the largest picture in pixels: no line of as many letters has room in it.
constexpr std::size_t kMostBytes = 16384;
/// Lines up and down that a text may be from where it belongs.
constexpr int kFarthest = 4;

}  // namespace

Rect LabelWriter::rect_beside(const std::string& text, const dvec2& at, const dvec2& way,
                              double size) const {
  const dvec2 half = 0.5 * dvec2(font_.width(text, size), font_.height(size));
  const dvec2 middle = at + way * glm::dot(glm::abs(way), half);
  return {middle - half, middle + half};
}

bool LabelWriter::place(const std::string& text, const dvec2& middle, double size) {
  const Rect rect = rect_beside(text, middle, {0, 0}, size);
  if (rect.low.x < 0 || rect.low.y < 0 || rect.high.x > size_.x || rect.high.y > size_.y) {
    return false;
  }
  const auto is_hit = [&](const Rect& other) { return rect.overlaps(other); };
  if (std::ranges::any_of(taken_, is_hit)) return false;
  taken_.push_back(rect);
  texts_.push_back({middle, text, size});
  return true;
}

bool LabelWriter::write(const std::string& text, const dvec2& at, const dvec2& way, double size) {
  const Rect rect = rect_beside(text, at, way, size);
  return place(text, (rect.low + rect.high) / 2.0, size);
}

bool LabelWriter::write_near(const std::string& text, const dvec2& at, const dvec2& way,
                             double size, const Rect& avoid) {
  if (write(text, at, way, size)) return true;
  const double fitting = std::min(size, size * size_.x / font_.width(text, size));
  if (fitting < kLeastReadable) return false;
  const Rect wanted = rect_beside(text, at, way, fitting);
  const dvec2 half = (wanted.high - wanted.low) / 2.0;
  const dvec2 middle = glm::clamp((wanted.low + wanted.high) / 2.0, half, size_ - half);
  const auto place_clear = [&](const dvec2& there) {
    const Rect rect{there - half, there + half};
    return !rect.overlaps(avoid) && place(text, there, fitting);
  };
  for (int line = 0; line <= kFarthest; ++line) {
    const dvec2 away(0, line * 2 * half.y);
    if (place_clear(middle + away) || place_clear(middle - away)) return true;
  }
  return false;
}

std::string LabelWriter::unknown() const {
  std::string all;
  for (const WrittenText& text : texts_) all += text.text;
  return font_.unknown_in(all);
}

std::string LabelWriter::shortened(const std::string& text, double most, double size) const {
  if (font_.width(text, size) <= most) return text;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = decode_utf8(text, at).bytes;
    const std::string longer = result + text.substr(at, bytes);
    if (font_.width(longer + "\u2026", size) > most) break;
    result = longer;
    at += bytes;
  }
  return result + "\u2026";
}

std::string one_line(const std::string& text) {
  std::string line = text.substr(0, kMostBytes);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

}  // namespace saddle
