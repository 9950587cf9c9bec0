#include "meshing/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>

#include "mesh/robust_box.h"
#include "scene/camera.h"
#include "scene/instances.h"

namespace saddle {
namespace {

/// Distance of mesh and surface that no eye sees in a picture, in pixels, and what a mesh for other
/// programs may be off by, as a share of its bounding box's diagonal.
constexpr ToleranceValue kPictureTolerance = {0.5, true};
constexpr ToleranceValue kMeshTolerance = {1e-3, false};
/// An eye in the midst of the surface sees parts of it at any distance; nearer ones than this part
/// of its extent, or of the target's distance, are drawn more coarsely than asked.
constexpr double kNearest = 0.05;
/// Samples that go so many times as far as nine tenths of them do are on their way to infinity.
constexpr double kFarOut = 3;
/// What goes to infinity is shown so many times as far as the surface's other sides are long, if
/// that shows half of it: beside the spikes of 1/(u v) its square would be too small to be seen.
constexpr double kTall = 4;
/// A part of so many of the samples is worth a picture: more than one of the probe's 64 columns.
constexpr double kReadable = 0.02;
/// The part is narrower than the whole, and so again is what is in proportion to it.
constexpr int kNarrowings = 8;
constexpr double kAsNarrow = 0.9;
/// An eye is close to a surface whose nearest part has pixels smaller than this share of those of a
/// picture that it fills: then each part of it has its own, and what is not seen has large ones.
constexpr double kClose = 0.5;
/// Half the picture's size times this is how far beside the picture a surface is still as fine as
/// in it: the hand soon turns it there. Farther out cells grow with the distance.
constexpr double kMargin = 0.5;
/// A surface may go beyond its samples by this part of their extent without being clipped.
constexpr double kBeyondProbe = 0.1;

std::vector<ToleranceValue> asked(const Scene& scene, const Purpose& purpose) {
  if (scene.mesh.tolerance) return {*scene.mesh.tolerance};
  std::vector<ToleranceValue> tolerances;
  if (purpose.picture) tolerances.push_back(kPictureTolerance);
  if (purpose.mesh) tolerances.push_back(kMeshTolerance);
  return tolerances;
}

/// The larger of the other two sides.
double next_longest(const dvec3& size, int axis) {
  return std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
}

/// What of the surface is in the box.
Bounds visible(const Probe& probe, const std::optional<Bounds>& clip) {
  Bounds bounds = probe.bounds();
  if (!clip) return bounds;
  bounds.low = glm::max(bounds.low, clip->low);
  bounds.high = glm::min(bounds.high, clip->high);
  return bounds;
}

/// The side of a pixel on a surface that a node has put somewhere, in the surface's own units of
/// length.
class PixelSize {
 public:
  PixelSize(const Camera& camera, const PictureSettings& picture, const glm::dmat4& place,
            const Probe& probe, const std::optional<Bounds>& clip)
      : place_(place), stretch_(largest_stretch(place)), ortho_(camera.ortho) {
    const Bounds bounds = transformed(visible(probe, clip), place);
    const double aspect = static_cast<double>(picture.width) / picture.height;
    const dvec3 target = camera_target(camera, bounds);
    const double to_corner =
        glm::length(glm::max(glm::abs(bounds.low - target), glm::abs(bounds.high - target)));
    const bool in_world = place == glm::dmat4(1);
    const double radius = in_world ? std::min(probe.radius(target), to_corner) : to_corner;
    camera_ = fit_camera(camera, bounds, aspect, radius);
    const double tangent = std::tan(camera.fov / 2 * std::numbers::pi / 180);
    half_ = {aspect * tangent, tangent};
    per_length_ = 2 / static_cast<double>(picture.height) / stretch_;
    const double depth =
        ortho_ ? camera_.distance : std::max(camera_.distance - radius, kNearest * radius);
    nearest_ = depth * tangent * per_length_;
    whole_ = radius * per_length_;
    is_close_ = nearest_ < kClose * whole_;
  }

  bool depends_on_place() const { return is_close_; }

  /// The least within `reach` of a place of the surface. An eye that is far enough to see most of
  /// the surface has one size for all of it, that of the nearest part.
  double operator()(const dvec3& p, double reach) const {
    if (!is_close_) return nearest_;
    const dvec3 from_target = dvec3(place_ * glm::dvec4(p, 1)) - camera_.target;
    const dvec3 seen = glm::dmat3(camera_.world_to_eye) * from_target;
    const double depth = ortho_ ? camera_.distance : camera_.distance - seen.z;
    const double out = beside(seen, depth) - reach * stretch_;
    const double near =
        std::max(kNearest * camera_.distance, depth - (ortho_ ? 0 : reach * stretch_));
    const double size = near * half_.y * per_length_;
    if (!(out > 0)) return std::min(size, whole_);
    const double share = std::max(1.0, out / (kMargin * near * half_.y));
    return std::min(share * share * size, whole_);
  }

 private:
  /// How far a point, relative to the target, is from what the picture shows; less than 0: inside.
  double beside(const dvec3& seen, double depth) const {
    double most = -depth;
    for (int k = 0; k < 2; ++k) {
      const double off = std::fabs(seen[k]) - half_[k] * depth;
      most = std::max(most, ortho_ ? off : off / std::hypot(1, half_[k]));
    }
    return most;
  }

  glm::dmat4 place_;
  double stretch_;
  bool ortho_;
  FittedCamera camera_;
  dvec2 half_;         ///< of the picture, at distance 1
  double per_length_;  ///< pixels' size for half the picture's height at a depth
  double nearest_;     ///< on the nearest part of the surface
  double whole_;       ///< if half the picture were as high as the surface
  bool is_close_;
};

/// A camera, and a place of the surface that it looks at.
struct View {
  Camera camera;
  glm::dmat4 place;
};

/// Those of all moments. What rests from one moment to the next is there once.
std::vector<View> views(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose) {
  std::vector<View> result;
  if (purpose.moments.empty()) {
    for (const glm::dmat4& place : places(scene, spec)) result.push_back({scene.camera, place});
  }
  std::vector<glm::dmat4> last;
  for (std::size_t k = 0; k < purpose.moments.size(); ++k) {
    const Moment& moment = purpose.moments[k];
    const std::vector<glm::dmat4> now = places(moment.nodes, spec);
    const bool rests = k > 0 && purpose.moments[k - 1].camera == moment.camera;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (!rests || now[i] != last[i]) result.push_back({moment.camera, now[i]});
    }
    last = now;
  }
  return result;
}

}  // namespace

Tolerance tolerance_of(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                       const Probe& probe, const std::optional<Bounds>& clip) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  if (probe.bounds().empty()) return kAny;
  const double diagonal = visible(probe, clip).diagonal();
  double length = kAny;
  double pixels = kAny;
  for (const auto& [value, is_in_pixels] : asked(scene, purpose)) {
    double& least = is_in_pixels ? pixels : length;
    least = std::min(least, is_in_pixels ? value : value * diagonal);
  }
  if (pixels == kAny) return length;
  double same_everywhere = kAny;
  std::vector<PixelSize> sizes;  // that are not
  for (const auto& [camera, place] : views(scene, spec, purpose)) {
    if (largest_stretch(place) == 0) continue;  // drawn as nothing
    PixelSize size(camera, scene.picture, place, probe, clip);
    if (size.depends_on_place()) {
      sizes.push_back(size);
    } else {
      same_everywhere = std::min(same_everywhere, size(dvec3(0), 0));
    }
  }
  if (sizes.empty() && same_everywhere == kAny) same_everywhere = diagonal;
  if (sizes.empty()) return std::min(length, pixels * same_everywhere);
  return [=](const dvec3& p, double reach) {
    double pixel = same_everywhere;
    for (const PixelSize& size : sizes) pixel = std::min(pixel, size(p, reach));
    return std::min(length, pixels * pixel);
  };
}

Bounds clip_box(const Bounds& all, std::span<const dvec3> points) {
  const Bounds most = robust_box(points);
  const auto is_far_out = [&](int k) {
    const double size = all.size()[k];
    return size > kFarOut * most.size()[k] || size > kTall * next_longest(all.size(), k);
  };
  double usual = 0;  // the largest side that needs no clipping
  for (int k = 0; k < 3; ++k) {
    if (!is_far_out(k)) usual = std::max(usual, all.size()[k]);
  }
  const Bounds shapely = usual > 0 ? robust_box(points, dvec3(kTall * usual)) : most;
  Bounds box;
  for (int k = 0; k < 3; ++k) {
    const Bounds& kept = is_far_out(k) ? shapely : all;
    const double margin = is_far_out(k) ? 0 : kBeyondProbe * all.size()[k];
    box.low[k] = kept.low[k] - margin;
    box.high[k] = kept.high[k] + margin;
  }
  return box;
}

namespace {

int longest_axis(const dvec3& size) {
  return size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
}

Bounds bounds_of(std::span<const dvec3> points) {
  Bounds bounds;
  for (const dvec3& p : points) bounds.add(p);
  return bounds;
}

/// The points of the window of this length along an axis that holds most of them. `sorted` along
/// that axis.
std::span<const dvec3> fullest_window(std::span<const dvec3> sorted, int axis, double length) {
  std::size_t best = 0;
  std::size_t most = 0;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < sorted.size(); ++begin) {
    while (end < sorted.size() && sorted[end][axis] <= sorted[begin][axis] + length) ++end;
    if (end - begin <= most) continue;
    most = end - begin;
    best = begin;
  }
  return sorted.subspan(best, most);
}

/// clip_box(), open at the faces that the surface goes beyond by no more than the box is long.
Bounds box_without_far_edges(const Bounds& all, std::span<const dvec3> points) {
  Bounds box = clip_box(all, points);
  const dvec3 near = box.size();
  for (int k = 0; k < 3; ++k) {
    if (box.low[k] - all.low[k] <= near[k]) box.low[k] = -kNoFace;
    if (all.high[k] - box.high[k] <= near[k]) box.high[k] = kNoFace;
  }
  return box;
}

/// Whether a box leaves some of each side of a surface that has any: of a peak that no sample has
/// met it leaves none.
bool shows_some(const Bounds& box, const Bounds& whole) {
  const dvec3 seen = glm::min(box.high, whole.high) - glm::max(box.low, whole.low);
  bool shows = true;
  for (int k = 0; k < 3; ++k) shows = shows && (seen[k] > 0 || !(whole.size()[k] > 0));
  return shows;
}

}  // namespace

std::optional<Bounds> readable_box(const Bounds& whole, std::span<const dvec3> points) {
  if (points.empty()) return std::nullopt;
  const Bounds all = bounds_of(points);
  const dvec3 beyond = whole.size() - kNeedle * all.diagonal();
  if (std::max({beyond.x, beyond.y, beyond.z}) > 0) {
    const Bounds box = box_without_far_edges(whole, points);
    return shows_some(box, whole) ? std::optional(box) : std::nullopt;
  }
  const int axis = longest_axis(all.size());
  double usual = next_longest(all.size(), axis);
  if (!(all.size()[axis] > kNeedle * usual)) {
    // Along more than one axis, some may go far beyond the others.
    if (!(all.diagonal() > kNeedle * rough_box(points).diagonal())) return std::nullopt;
    const Bounds box = box_without_far_edges(whole, points);
    return shows_some(box, whole) ? std::optional(box) : std::nullopt;
  }
  std::vector<dvec3> sorted(points.begin(), points.end());
  std::ranges::sort(sorted, {}, [axis](const dvec3& p) { return p[axis]; });
  const double least = kReadable * static_cast<double>(points.size());
  std::optional<Bounds> box;
  std::span<const dvec3> part = sorted;
  for (int k = 0; k < kNarrowings; ++k) {
    const double length = kTall * usual;
    part = fullest_window(part, axis, length);
    if (static_cast<double>(part.size()) < least) break;
    box = Bounds{dvec3(-kNoFace), dvec3(kNoFace)};
    const double first = part.front()[axis];
    if (part.data() != sorted.data()) box->low[axis] = first;
    if (first + length < all.high[axis]) box->high[axis] = first + length;
    const double narrower = next_longest(bounds_of(part).size(), axis);
    if (narrower >= kAsNarrow * usual) break;
    usual = narrower;
  }
  return box;
}

double tolerance_share(const Scene& scene, const Purpose& purpose) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [value, pixels] : asked(scene, purpose)) {
    least = std::min(least,
                     pixels ? value / std::max(scene.picture.width, scene.picture.height) : value);
  }
  return least;
}

}  // namespace saddle
