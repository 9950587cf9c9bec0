// Look-at and projection matrices in double. Lengths are the surface's own, angles radians inside;
// everything is measured from the target, so that a far-away surface keeps its digits.
#include "scene/model/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"

namespace saddle {
namespace {

/// Room around the fitted sphere, as a factor: a silhouette that touches the picture's border would
/// lose its antialiased edge and half of a grid line on it (a pixel of 100 is 2 %).
constexpr double kFitMargin = 1.02;

/// Sine of the angle between two directions below which their cross product, of relative error
/// 1e-16, no longer gives a direction to half of a double's digits.
constexpr double kParallel = 1e-8;

/// Added in front of and behind the box, in radii: a flat box that faces the eye has no depth of
/// its own, and float positions and polygon offset need room at both ends.
constexpr double kDepthPadding = 0.01;

/// The same in distances, for an eye so far away that the padding above would be rounded off.
constexpr double kDistancePadding = 1e-12;

/// Least near / far: 24 bits of depth resolve far^2 / (near 2^24), here 6e-5 of far, at the far
/// end.
constexpr double kLeastNearOverFar = 1e-3;

/// The bound never moves the near plane beyond this share of the target's distance: an eye close to
/// its target sees the rest of a large surface less exactly.
constexpr double kLeastNearOverDistance = 0.1;

/// std::hypot neither overflows nor underflows where the squares would.
double length(const dvec3& v) {
  return std::hypot(v.x, v.y, v.z);
}

/// Unit vector along `v` of any magnitude; `name` is the option that gave it.
dvec3 direction(const dvec3& v, const char* name) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
    throw Error(Status::Input, "the direction is not finite", {name, {}, {}});
  }
  if (!(largest > 0)) {
    throw Error(Status::Input, "the direction has length 0", {name, {}, {}},
                "give a vector with at least one component that is not 0");
  }
  return glm::normalize(v / largest);
}

/// Rows: the eye's right, up and backward axes in world coordinates.
struct Axes {
  dvec3 x, y, z;
};

Axes camera_axes(const Camera& camera) {
  const dvec3 z = direction(camera.view, "--view");
  for (const dvec3& up : {direction(camera.up, "--up"), dvec3(0, 1, 0), dvec3(0, 0, 1)}) {
    const dvec3 x = glm::cross(up, z);
    if (glm::length(x) > kParallel) {
      const dvec3 unit_x = glm::normalize(x);
      return {unit_x, glm::cross(z, unit_x), z};
    }
  }
  return {{1, 0, 0}, {0, 1, 0}, z};  // not reached: z is not parallel to both y and z
}

/// Radius of the sphere around `target` that holds the box. A box that is a point at the target
/// gets one that is visible among numbers of its magnitude.
double sphere_radius(const Bounds& bounds, const dvec3& target) {
  double radius = 0;
  for (const dvec3& corner : bounds.corners()) radius = std::max(radius, length(corner - target));
  return radius > 0 ? radius : std::max(1.0, length(target));
}

/// Distance at which a sphere of `radius` fills the narrower side of the room in the picture.
double fitting_distance(double radius, double half_fov, double aspect, bool ortho,
                        const Room& room) {
  // Half the narrower side at distance 1.
  const double slope = std::tan(half_fov) * std::min(room.down, aspect * room.across);
  const double ratio = ortho ? slope : slope / std::hypot(1.0, slope);  // sin(atan(slope))
  return kFitMargin * radius / ratio;
}

/// The least distance at which all corners of the box are in the room.
double distance_of_box(const Bounds& bounds, const FittedCamera& fitted, const Axes& axes,
                       const dvec2& slopes, bool ortho) {
  double least = 0;
  for (const dvec3& corner : bounds.corners()) {
    const dvec3 q = corner - fitted.target;
    const double nearer = ortho ? 0 : glm::dot(axes.z, q);
    least = std::max({least, nearer + std::abs(glm::dot(axes.x, q)) / slopes.x,
                      nearer + std::abs(glm::dot(axes.y, q)) / slopes.y});
  }
  return least;
}

}  // namespace

void check_camera(const Camera& camera) {
  direction(camera.view, "--view");
  direction(camera.up, "--up");
  if (!(camera.fov > 0 && camera.fov < 180)) {
    throw Error(Status::Input, "the field of view must be more than 0 and less than 180 degrees",
                {"--fov", {}, {}});
  }
  if (camera.distance && !(*camera.distance > 0 && std::isfinite(*camera.distance))) {
    throw Error(Status::Input, "the distance must be positive and finite", {"--distance", {}, {}});
  }
  if (camera.target && !std::isfinite(length(*camera.target))) {
    throw Error(Status::Input, "the target is not finite", {"--target", {}, {}});
  }
}

namespace {

void fit_depth(FittedCamera& fitted, const Bounds& bounds, const dvec3& backward, bool ortho) {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  for (const dvec3& corner : bounds.corners()) {
    const double depth = fitted.distance - glm::dot(backward, corner - fitted.target);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const double padding = kDepthPadding * sphere_radius(bounds, bounds.centre()) +
                         kDistancePadding * std::max(fitted.distance, std::abs(farthest));
  fitted.near_plane = nearest - padding;
  fitted.far_plane = farthest + padding;
  if (ortho) return;
  if (!(fitted.far_plane > 0)) fitted.far_plane = fitted.distance;  // all of it is behind the eye
  const double least =
      std::min(kLeastNearOverFar * fitted.far_plane, kLeastNearOverDistance * fitted.distance);
  fitted.near_plane = std::max(fitted.near_plane, least);
}

glm::dmat4 view_matrix(const Axes& axes, const dvec3& eye) {
  glm::dmat4 m(1);
  for (int i = 0; i < 3; ++i) {
    m[i][0] = axes.x[i];
    m[i][1] = axes.y[i];
    m[i][2] = axes.z[i];
  }
  m[3] = {-glm::dot(axes.x, eye), -glm::dot(axes.y, eye), -glm::dot(axes.z, eye), 1};
  return m;
}

/// `half_height`: half the visible height, at distance 1 in perspective.
glm::dmat4 projection(const FittedCamera& fitted, double half_height, double aspect, bool ortho) {
  const double n = fitted.near_plane;
  const double f = fitted.far_plane;
  glm::dmat4 m(0);
  m[0][0] = 1 / (half_height * aspect);
  m[1][1] = 1 / half_height;
  m[2][2] = (ortho ? -2 : -(f + n)) / (f - n);
  m[2][3] = ortho ? 0 : -1;
  m[3][2] = ortho ? -(f + n) / (f - n) : -2 * f * (n / (f - n));
  m[3][3] = ortho ? 1 : 0;
  return m;
}

}  // namespace

std::optional<dvec2> pixel_of(const FittedCamera& camera, const dvec3& point, const dvec2& size) {
  const dvec3 eye =
      glm::dmat3(camera.world_to_eye) * (point - camera.target) - dvec3(0, 0, camera.distance);
  const glm::dvec4 clip = camera.eye_to_clip * glm::dvec4(eye, 1);
  if (!(clip.w > 0)) return std::nullopt;
  return dvec2((1 + clip.x / clip.w) / 2 * size.x, (1 - clip.y / clip.w) / 2 * size.y);
}

dvec3 camera_target(const Camera& camera, const Bounds& bounds) {
  return camera.target.value_or(bounds.centre());
}

FittedCamera fit_camera(const Camera& camera, const Bounds& bounds, double aspect,
                        std::optional<double> radius, const Room& room) {
  check_camera(camera);
  const Axes axes = camera_axes(camera);
  const double half_fov = camera.fov * std::numbers::pi / 360;
  FittedCamera fitted;
  fitted.target = camera_target(camera, bounds);
  const bool known = radius && *radius > 0;
  const double sphere = known ? *radius : sphere_radius(bounds, fitted.target);
  double fit = fitting_distance(sphere, half_fov, aspect, camera.ortho, room);
  if (room.holds_box) {
    const dvec2 slopes = std::tan(half_fov) * dvec2(aspect * room.across, room.down);
    fit = std::max(fit, distance_of_box(bounds, fitted, axes, slopes, camera.ortho));
  }
  fitted.distance = camera.distance.value_or(fit);
  fitted.eye = fitted.target + fitted.distance * axes.z;
  fitted.world_to_eye = view_matrix(axes, fitted.eye);
  fit_depth(fitted, bounds, axes.z, camera.ortho);
  const double half_height = std::tan(half_fov) * (camera.ortho ? fitted.distance : 1);
  fitted.eye_to_clip = projection(fitted, half_height, aspect, camera.ortho);
  return fitted;
}

}  // namespace saddle
