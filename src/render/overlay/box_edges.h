// The box of the axes in the picture: which of its edges are drawn, and which have ticks.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "render/overlay/label_writer.h"
#include "scene/model/camera.h"

namespace saddle {

/// An edge of the box that has ticks: along `axis`, from the box's low to its high end of it.
struct Edge {
  int axis = 0;
  dvec3 begin, end;
  dvec2 from, to;  ///< pixels
  dvec2 out;       ///< unit vector away from the box in the picture
};

/// The box and the camera live as long as this.
class BoxEdges {
 public:
  /// `size`: of the picture, in pixels; edges that are shorter than `least_length` there, seen
  /// almost along themselves, have no ticks.
  BoxEdges(const FittedCamera& camera, bool ortho, const Bounds& box, const dvec2& size,
           double least_length)
      : camera_(camera), ortho_(ortho), box_(box), size_(size), least_length_(least_length) {}

  /// All edges but those between two faces in front: they would hide the surfaces.
  std::vector<std::array<dvec3, 2>> drawn() const;

  /// The lowest edge along an axis on the box's outline; the leftmost one, if they are upright.
  std::optional<Edge> with_ticks(int axis) const;

  /// Around the box in the picture; all of the picture if that cannot be told.
  Rect outline() const;

  /// Where a point of space is in the picture; nothing if it is not in front of the eye.
  std::optional<dvec2> pixel_of(const dvec3& point) const;

 private:
  /// Whether the box's face at the low or the high end of an axis is toward the eye.
  bool is_front(int axis, bool high) const;
  dvec3 corner(int axis, bool first_high, bool second_high, bool end) const;
  std::optional<Edge> edge_at(int axis, bool first, bool second) const;

  const FittedCamera& camera_;
  bool ortho_;
  const Bounds& box_;
  dvec2 size_;
  double least_length_;
};

}  // namespace saddle
