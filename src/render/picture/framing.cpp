#include "render/picture/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "base/error.h"
#include "eval/batch.h"
#include "eval/tape.h"
#include "mesh/color/color_mesh.h"
#include "mesh/grid/grid.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/clip.h"
#include "mesh/model/mesh_report.h"
#include "meshing/clip_box.h"
#include "render/overlay/annotations.h"
#include "render/picture/sampled_surface.h"
#include "scene/model/camera.h"
#include "scene/model/color_scale.h"
#include "scene/model/instances.h"
#include "scene/model/prepare.h"
#include "scene/model/strokes.h"
#include "scene/model/values.h"
#include "surface/parameter_box.h"

namespace saddle {
namespace {

/// Moments that are looked at, besides both ends. So many directions of a rotation bound its circle
/// to a hundredth of the radius.
constexpr int kMoments = 32;
/// They advance by this part of the range, as far as possible from keeping step with anything.
/// Source: H. Weyl, "Ueber die Gleichverteilung von Zahlen mod. Eins", 1916.
constexpr double kGoldenPart = 0.6180339887498949;
/// A movement goes beyond two neighbouring moments by this share of its way: a swing whose end is
/// at most a tenth of its time from a moment.
constexpr double kBetweenMoments = 0.01;
/// Samples of a surface, cells each way: what a smooth surface does between them is less than the
/// room that the camera leaves around the sphere.
constexpr std::size_t kCells = 96;
/// The same for the camera that a still picture's pixels are measured with: between samples, a
/// sphere bulges by half a percent of its radius, and pixels' sizes are wrong by no more.
constexpr std::size_t kStillCells = 32;

/// Moments of the range, its ends first.
std::vector<double> moments_of(const Animation& animation) {
  std::vector<double> moments = {animation.from, animation.to};
  for (int k = 1; k <= kMoments; ++k) {
    const double part = k * kGoldenPart;
    moments.push_back(animation.from + (animation.to - animation.from) * (part - std::floor(part)));
  }
  return moments;
}

/// A height field that is more than so many times as high as the larger side of its base is shown
/// at this part of that side.
constexpr double kNeedleHeight = 8;
constexpr double kShownHeight = 0.6;

/// The scene's surfaces at one moment. A surface that does not move is sampled once.
using Samples = std::vector<std::shared_ptr<const Sampled>>;

Samples sample_all(const Scene& scene, const Samples& last, std::size_t cells, unsigned threads) {
  Samples samples;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const bool known = i < last.size() && !last[i]->moves &&
                       last[i]->thickness == thickness_of(scene, scene.surfaces[i]);
    samples.push_back(known ? last[i]
                            : std::make_shared<const Sampled>(
                                  sample(scene, scene.surfaces[i],
                                         bind_surface(scene, scene.surfaces[i]), cells, threads)));
  }
  return samples;
}

/// A surface that has poles at some moments keeps to the box of these moments at the others, too: a
/// pole just outside of the range makes it as high as one likes.
void keep_to_clipped(std::vector<Samples>& moments) {
  for (std::size_t i = 0; i < moments[0].size(); ++i) {
    Bounds clipped;
    for (const Samples& samples : moments) {
      if (samples[i]->has_poles) clipped.add(samples[i]->bounds);
    }
    if (clipped.empty()) continue;
    for (Samples& samples : moments) {
      if (samples[i]->has_poles) continue;
      auto kept = std::make_shared<Sampled>(*samples[i]);
      kept->keep_to(clipped);
      samples[i] = std::move(kept);
    }
  }
}

/// A pyramid beside what is written. The numbers of colours are known when there is a mesh: their
/// labels are about as wide as these.
ViewPyramid pyramid_of(const Scene& scene, const Camera& camera, const Bounds& box) {
  const std::vector<std::optional<ColorRange>> ranges(scene.surfaces.size(), ColorRange{-1, 1});
  return pyramid_beside_annotations(scene, camera, box, color_scales(scene, ranges),
                                    dvec2(scene.picture.width, scene.picture.height));
}

/// A box around boxes that keeps to where all of them end at the same place, and leaves room beyond
/// where they do not: moments between those that were looked at may go farther.
Bounds around_all(const std::vector<Bounds>& boxes) {
  Bounds result;
  for (const Bounds& box : boxes) result.add(box);
  for (int k = 0; k < 3; ++k) {
    double latest = result.low[k];
    double first = result.high[k];
    for (const Bounds& box : boxes) {
      latest = std::max(latest, box.low[k]);
      first = std::min(first, box.high[k]);
    }
    result.low[k] -= kBetweenMoments * (latest - result.low[k]);
    result.high[k] += kBetweenMoments * (result.high[k] - first);
  }
  return result;
}

/// The range of a surface's numbers at one moment; nothing if it has none.
std::optional<ColorRange> colors_of(const Scene& scene, const SurfaceSpec& spec) {
  GridOptions grid;
  grid.cells_u = grid.cells_v = static_cast<int>(kCells);
  grid.lines_u = grid.lines_v = 0;
  grid.threads = 1;
  ColorOptions options;
  options.least_edge = std::numeric_limits<double>::infinity();  // the grid is fine enough
  options.clip = scene.clip.box;
  options.threads = 1;
  try {
    const Surface surface = prepare_surface(scene, spec).surface;
    MeshResult mesh = mesh_on_grid(surface, grid);
    if (scene.clip.box) clip_mesh(*scene.clip.box, mesh.mesh);
    color_mesh(surface, options, mesh.mesh);
    const auto has_number = [](double number) { return !std::isnan(number); };
    if (std::ranges::none_of(mesh.mesh.color, has_number)) return std::nullopt;
    return mesh.mesh.color_range;
  } catch (const Error& error) {
    if (error.status() != Status::Nothing) throw;
    return std::nullopt;  // there is nothing of it at this moment
  }
}

/// The range of an expression on a surface over all moments; nothing if it has no numbers.
std::optional<ColorRange> range_over(const std::vector<Scene>& scenes, std::size_t surface,
                                     const std::string& expression) {
  std::optional<ColorRange> all;
  for (const Scene& scene : scenes) {
    SurfaceSpec spec = scene.surfaces[surface];
    spec.color = expression;
    spec.contours.clear();
    const auto range = colors_of(scene, spec);
    if (!range) continue;
    if (!all) all = range;
    all->low = std::min(all->low, range->low);
    all->high = std::max(all->high, range->high);
    all->below = all->below || range->below;
    all->above = all->above || range->above;
  }
  return all;
}

/// Finds the ranges of colours and of round levels that change. `samples` are of the scenes.
void find_ranges(const std::vector<Scene>& scenes, const Samples& samples, Framing& framing) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const SurfaceSpec& spec = scenes[0].surfaces[i];
    if (!samples[i]->moves) continue;
    if (!spec.color.empty()) {
      if (const auto range = range_over(scenes, i, spec.color)) framing.colors[i] = *range;
    }
    for (std::size_t k = 0; k < spec.contours.size(); ++k) {
      if (!spec.contours[k].levels.empty()) continue;
      const auto range = range_over(scenes, i, spec.contours[k].expression);
      if (range) framing.contours[{i, k}] = *range;
    }
  }
}

/// Finds target and distance from the pyramids around what each moment's camera sees. A camera that
/// turns looks at the middle of all, one that does not is fitted to all moments together.
template <class PyramidOf>
void fit_pyramids(const std::vector<Scene>& scenes, PyramidOf pyramid_of, const dvec3& middle,
                  Framing& framing) {
  std::vector<ViewPyramid> pyramids;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    pyramids.push_back(pyramid_of(k, scenes[k].camera));
  }
  ViewPyramid all = pyramids[0];
  bool turns = false;
  for (const ViewPyramid& seen : pyramids) {
    turns = turns || !all.fits(seen);
    if (!turns) all.join(seen);
  }
  const Camera& camera = scenes[0].camera;
  if (!camera.target) framing.target = turns ? middle : all.target();
  if (camera.distance) return;
  double distance = 0;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const dvec3 target = framing.target ? *framing.target : dvec3(*drawn_camera(scenes[k]).target);
    distance = std::max(distance, pyramids[k].distance_from(target));
  }
  if (distance > 0) framing.distance = distance;
}

bool is_height_field(BoundSurface& bound) {
  const NodeId v = bound.v.value_or(bound.graph.variable(kSymbolV));
  return bound.r[0] == bound.graph.variable(kSymbolU) && bound.r[1] == v;
}

/// The scene's surfaces if all of them are height fields that no node moves; else nothing.
std::vector<BoundSurface> height_fields(const Scene& scene) {
  std::vector<BoundSurface> surfaces;
  for (const SurfaceSpec& spec : scene.surfaces) {
    if (spec.is_stroke()) continue;
    if (!spec.in.empty()) return {};
    BoundSurface bound = bind_surface(scene, spec);
    if (!is_height_field(bound)) return {};
    surfaces.push_back(std::move(bound));
  }
  return surfaces;
}

/// The automatic scale of height fields that are all in this box.
std::optional<dvec3> scale_of_height(const Bounds& box) {
  if (box.empty()) return std::nullopt;
  const dvec3 size = box.size();
  const double base = std::max(size.x, size.y);
  if (!(size.z > kNeedleHeight * base) || !(base > 0)) return std::nullopt;
  return dvec3(1, 1, kShownHeight * base / size.z);
}

/// The scale of a scene at one moment.
std::optional<dvec3> scale_of_moment(const Scene& scene, unsigned threads) {
  if (!scene.scale.automatic) return std::nullopt;
  Bounds box;
  for (BoundSurface& bound : height_fields(scene)) {
    box.add(sample(scene, SurfaceSpec(), std::move(bound), kCells, threads).bounds);
  }
  return scale_of_height(box);
}

/// One scale for all moments, of surfaces as they are clipped beside their poles.
std::optional<dvec3> scale_of_moments(const std::vector<Scene>& scenes,
                                      const std::vector<Samples>& samples) {
  if (!scenes[0].scale.automatic || height_fields(scenes[0]).empty()) return std::nullopt;
  Bounds box;
  for (const Samples& moment : samples) {
    for (const auto& surface : moment) box.add(surface->bounds);
  }
  return scale_of_height(box);
}

void clip_all_to_readable(const Scene& scene, std::vector<Samples>& moments) {
  const std::vector<Samples> before = moments;  // whose places in memory no other takes
  std::map<const Sampled*, std::shared_ptr<const Sampled>> clipped;  // a surface at rest is once
  for (Samples& samples : moments) {
    for (auto& surface : samples) {
      auto& known = clipped[surface.get()];
      if (!known) {
        Sampled kept = *surface;
        clip_to_readable(scene, kept);
        known = std::make_shared<const Sampled>(std::move(kept));
      }
      surface = known;
    }
  }
}

/// Finds what the scene's cameras do not say. `scenes` are those of all moments.
void fit(std::vector<Scene>& scenes, std::size_t cells, Framing& framing, unsigned threads) {
  std::vector<Samples> samples;
  samples.reserve(scenes.size());
  std::vector<std::vector<Instance>> places;
  std::vector<Bounds> boxes;
  for (const Scene& scene : scenes) {
    samples.push_back(
        sample_all(scene, samples.empty() ? Samples{} : samples.back(), cells, threads));
  }
  framing.scale = scale_of_moments(scenes, samples);
  for (Scene& scene : scenes) {
    if (framing.scale) scene.scale.factors = *framing.scale;
    places.push_back(instances(scene));
  }
  clip_all_to_readable(scenes[0], samples);
  keep_to_clipped(samples);
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    Bounds box;
    for (const Instance& at : places[k]) {
      box.add(transformed(samples[k][at.surface]->bounds, at.to_world));
    }
    if (!box.empty()) boxes.push_back(box);
  }
  if (boxes.empty()) return;  // nothing but background
  find_ranges(scenes, samples[0], framing);
  Bounds bounds;
  for (const Bounds& box : boxes) bounds.add(box);
  if (scenes[0].axes) framing.box = around_all(boxes);
  const Bounds& written_about = framing.box ? *framing.box : bounds;
  const auto pyramid = [&](std::size_t k, const Camera& camera) {
    ViewPyramid seen = pyramid_of(scenes[k], camera, written_about);
    for (const Instance& at : places[k]) {
      const Sampled& surface = *samples[k][at.surface];
      add_points(surface.positions, surface.bounds, at.to_world, seen);
    }
    return seen;
  };
  fit_pyramids(scenes, pyramid, bounds.centre(), framing);
}

}  // namespace

void Framing::apply(Scene& scene) const {
  if (scale) scene.scale.factors = *scale;
  if (scene.scale.automatic && !scale) scene.scale.factors = dvec3(1);
  if (target) scene.camera.target = *target / dvec3(scene.scale.factors);
  if (distance) scene.camera.distance = Number(*distance);
  scene.box = box;
  for (const auto& [surface, range] : colors) scene.surfaces[surface].color_range = range;
  for (const auto& [place, range] : contours) {
    scene.surfaces[place.first].contours[place.second].range = range;
  }
}

Framing frame_scene(Timeline& timeline, unsigned threads) {
  Framing framing;
  const Scene& written = timeline.scene();
  if (!written.animation) {
    framing.scale = scale_of_moment(timeline.at(written.t), threads);
    return framing;
  }
  std::vector<Scene> scenes;
  for (const double t : moments_of(*written.animation)) {
    try {
      scenes.push_back(with_strokes(timeline.at(t)));
    } catch (const Error& error) {
      throw with_hint_line(error, "this is at t = " + format_number(t));
    }
  }
  fit(scenes, kCells, framing, threads);
  for (Scene& scene : scenes) {
    framing.apply(scene);
    Moment moment(scene);
    if (std::ranges::find(framing.moments, moment) == framing.moments.end()) {
      framing.moments.push_back(std::move(moment));
    }
  }
  return framing;
}

std::vector<Moment> moments_of_still(const Scene& resolved, unsigned threads) {
  const Scene scene = with_strokes(resolved);
  if (instances(scene).size() < 2) return {};
  Framing framing;
  Scene seen = scene;
  seen.scale.automatic = false;  // its factors are known
  std::vector<Scene> still = {seen};
  fit(still, kStillCells, framing, threads);
  framing.apply(seen);
  if (!seen.camera.target || !seen.camera.distance) return {};
  return {Moment(seen)};
}

}  // namespace saddle
