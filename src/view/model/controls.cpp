#include "view/model/controls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace saddle {
namespace {

/// A notch of the wheel.
constexpr double kNotch = 1.15;

/// An eye nearer than this part of the surface's size would see the rounding of its corners to
/// floats (6e-8), and one farther than this many sizes no more than a dot.
constexpr double kNearest = 1e-4;
constexpr double kFarthest = 1e3;

/// From the poles of the turntable, in radians: there no direction would be up. A thousandth of a
/// pixel in a picture of a thousand.
constexpr double kFromPole = 1e-6;

struct EyeAxes {
  dvec3 right, up, backward;
};

EyeAxes axes_of(const FittedCamera& camera) {
  const glm::dmat3 eye_to_world = glm::transpose(glm::dmat3(camera.world_to_eye));
  return {eye_to_world[0], eye_to_world[1], eye_to_world[2]};
}

/// Length on the target plane of a pixel.
double pixel_length(const Grip& grip) {
  return 2 * grip.fitted.half_height / grip.size.y;
}

/// Where a pixel is from the target's, to the right and up, in pixels.
dvec2 from_target(const Grip& grip, const dvec2& pixel) {
  const dvec2 way = pixel - *pixel_of(grip.fitted, grip.fitted.target, grip.size);
  return {way.x, -way.y};
}

/// The point of the ball over a pixel, a unit vector in eye coordinates.
dvec3 on_ball(const Grip& grip, const dvec2& pixel) {
  const dvec2 p = from_target(grip, pixel) / (std::min(grip.size.x, grip.size.y) / 2);
  const double square = glm::dot(p, p);
  return glm::normalize(dvec3(p, square <= 0.5 ? std::sqrt(1 - square) : 0.5 / std::sqrt(square)));
}

}  // namespace

Ray ray_through(const Grip& grip, const dvec2& pixel) {
  const dvec3 point = point_on_target_plane(grip, pixel);
  const FittedCamera& camera = grip.fitted;
  if (!grip.camera.ortho) return {camera.eye, glm::normalize(point - camera.eye)};
  const dvec3 backward = axes_of(camera).backward;
  return {point + camera.distance * backward, -backward};
}

dvec3 point_on_target_plane(const Grip& grip, const dvec2& pixel) {
  const EyeAxes axes = axes_of(grip.fitted);
  const dvec2 way = pixel_length(grip) * from_target(grip, pixel);
  return grip.fitted.target + way.x * axes.right + way.y * axes.up;
}

Camera settled(const Grip& grip) {
  Camera camera = grip.camera;
  camera.target = grip.fitted.target / grip.scale;
  camera.distance = grip.fitted.distance;
  if (camera.turn != 0) camera.view = axes_of(grip.fitted).backward;
  camera.turntable = false;
  camera.turn = 0;
  return camera;
}

Camera turned_on_ball(const Grip& grip, const dvec2& from, const dvec2& to) {
  const glm::dquat turn(on_ball(grip, to), on_ball(grip, from));  // of the eye, against the ball's
  const EyeAxes axes = axes_of(grip.fitted);
  const glm::dmat3 eye_to_world(axes.right, axes.up, axes.backward);
  Camera camera = settled(grip);
  camera.view = eye_to_world * (turn * dvec3(0, 0, 1));
  camera.up = eye_to_world * (turn * dvec3(0, 1, 0));
  return camera;
}

Camera turned_on_table(const Grip& grip, const dvec3& up, const dvec2& from, const dvec2& to) {
  const double radians = std::numbers::pi / std::min(grip.size.x, grip.size.y);
  const EyeAxes axes = axes_of(grip.fitted);
  const dvec3 pole = glm::normalize(up);
  // Level, to the right in the picture; where the eye looks along the pole, what is right there.
  dvec3 right = axes.right - glm::dot(axes.right, pole) * pole;
  if (!(glm::length(right) > kFromPole)) right = glm::cross(axes.up, pole);
  right = glm::normalize(right);
  const dvec3 ahead = glm::cross(pole, right);
  const double height = std::asin(std::clamp(glm::dot(axes.backward, pole), -1.0, 1.0));
  const double most = std::numbers::pi / 2 - kFromPole;
  const double new_height = std::clamp(height + (to.y - from.y) * radians, -most, most);
  const double around = (to.x - from.x) * radians;
  const dvec3 level = -std::cos(around) * ahead - std::sin(around) * right;
  Camera camera = settled(grip);
  camera.view = std::cos(new_height) * level + std::sin(new_height) * pole;
  camera.up = pole;
  return camera;
}

Camera moved(const Grip& grip, const dvec3& held, const dvec2& from, const dvec2& to) {
  const EyeAxes axes = axes_of(grip.fitted);
  Camera camera = settled(grip);
  double length = pixel_length(grip);
  if (!camera.ortho) {
    length *= glm::dot(axes.backward, grip.fitted.eye - held) / grip.fitted.distance;
  }
  const dvec3 way = (to.y - from.y) * axes.up - (to.x - from.x) * axes.right;
  camera.target = (grip.fitted.target + length * way) / grip.scale;
  return camera;
}

Camera zoomed(const Grip& grip, const dvec3& fixed, double factor, double surface_size) {
  const double distance = grip.fitted.distance;
  const double nearest = std::min(kNearest * surface_size, distance);
  const double farthest = std::max(kFarthest * surface_size, distance);
  const double real_factor = std::clamp(factor * distance, nearest, farthest) / distance;
  Camera camera = settled(grip);
  camera.target = (fixed + real_factor * (grip.fitted.target - fixed)) / grip.scale;
  camera.distance = real_factor * distance;
  return camera;
}

double zoom_factor(double notches) {
  return std::pow(kNotch, -notches);
}

Camera seen_along(const Camera& camera, int axis) {
  dvec3 view(0);
  view[axis] = 1;
  Camera result = camera;
  const bool is_there =
      glm::cross(dvec3(camera.view), view) == dvec3(0) && glm::dot(dvec3(camera.view), view) > 0;
  result.view = is_there ? -view : view;
  result.up = axis == 2 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  return result;
}

Camera fit_again(const Camera& camera) {
  Camera result = camera;
  result.target.reset();
  result.distance.reset();
  return result;
}

}  // namespace saddle
