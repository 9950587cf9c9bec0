// From the camera's few numbers to the transforms that the renderer needs.
#pragma once

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>

#include "base/bounds.h"
#include "scene/model/scene.h"

namespace saddle {

/// A camera fitted to what it looks at.
struct FittedCamera {
  dvec3 eye;
  dvec3 target;
  double distance = 1;      ///< of eye and target
  double half_height = 1;   ///< half of the height that is seen at the target
  double middle = 0;        ///< where the axis meets the picture: Room::middle
  glm::dmat4 world_to_eye;  ///< rigid: the eye at the origin, looking down -z, y up
  glm::dmat4 eye_to_clip;   ///< perspective or orthographic, depth -1 to 1
  double near_plane = 0;    ///< distances along the view, both > 0 in perspective
  double far_plane = 1;
};

/// Left free on each side of a picture, as a share of its width or height.
inline constexpr double kPictureMargin = 0.04;

/// The part of a picture that the drawn surface may take, as shares of the width and the height.
/// The rest is margin, or for what is written.
struct Room {
  double across = 1 - 2 * kPictureMargin;
  double down = 1 - 2 * kPictureMargin;
  /// Its middle, from the picture's to the right, as a share of half the width. The camera's axis
  /// meets the picture there: the surface looks as in a picture of the room alone.
  double middle = 0;
};

/// The least pyramid around points that has its axis along a camera's view and the shape of its
/// picture's room; with an orthographic camera the least such prism. Its apex is where the eye sees
/// the points fill the room. Points may be added in any order; their memory is not kept.
class ViewPyramid {
 public:
  /// `origin`: any point near the others; sums relative to it keep their digits.
  ViewPyramid(const Camera& camera, double aspect, const dvec3& origin, const Room& room = {});

  void add(const dvec3& point);
  void add(const Bounds& bounds);
  bool holds(const dvec3& point) const;
  bool empty() const { return low_depth_ > high_depth_; }
  const Room& room() const { return room_; }

  /// Whether the other one is for the same view, so that both can be joined.
  bool fits(const ViewPyramid& other) const;
  /// Around the points of both, which have the same view and origin.
  void join(const ViewPyramid& other);

  /// The point in the middle of the points' depths that the room's middle shows.
  dvec3 target() const;
  /// The distance from there, or from another point in the room's middle, at which the points
  /// just fill the room; 0 if there is none, as for a single point.
  double distance() const;
  double distance_from(const dvec3& target) const;
  /// How far toward the eye the nearest point is from a point.
  double nearest_to(const dvec3& target) const;

 private:
  /// Offsets of faces through a point: to the right and up, to the left and down.
  struct Offsets {
    dvec2 high, low;
  };
  dvec3 seen(const dvec3& point) const;  // in eye coordinates, from the origin
  Offsets offsets(const dvec3& seen) const;

  std::array<dvec3, 3> axes_;  // to the right, up and toward the eye
  dvec3 origin_;
  Room room_;
  dvec2 slopes_;  // of the pyramid's faces
  bool is_prism_;
  dvec2 high_, low_;  // the largest offsets
  double low_depth_, high_depth_;
};

/// Fits `camera` to what is in `bounds` (not empty) in a picture of width/height `aspect`. A target
/// and a distance that it leaves open are those at which `seen` fills its room (not given: the
/// box's corners); near and far enclose the box, whatever the distance. The target is drawn in the
/// middle of that room. An up vector along the view is replaced by one that is not.
/// Throws Error (Input) for a camera that is not possible.
FittedCamera fit_camera(const Camera& camera, const Bounds& bounds, double aspect,
                        const ViewPyramid* seen = nullptr);

/// The scene's camera in a picture that its scale stretches: the target is where the picture has
/// it.
Camera drawn_camera(const Scene& scene);

/// Its view and up vector have a length, its distance and zoom are positive, its fov is in (0,
/// 180), and all of them, with the target, are within the range of doubles.
bool is_possible(const Camera& camera);

/// Where a picture of `size` pixels shows a point of the world, from the upper left corner; nothing
/// for a point beside or behind the eye.
std::optional<dvec2> pixel_of(const FittedCamera& camera, const dvec3& point, const dvec2& size);

}  // namespace saddle
