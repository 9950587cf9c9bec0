#include "meshing/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "base/numbers.h"
#include "mesh/sizing/effort.h"
#include "scene/model/instances.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// Triangles at most; and where no tolerance is asked for, unless the picture has more pixels. Each
/// takes 3 to 7 microseconds and 1 kB.
constexpr std::size_t kMostTriangles = 4'000'000;
constexpr std::size_t kEnoughTriangles = 1'000'000;
/// The triangles of several surfaces together. Each has the same share, but at least that of a
/// small one. The share bounds the work, too: up to 30 microseconds for a triangle with its checks
/// and drawing, 45 s in all. Effort that does not depend on triangles is no more than all of these
/// may take.
constexpr std::size_t kMostOfSeveral = 1'500'000;
constexpr std::size_t kLeastOfSeveral = 300;
/// A mesh takes 1 kB for each triangle when it is finished, and twice as much is left for the steps
/// of the heap's growth and for the picture or file that is made of it.
constexpr std::uint64_t kBytesPerTriangle = 3000;
/// Triangles for --max-time: a first mesh must not take longer than there is, with its checks.
constexpr double kTrianglesPerSecond = 100'000;

/// A mesh for other programs may be off by so much, as a share of its bounding box's diagonal.
constexpr ToleranceValue kMeshTolerance = {1e-3, false};
/// An eye in the midst of the surface sees parts of it at any distance; nearer ones than this part
/// of its extent, or of the target's distance, are drawn more coarsely than asked.
constexpr double kNearest = 0.05;
/// An eye is close to a surface whose nearest part has pixels smaller than this share of those of a
/// picture that it fills: then each part of it has its own, and what is not seen has large ones. A
/// fitted camera is not, but for surfaces that are long toward the eye.
constexpr double kClose = 0.35;
/// The side of a pixel on a surface beside the picture, as a share of the radius of its box: as
/// coarse as a mesh that still tells where the surface is.
constexpr double kUnseen = 0.5;
/// Half the picture's size times this is how far beside the picture a surface is still as fine as
/// in it: the hand soon turns it there. Farther out cells grow with the distance.
constexpr double kMargin = 0.5;

std::vector<ToleranceValue> asked(const Scene& scene, const Purpose& purpose) {
  if (scene.mesh.tolerance) return {*scene.mesh.tolerance};
  std::vector<ToleranceValue> tolerances;
  if (purpose.picture) tolerances.push_back({purpose.pixels, true});
  if (purpose.mesh) tolerances.push_back(kMeshTolerance);
  return tolerances;
}

/// The part of the surface's box that is in the clip box.
Bounds visible(const Probe& probe, const std::optional<Bounds>& clip) {
  Bounds bounds = probe.bounds();
  if (!clip) return bounds;
  bounds.low = glm::max(bounds.low, clip->low);
  bounds.high = glm::min(bounds.high, clip->high);
  return bounds;
}

/// The part of a surface in the clip box: a box, and samples' positions in it.
struct VisiblePart {
  Bounds bounds;
  std::vector<dvec3> positions;
};

VisiblePart visible_part(const Probe& probe, const std::optional<Bounds>& clip) {
  const std::span<const dvec3> inside = probe.positions();
  const std::vector<dvec3> edges = probe.edge_positions();
  std::vector<dvec3> positions;
  positions.reserve(inside.size() + edges.size());
  positions.assign(inside.begin(), inside.end());
  positions.insert(positions.end(), edges.begin(), edges.end());
  if (clip) std::erase_if(positions, [&](const dvec3& p) { return !clip->contains(p); });
  return {visible(probe, clip), std::move(positions)};
}

/// The side of a pixel on a surface that a node has put somewhere, in the surface's own units of
/// length.
class PixelSize {
 public:
  PixelSize(const Camera& camera, const PictureSettings& picture, const glm::dmat4& place,
            const VisiblePart& part)
      : place_(place), stretch_(largest_stretch(place)), ortho_(camera.ortho) {
    const Bounds bounds = transformed(part.bounds, place);
    const double aspect = static_cast<double>(picture.width) / picture.height;
    ViewPyramid seen(camera, aspect, bounds.centre());
    add_points(part.positions, part.bounds, place, seen);
    if (seen.empty()) seen.add(bounds);
    camera_ = fit_camera(camera, bounds, aspect, &seen);
    const double tangent = camera_.half_height / camera_.distance;
    half_ = {aspect * tangent, tangent};
    per_length_ = 2 / static_cast<double>(picture.height) / stretch_;
    const double radius = 0.5 * bounds.diagonal();
    const double depth =
        ortho_ ? camera_.distance
               : std::max(camera_.distance - seen.nearest_to(camera_.target), kNearest * radius);
    nearest_ = depth * tangent * per_length_;
    whole_ = radius * per_length_;
    is_close_ = nearest_ < kClose * whole_;
    if (is_out_of_reach(bounds.centre(), radius))
      nearest_ = std::max(nearest_, kUnseen * radius / stretch_);
  }

  bool depends_on_place() const { return is_close_; }
  /// The least on all of the surface; 0: it is not known.
  double least() const { return is_close_ ? 0 : nearest_; }

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
  /// A ball is farther beside the picture than the hand turns it at once.
  bool is_out_of_reach(const dvec3& centre, double radius) const {
    if (is_close_) return false;
    const dvec3 seen = glm::dmat3(camera_.world_to_eye) * (centre - camera_.target);
    const double depth = ortho_ ? camera_.distance : camera_.distance - seen.z;
    return beside(seen, depth) - radius > kMargin * std::max(depth, 0.0) * half_.y;
  }

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

/// The views of all moments. A place that does not change from one moment to the next is there
/// once.
std::vector<View> views(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose) {
  std::vector<View> result;
  if (purpose.moments.empty()) {
    const Camera camera = drawn_camera(scene);
    for (const glm::dmat4& place : places(scene, spec)) result.push_back({camera, place});
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

/// A view, and a size that no pixel on the surface is below.
using BoundedView = std::pair<double, const View*>;

/// The views that show something, by their bounds. Where a camera's place is given, the corners of
/// a surface's box bound its pixels.
std::vector<BoundedView> by_bounds(const std::vector<View>& views, const PictureSettings& picture,
                                   const VisiblePart& part) {
  std::vector<BoundedView> result;
  for (const View& view : views) {
    if (largest_stretch(view.place) == 0) continue;  // drawn as nothing
    const bool is_fixed = view.camera.target && view.camera.distance && views.size() > 1;
    const double bound =
        is_fixed ? PixelSize(view.camera, picture, view.place, {part.bounds, {}}).least() : 0;
    result.emplace_back(bound, &view);
  }
  std::ranges::stable_sort(result, {}, &BoundedView::first);
  return result;
}

glm::dmat4 true_of_stretched(const Purpose& purpose) {
  return glm::scale(glm::dmat4(1), 1.0 / purpose.stretch);
}

double diagonal_of(const VisiblePart& part, const Purpose& purpose) {
  return transformed(part.bounds, true_of_stretched(purpose)).diagonal() *
         least_of(purpose.stretch);
}

/// The side of the least pixel on a part of a surface, in any of its views.
Tolerance pixel_of_part(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                        const VisiblePart& part) {
  double same_everywhere = kInfinity;
  std::vector<PixelSize> sizes;  // that are not
  std::vector<View> all = views(scene, spec, purpose);
  for (View& view : all) view.place = view.place * true_of_stretched(purpose);
  for (const auto& [bound, view] : by_bounds(all, scene.picture, part)) {
    if (bound >= same_everywhere) break;  // those behind have larger pixels, too
    PixelSize size(view->camera, scene.picture, view->place, part);
    if (size.depends_on_place()) {
      sizes.push_back(size);
    } else {
      same_everywhere = std::min(same_everywhere, size(dvec3(0), 0));
    }
  }
  if (!sizes.empty()) {
    return [=](const dvec3& p, double reach) {
      double pixel = same_everywhere;
      for (const PixelSize& size : sizes) pixel = std::min(pixel, size(p, reach));
      return pixel;
    };
  }
  return same_everywhere < kInfinity ? same_everywhere : diagonal_of(part, purpose);
}

Tolerance tolerance_of_part(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                            const VisiblePart& part) {
  const double diagonal = diagonal_of(part, purpose);
  double length = kInfinity;
  double pixels = kInfinity;
  for (const auto& [value, is_in_pixels] : asked(scene, purpose)) {
    double& least = is_in_pixels ? pixels : length;
    least = std::min(least, is_in_pixels ? value : value * diagonal);
  }
  if (pixels == kInfinity) return length;
  return pixel_of_part(scene, spec, purpose, part).times(pixels).at_most(length);
}

}  // namespace

Tolerance tolerance_of(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                       const Probe& probe, const std::optional<Bounds>& clip) {
  if (probe.bounds().empty()) return kInfinity;
  return tolerance_of_part(scene, spec, purpose, visible_part(probe, clip));
}

Tolerance tolerance_of(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                       const Bounds& bounds, std::vector<dvec3> positions) {
  return tolerance_of_part(scene, spec, purpose, {bounds, std::move(positions)});
}

LineCounts lines_in_picture(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                            const Probe& probe, const Tolerance& tolerance) {
  const auto [u, v] = spec.grid_lines();
  if (spec.grid || !purpose.picture) return {u, v};
  const std::vector<ToleranceValue> values = asked(scene, purpose);
  const bool is_in_pixels = values.size() == 1 && values[0].pixels;
  const Tolerance pixel =
      is_in_pixels ? tolerance.times(1 / values[0].value)
                   : pixel_of_part(scene, spec, purpose, visible_part(probe, std::nullopt));
  if (!pixel.is_same_everywhere()) return {u, v};  // the eye is close
  const GridSize fitting = fitting_grid(probe.longest_lines() / pixel(dvec3(0)),
                                        dvec2(scene.picture.width, scene.picture.height));
  return {fitting.u, fitting.v};
}

double tolerance_share(const Scene& scene, const Purpose& purpose) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [value, pixels] : asked(scene, purpose)) {
    least = std::min(least,
                     pixels ? value / std::max(scene.picture.width, scene.picture.height) : value);
  }
  return least;
}

namespace {

/// The triangles at most, whatever memory there is.
std::size_t triangles_asked(const Scene& scene, const SurfaceSpec& spec) {
  if (scene.mesh.max_triangles) return static_cast<std::size_t>(*scene.mesh.max_triangles);
  const std::size_t share = shares_limits(scene)
                                ? std::max(kMostOfSeveral / scene.surfaces.size(), kLeastOfSeveral)
                                : kMostTriangles;
  if (scene.mesh.tolerance || samples_of(scene, spec)) return share;
  const auto pixels = static_cast<std::size_t>(scene.picture.width) *
                      static_cast<std::size_t>(scene.picture.height);
  return std::min(std::clamp(pixels, kEnoughTriangles, kMostTriangles), share);
}

std::size_t triangles_of_memory() {
  return static_cast<std::size_t>(memory_for_work() / kBytesPerTriangle);
}

std::size_t triangles_of_time() {
  const double count = kTrianglesPerSecond * time_for_work();
  return count < static_cast<double>(kMaxTriangles) ? static_cast<std::size_t>(count)
                                                    : std::numeric_limits<std::size_t>::max();
}

}  // namespace

bool shares_limits(const Scene& scene) {
  return scene.surfaces.size() > 1 && !scene.mesh.max_triangles;
}

std::size_t most_triangles(const Scene& scene, const SurfaceSpec& spec) {
  return std::min({triangles_asked(scene, spec), triangles_of_memory(), triangles_of_time()});
}

MeshAllowance mesh_allowance(const Scene& scene, const SurfaceSpec& spec, const Surface& surface) {
  const std::size_t triangles = most_triangles(scene, spec);
  const std::size_t places = kPlacesWithChecks * most_effort(triangles, least_effort(scene));
  const auto points =
      static_cast<std::size_t>(static_cast<double>(places) / Effort(surface).place());
  return {std::min(triangles, points / kPlacesPerTriangle), points};
}

Shortage shortage_of_triangles(const Scene& scene, const SurfaceSpec& spec) {
  const std::size_t most = most_triangles(scene, spec);
  if (most == triangles_asked(scene, spec)) return Shortage::None;
  return most == triangles_of_time() ? Shortage::Time : Shortage::Memory;
}

std::size_t least_effort(const Scene& scene) {
  return std::min(kLeastEffort, kPlacesPerTriangle * kMostOfSeveral /
                                    std::max<std::size_t>(scene.surfaces.size(), 1));
}

}  // namespace saddle
