#include "render/picture/sampled_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
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
  if (surface.has_poles)
    surface.keep_to(clip_box(surface.bounds, surface.bounds, surface.positions));
}

/// The corners of polyhedra round points in place of the balls that make a curve's tube, or hold a
/// surface's solid.
void add_balls(double radius, std::span<const dvec3> corners, Sampled& around) {
  if (radius == 0) return;
  const std::vector<dvec3> middles = std::exchange(around.positions, {});
  for (const dvec3& middle : middles) {
    for (const dvec3& corner : corners) {
      const dvec3 p = middle + radius * corner;
      around.positions.push_back(p);
      around.bounds.add(p);
    }
  }
}

/// A tube is thin: an octahedron is as good as a ball.
constexpr std::array kOctahedron = {dvec3(1, 0, 0),  dvec3(-1, 0, 0), dvec3(0, 1, 0),
                                    dvec3(0, -1, 0), dvec3(0, 0, 1),  dvec3(0, 0, -1)};

/// The directions of a cube's faces and of its corners, so far out that the unit ball is inside.
std::array<dvec3, 14> around_ball() {
  // A face has two corners of the cube, (1, 1, +-1) / sqrt(3), and the middle (1, 0, 0) of a face:
  // its plane is x + (sqrt(3) - 1) y = 1, at a distance of 1 over this from the origin.
  const double out = std::hypot(1.0, std::sqrt(3.0) - 1);
  std::array<dvec3, 14> corners{};
  for (std::size_t k = 0; k < 6; ++k) corners[k] = out * kOctahedron[k];
  for (std::size_t k = 0; k < 8; ++k) {
    const dvec3 corner((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
    corners[6 + k] = out / std::sqrt(3.0) * corner;
  }
  return corners;
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
  result.thickness = thickness_of(scene, spec);
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
  if (spec.curve) add_balls(stroke_radius(scene, spec), kOctahedron, result);
  if (!result.positions.empty()) {
    const double longest = largest_of(result.bounds.size());
    add_balls(reach_of_solid(scene, spec, longest), around_ball(), result);
  }
  return result;
}

}  // namespace saddle
