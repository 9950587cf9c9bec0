// Exact tests of points against the triangles that cover them, in place of a buffer of depths:
// ends of hidden parts do not depend on its pixels.
#include "export/figures/visible_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

namespace saddle {
namespace {

/// Pixels of the rectangles by which triangles are found. They are narrow: the slivers of a surface
/// that oscillates are upright in most pictures.
constexpr double kBinWidth = 2;
constexpr double kBinHeight = 8;
/// Points of a line that are tested, pixels apart: no gap or piece that is shorter is found.
constexpr double kStep = 0.5;
/// From there, halvings to the end of a part: 0.5 / 2^4 is a thirty-second of a pixel.
constexpr int kHalvings = 4;
/// Lines lie on the triangles' own sides. Triangles are pushed back by the depth that they have
/// across so many pixels, less than hidden parts may be wrong by, and by a share of all depths for
/// those seen straight on.
constexpr double kPushPixels = 0.1;
constexpr double kPushDepth = 1e-6;
/// Triangles of less area, in square pixels, hide nothing.
constexpr double kLeastArea = 1e-9;

double area(const dvec3& a, const dvec3& b, const dvec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The least and the largest x of a triangle within a row of rectangles.
std::pair<double, double> extent_in_row(const std::array<dvec3, 3>& corners, int row) {
  const double top = row * kBinHeight;
  const double bottom = top + kBinHeight;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec3& from = corners[k];
    const dvec3& to = corners[(k + 1) % 3];
    if (std::max(from.y, to.y) < top || std::min(from.y, to.y) > bottom) continue;
    const auto add = [&](double end, double x) {
      const double y = std::clamp(end, top, bottom);
      const double at = y == end ? x : glm::mix(from.x, to.x, (y - from.y) / (to.y - from.y));
      low = std::min(low, at);
      high = std::max(high, at);
    };
    add(from.y, from.x);
    add(to.y, to.x);
  }
  return {low, high};
}

}  // namespace

PictureDepths::PictureDepths(const FittedCamera& camera, const dvec2& size)
    : camera_(camera),
      size_(size),
      columns_(static_cast<int>(size.x / kBinWidth) + 1),
      rows_(static_cast<int>(size.y / kBinHeight) + 1),
      bins_(static_cast<std::size_t>(columns_) * rows_) {}

std::optional<dvec3> PictureDepths::screen(const dvec3& point, double nearer) const {
  dvec3 eye =
      glm::dmat3(camera_.world_to_eye) * (point - camera_.target) - dvec3(0, 0, camera_.distance);
  const bool ortho = camera_.eye_to_clip[2][3] == 0;
  const double way = nearer * camera_.half_height;
  if (ortho) {
    eye.z += way;
  } else {
    eye *= 1 - way / camera_.distance;
  }
  const glm::dvec4 clip = camera_.eye_to_clip * glm::dvec4(eye, 1);
  if (!(clip.w > 0)) return std::nullopt;
  return dvec3((1 + clip.x / clip.w) / 2 * size_.x, (1 - clip.y / clip.w) / 2 * size_.y,
               clip.z / clip.w);
}

void PictureDepths::add(const std::array<dvec3, 3>& corners) {
  Drawn drawn;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = screen(corners[k], 0);
    if (!at) return;
    drawn.at[k] = *at;
  }
  const auto& [a, b, c] = drawn.at;
  const double whole = area(a, b, c);
  if (!(std::abs(whole) > kLeastArea)) return;
  const double across = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / whole;
  const double down = ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / whole;
  drawn.push = kPushPixels * std::max(std::abs(across), std::abs(down)) + kPushDepth;
  drawn.nearest = std::min({a.z, b.z, c.z});
  const auto number = static_cast<std::uint32_t>(triangles_.size());
  triangles_.push_back(drawn);
  // Its number from the first of the picture, or -1, or `count`.
  const auto bin = [](double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), -1.0, static_cast<double>(count)));
  };
  const auto row = [&](double pixel) { return bin(pixel / kBinHeight, rows_); };
  const auto column = [&](double pixel) { return bin(pixel / kBinWidth, columns_); };
  const int last_row = std::min(rows_ - 1, row(std::max({a.y, b.y, c.y})));
  for (int y = std::max(0, row(std::min({a.y, b.y, c.y}))); y <= last_row; ++y) {
    const auto [low, high] = extent_in_row(drawn.at, y);
    const int last = std::min(columns_ - 1, column(high));
    for (int x = std::max(0, column(low)); x <= last; ++x) {
      Bin& meets = bins_[static_cast<std::size_t>(y) * columns_ + x];
      meets.triangles.push_back(number);
      meets.is_sorted = false;
    }
  }
}

bool PictureDepths::hides(const Drawn& drawn, const dvec3& at) {
  const auto& [a, b, c] = drawn.at;
  const double whole = area(a, b, c);
  const double at_b = area(a, at, c) / whole;
  if (!(at_b >= 0)) return false;
  const double at_c = area(a, b, at) / whole;
  return at_c >= 0 && at_b + at_c <= 1 &&
         a.z + at_b * (b.z - a.z) + at_c * (c.z - a.z) + drawn.push < at.z;
}

bool PictureDepths::is_hidden(const dvec3& at) {
  if (!(at.x >= 0 && at.y >= 0 && at.x < size_.x && at.y < size_.y)) return true;  // not in it
  Bin& bin = bins_[static_cast<std::size_t>(at.y / kBinHeight) * columns_ +
                   static_cast<std::size_t>(at.x / kBinWidth)];
  const auto nearest = [this](std::uint32_t number) { return triangles_[number].nearest; };
  if (!bin.is_sorted) std::ranges::sort(bin.triangles, {}, nearest);
  bin.is_sorted = true;
  // The triangle that hid the last point mostly hides the next one, too.
  if (last_hiding_ && hides(triangles_[*last_hiding_], at)) return true;
  for (const std::uint32_t number : bin.triangles) {
    if (triangles_[number].nearest > at.z) return false;
    if (hides(triangles_[number], at)) {
      last_hiding_ = number;
      return true;
    }
  }
  return false;
}

/// Where, between two shares of a way, its points begin to be hidden or end being so.
double PictureDepths::end_of_part(const dvec3& from, const dvec3& way,
                                  std::array<double, 2> between, bool was_hidden) {
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = std::midpoint(between[0], between[1]);
    between[is_hidden(from + way * middle) == was_hidden ? 0 : 1] = middle;
  }
  return std::midpoint(between[0], between[1]);
}

std::vector<std::vector<dvec2>> PictureDepths::visible(std::span<const dvec3> chain,
                                                       double nearer) {
  std::vector<std::vector<dvec2>> parts;
  bool is_open = false;
  const auto add = [&](const dvec3& at) {
    if (!is_open) parts.emplace_back();
    is_open = true;
    parts.back().emplace_back(at);
  };
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const auto from = screen(chain[i - 1], nearer);
    const auto to = screen(chain[i], nearer);
    if (!from || !to) {
      is_open = false;
      continue;
    }
    const dvec3 way = *to - *from;  // depths are linear on the screen, too
    const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(way.x, way.y) / kStep)));
    bool was_hidden = is_hidden(*from);
    if (was_hidden) is_open = false;
    if (!was_hidden) add(*from);
    for (int k = 1; k <= steps; ++k) {
      const bool now_hidden = is_hidden(*from + way * (static_cast<double>(k) / steps));
      if (now_hidden != was_hidden) {
        const double before = static_cast<double>(k - 1) / steps;
        const double after = static_cast<double>(k) / steps;
        add(*from + way * end_of_part(*from, way, {before, after}, was_hidden));
        if (now_hidden) is_open = false;
        was_hidden = now_hidden;
      }
    }
    if (!was_hidden) add(*to);
  }
  return parts;
}

}  // namespace saddle
