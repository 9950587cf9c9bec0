// From the camera's few numbers to the transforms that the renderer needs.
#pragma once

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
  glm::dmat4 world_to_eye;  ///< rigid: the eye at the origin, looking down -z, y up
  glm::dmat4 eye_to_clip;   ///< perspective or orthographic, depth -1 to 1
  double near_plane = 0;    ///< distances along the view, both > 0 in perspective
  double far_plane = 1;
};

/// The part of a picture that what is looked at may take, the rest being for what is written.
struct Room {
  double across = 1;  ///< shares of the width and the height, in the middle
  double down = 1;
  bool holds_box = false;  ///< the whole bounding box must be in there
};

/// Fits `camera` to what is in `bounds` (not empty) in a picture of width/height `aspect`. Without
/// a distance the sphere of `radius` around the target fills the narrower side (radius not given:
/// that around the box), in a part of the picture if `room` leaves only that; near and far enclose
/// the box, whatever the distance. An up vector along the view is replaced by one that is not.
/// Throws Error (Input) for a view or up vector of length 0, a distance that is not positive, a fov
/// outside (0, 180).
FittedCamera fit_camera(const Camera& camera, const Bounds& bounds, double aspect,
                        std::optional<double> radius = std::nullopt, const Room& room = {});

/// Throws Error (Input), with the option's name: an angle, a direction, a distance or a target that
/// no camera can have.
void check_camera(const Camera& camera);

/// Where `camera` looks: its target, or the centre of the box.
dvec3 camera_target(const Camera& camera, const Bounds& bounds);

/// Where a picture of `size` pixels shows a point of the world, from the upper left corner; nothing
/// for a point beside or behind the eye.
std::optional<dvec2> pixel_of(const FittedCamera& camera, const dvec3& point, const dvec2& size);

}  // namespace saddle
