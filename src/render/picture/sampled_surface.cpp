#include "render/picture/sampled_surface.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/numbers.h"
#include "eval/batch.h"
#include "eval/tape.h"
#include "mesh/grid/grid.h"
#include "meshing/clip_box.h"
#include "meshing/thickness.h"
#include "scene/model/strokes.h"

namespace saddle {
namespace {

/// Twice as many samples each way go so many times as far where there is a pole: at a simple one
/// twice as far. A peak that all samples see stays as it is.
constexpr double kGrowth = 1.3;

/// Clips a surface as if it has poles, if it seems to. `coarse`: a box around each other sample.
void clip_poles(const Bounds& coarse, Sampled& surface) {
  const dvec3 growth = surface.bounds.size() - kGrowth * coarse.size();
  surface.has_poles = !surface.positions.empty() && std::max({growth.x, growth.y, growth.z}) > 0;
  if (surface.has_poles) surface.keep_to(clip_box(surface.bounds, surface.positions));
}

/// The corners of octahedra round points in place of the balls that make a curve's tube, or hold a
/// surface's solid.
void add_balls(double radius, Sampled& around) {
  if (radius == 0) return;
  const std::vector<dvec3> middles = std::exchange(around.positions, {});
  for (const dvec3& middle : middles) {
    for (int k = 0; k < 6; ++k) {
      dvec3 p = middle;
      p[k / 2] += k % 2 == 0 ? radius : -radius;
      around.positions.push_back(p);
      around.bounds.add(p);
    }
  }
}

}  // namespace

void Sampled::keep_to(const Bounds& box) {
  std::erase_if(positions, [&](const dvec3& p) { return !box.contains(p); });
  bounds = Bounds();
  for (const dvec3& p : positions) bounds.add(p);
}

void clip_to_readable(const Scene& scene, Sampled& surface) {
  if (surface.has_poles || scene.clip.box || !scene.clip.automatic) return;
  const dvec3 scale = scene.scale.factors;
  std::vector<dvec3> drawn = surface.positions;
  for (dvec3& p : drawn) p *= scale;
  const auto box = readable_box({surface.bounds.low * scale, surface.bounds.high * scale}, drawn);
  if (box) surface.keep_to({box->low / scale, box->high / scale});
}

Sampled sample(const Scene& scene, const SurfaceSpec& spec, BoundSurface bound, std::size_t cells,
               unsigned threads) {
  const Domain& d = bound.domain;
  const std::vector<double> u = even_lines(d.u0, d.u1, cells);
  const std::vector<double> v = even_lines(d.v0, d.v1, cells);
  std::array<std::vector<double>, 3> xyz;
  for (auto& coordinates : xyz) coordinates.resize(u.size() * v.size());
  const std::array<double*, 3> outputs = {xyz[0].data(), xyz[1].data(), xyz[2].data()};
  evaluate_grid(compile(bound.graph, bound.r), u, v, outputs, threads);
  Sampled result;
  result.moves = bound.moves;
  Bounds coarse;
  for (std::size_t i = 0; i < xyz[0].size(); ++i) {
    const dvec3 p(xyz[0][i], xyz[1][i], xyz[2][i]);
    if (!is_finite(p)) continue;
    result.positions.push_back(p);
    result.bounds.add(p);
    if (i / u.size() % 2 == 0 && i % u.size() % 2 == 0) coarse.add(p);
  }
  if (scene.clip.box && !spec.point) {
    result.keep_to(*scene.clip.box);
  } else if (scene.clip.automatic) {
    clip_poles(coarse, result);
  }
  if (spec.curve) add_balls(stroke_radius(scene, spec), result);
  if (!result.positions.empty()) {
    add_balls(reach_of_solid(scene, spec, largest_of(result.bounds.size())), result);
  }
  return result;
}

}  // namespace saddle
