// How a hand moves the camera: a camera before, what the hand does, a camera after. Pixels are
// counted from the picture's upper left.
#pragma once

#include "base/vec.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

/// A camera at the moment a hand takes hold of it.
struct Grip {
  Camera camera;
  FittedCamera fitted;   ///< of that camera
  dvec2 size{1, 1};      ///< of the picture, in pixels
  dvec3 scale{1, 1, 1};  ///< of the picture along the axes
};

/// A straight line of sight; `direction` has length 1 in the coordinates of the world.
struct Ray {
  dvec3 origin;
  dvec3 direction;
};

/// The ray through a pixel: from the eye, or with an orthographic camera from its plane.
Ray ray_through(const Grip& grip, const dvec2& pixel);

/// The point under a pixel on the plane through the target that faces the eye.
dvec3 point_on_target_plane(const Grip& grip, const dvec2& pixel);

/// The camera with its target and distance as numbers, which do not follow the surface any more;
/// a turntable stands still. A camera that a hand has turned or moved is so: fitted anew in each
/// direction, the surface would grow and shrink under the hand.
Camera settled(const Grip& grip);

/// A ball as large as the picture, around the target, is turned under the pointer from `from` to
/// `to`. It depends on these places alone, not on the way between them: there and back again is
/// where it was, and no axis is special.
/// Source: G. Bell, "Bell's trackball", 1988: a sphere that becomes a hyperbolic sheet outside, so
/// that there is no edge to fall off.
Camera turned_on_ball(const Grip& grip, const dvec2& from, const dvec2& to);

/// Turned around `up`, which stays up in the picture, and up or down as far as the poles. A way
/// across the picture's smaller side is half a turn.
Camera turned_on_table(const Grip& grip, const dvec3& up, const dvec2& from, const dvec2& to);

/// Moved in the plane of the picture, so that `held`, a point in front of the eye, goes from `from`
/// to `to` with the pointer.
Camera moved(const Grip& grip, const dvec3& held, const dvec2& from, const dvec2& to);

/// `factor` times as far from `fixed`, which stays under its pixel; as near and far as makes sense
/// for a surface of this size.
Camera zoomed(const Grip& grip, const dvec3& fixed, double factor, double surface_size);

/// The factor of zoomed() for a turn of the wheel by so many notches (a touchpad gives parts of
/// them).
double zoom_factor(double notches);

/// Seen along an axis, 0 to 2, from its positive side; from the other side if it is seen from there
/// already.
Camera seen_along(const Camera& camera, int axis);

/// The whole surface in the picture, whatever it becomes.
Camera fit_again(const Camera& camera);

}  // namespace saddle
