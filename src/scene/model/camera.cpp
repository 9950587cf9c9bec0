// Look-at and projection matrices in double. Lengths are the surface's own, angles radians inside;
// everything is measured from the target, so that a far-away surface keeps its digits.
#include "scene/model/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"

namespace saddle {
namespace {

/// An eye this close to the nearest of the points, in radii of the sphere around them, is on it:
/// they are one behind the other, and have no size in the picture.
constexpr double kOnPoint = 1e-6;

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

double largest_part(const dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool is_direction(const dvec3& v) {
  return is_finite(v) && largest_part(v) > 0;
}

/// Unit vector along `v` of any magnitude.
dvec3 direction(const dvec3& v) {
  return glm::normalize(v / largest_part(v));
}

bool is_positive(double x) {
  return x > 0 && std::isfinite(x);
}

/// The eye's right, up and backward axes in world coordinates.
using Axes = std::array<dvec3, 3>;

Axes camera_axes(const Camera& camera) {
  dvec3 z = direction(camera.view);
  if (camera.turn != 0) {
    z = glm::angleAxis(camera.turn, direction(camera.up)) * z;
  }
  for (const dvec3& up : {direction(camera.up), dvec3(0, 1, 0), dvec3(0, 0, 1)}) {
    const dvec3 x = glm::cross(up, z);
    if (glm::length(x) > kParallel) {
      const dvec3 unit_x = glm::normalize(x);
      return {unit_x, glm::cross(z, unit_x), z};
    }
  }
  return {dvec3(1, 0, 0), dvec3(0, 1, 0), z};  // not reached: z is not parallel to both y and z
}

/// Half the height of the picture at distance 1, without the zoom.
double slope_of(const Camera& camera) {
  return std::tan(camera.fov * std::numbers::pi / 360);
}

/// Radius of the sphere around `target` that holds the box. A box that is a point at the target
/// gets one that is visible among numbers of its magnitude.
double sphere_radius(const Bounds& bounds, const dvec3& target) {
  double radius = 0;
  for (const dvec3& corner : bounds.corners()) radius = std::max(radius, length(corner - target));
  return radius > 0 ? radius : std::max(1.0, length(target));
}

/// Distance at which a sphere of `radius` fills the narrower side of the picture.
double distance_of_sphere(double radius, const Camera& camera, double aspect) {
  const double slope = slope_of(camera) * std::min(1.0, aspect);
  return radius / (camera.ortho ? slope : slope / std::hypot(1.0, slope));  // sin(atan(slope))
}

}  // namespace

ViewPyramid::ViewPyramid(const Camera& camera, double aspect, const dvec3& origin, const Room& room)
    : axes_(camera_axes(camera)),
      origin_(origin),
      room_(room),
      slopes_(slope_of(camera) * dvec2(aspect * room.across, room.down)),
      is_prism_(camera.ortho),
      high_(-std::numeric_limits<double>::infinity()),
      low_(high_),
      low_depth_(-high_.x),
      high_depth_(high_.x) {}

dvec3 ViewPyramid::seen(const dvec3& point) const {
  const dvec3 way = point - origin_;
  return {glm::dot(axes_[0], way), glm::dot(axes_[1], way), glm::dot(axes_[2], way)};
}

ViewPyramid::Offsets ViewPyramid::offsets(const dvec3& seen) const {
  const dvec2 opened = is_prism_ ? dvec2(0) : seen.z * slopes_;
  return {opened + dvec2(seen), opened - dvec2(seen)};
}

void ViewPyramid::add(const dvec3& point) {
  const dvec3 p = seen(point);
  const auto [high, low] = offsets(p);
  high_ = glm::max(high_, high);
  low_ = glm::max(low_, low);
  low_depth_ = std::min(low_depth_, p.z);
  high_depth_ = std::max(high_depth_, p.z);
}

bool ViewPyramid::holds(const dvec3& point) const {
  const dvec3 p = seen(point);
  const auto [high, low] = offsets(p);
  return glm::all(glm::lessThanEqual(high, high_)) && glm::all(glm::lessThanEqual(low, low_)) &&
         p.z >= low_depth_ && p.z <= high_depth_;
}

void ViewPyramid::add(const Bounds& bounds) {
  for (const dvec3& corner : bounds.corners()) add(corner);
}

bool ViewPyramid::fits(const ViewPyramid& other) const {
  return axes_ == other.axes_ && origin_ == other.origin_ && slopes_ == other.slopes_ &&
         room_.middle == other.room_.middle && is_prism_ == other.is_prism_;
}

void ViewPyramid::join(const ViewPyramid& other) {
  high_ = glm::max(high_, other.high_);
  low_ = glm::max(low_, other.low_);
  low_depth_ = std::min(low_depth_, other.low_depth_);
  high_depth_ = std::max(high_depth_, other.high_depth_);
}

dvec3 ViewPyramid::target() const {
  const dvec2 middle = 0.5 * (high_ - low_);
  return origin_ + middle.x * axes_[0] + middle.y * axes_[1] +
         0.5 * (low_depth_ + high_depth_) * axes_[2];
}

double ViewPyramid::distance() const {
  return distance_from(target());
}

double ViewPyramid::distance_from(const dvec3& target) const {
  const dvec3 p = seen(target);
  const dvec2 apex = glm::max(high_ - dvec2(p), low_ + dvec2(p)) / slopes_;
  return std::max(apex.x, apex.y) - (is_prism_ ? 0 : p.z);
}

double ViewPyramid::nearest_to(const dvec3& target) const {
  return high_depth_ - seen(target).z;
}

bool is_possible(const Camera& camera) {
  return is_direction(camera.view) && is_direction(camera.up) && camera.fov > 0 &&
         camera.fov < 180 && (!camera.distance || is_positive(*camera.distance)) &&
         is_positive(camera.zoom) && (!camera.target || std::isfinite(length(*camera.target)));
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
    for (int k = 0; k < 3; ++k) m[i][k] = axes[static_cast<std::size_t>(k)][i];
  }
  m[3] = {-glm::dot(axes[0], eye), -glm::dot(axes[1], eye), -glm::dot(axes[2], eye), 1};
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
  for (int column = 0; column < 4; ++column) m[column][0] += fitted.middle * m[column][3];
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

Camera drawn_camera(const Scene& scene) {
  Camera camera = scene.camera;
  if (camera.target) camera.target = dvec3(*camera.target) * dvec3(scene.scale.factors);
  return camera;
}

FittedCamera fit_camera(const Camera& camera, const Bounds& bounds, double aspect,
                        const ViewPyramid* seen) {
  if (!is_possible(camera)) {
    throw Error(Status::Input, "no camera stands so far away: its numbers are beyond doubles",
                {camera.target ? "--target" : "--distance", {}, {}}, "give a place that is nearer");
  }
  const Axes axes = camera_axes(camera);
  FittedCamera fitted;
  fitted.middle = seen != nullptr ? seen->room().middle : 0;
  ViewPyramid corners(camera, aspect, bounds.centre());
  if (!seen || seen->empty()) {
    corners.add(bounds);
    seen = &corners;
  }
  fitted.target = camera.target ? dvec3(*camera.target) : seen->target();
  const auto fit = [&]() -> double {
    const double distance = seen->distance_from(fitted.target);
    const double radius = sphere_radius(bounds, fitted.target);
    if (distance > 0 &&
        (camera.ortho || distance - seen->nearest_to(fitted.target) > kOnPoint * radius))
      return distance;
    return distance_of_sphere(radius, camera, aspect);
  };
  fitted.distance = camera.distance ? static_cast<double>(*camera.distance) : fit();
  fitted.eye = fitted.target + fitted.distance * axes[2];
  fitted.world_to_eye = view_matrix(axes, fitted.eye);
  fit_depth(fitted, bounds, axes[2], camera.ortho);
  fitted.half_height = slope_of(camera) / camera.zoom * fitted.distance;
  fitted.eye_to_clip = projection(fitted, fitted.half_height / (camera.ortho ? 1 : fitted.distance),
                                  aspect, camera.ortho);
  return fitted;
}

}  // namespace saddle
