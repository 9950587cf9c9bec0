// Which parts of lines surfaces leave to be seen, for figures that draw lines as lines.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.h"
#include "scene/model/camera.h"

namespace saddle {

/// Triangles in a picture, found by the pixel that they cover.
class PictureDepths {
 public:
  PictureDepths(const FittedCamera& camera, const dvec2& size);

  /// A triangle of the world that hides what is behind it. One that reaches behind the eye hides
  /// nothing.
  void add(const std::array<dvec3, 3>& corners);

  /// The parts of a chain of points of the world that no triangle hides, in pixels from the
  /// picture's upper left; their ends are right to a twentieth of a pixel. `nearer`: the chain is
  /// seen as if it were so much closer to the eye, as a share of half the visible height.
  std::vector<std::vector<dvec2>> visible(std::span<const dvec3> chain, double nearer);

 private:
  struct Drawn {
    double nearest = 0;       ///< the least depth of its corners
    double push = 0;          ///< how much farther it is taken to be
    std::array<dvec3, 3> at;  ///< pixels, and the depth, which is linear on the screen
  };
  /// The triangles that meet a rectangle of pixels. A point is tested against those that begin
  /// nearer to the eye, the nearest first: one of a few hides most points, however many there are.
  struct Bin {
    std::vector<std::uint32_t> triangles;
    bool is_sorted = false;
  };

  std::optional<dvec3> screen(const dvec3& point, double nearer) const;
  static bool hides(const Drawn& drawn, const dvec3& at);
  bool is_hidden(const dvec3& at);
  double end_of_part(const dvec3& from, const dvec3& way, std::array<double, 2> between,
                     bool was_hidden);

  FittedCamera camera_;
  dvec2 size_;
  int columns_, rows_;
  std::vector<Drawn> triangles_;
  std::vector<Bin> bins_;
  std::optional<std::uint32_t> last_hiding_;
};

}  // namespace saddle
