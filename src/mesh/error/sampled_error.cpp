#include "mesh/error/sampled_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>

#include "base/parallel.h"
#include "base/random.h"
#include "mesh/error/newton_step.h"
#include "mesh/grid/triangulate.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Cells that are measured at most, three points each: a sixth of the points of a default grid.
constexpr std::size_t kMostMeasuredCells = 2048;
/// Places in a cell where an error is largest: its middle and the middles of two edges (the other
/// two belong to the neighbours).
constexpr std::array<dvec2, 3> kWorstPlaces = {dvec2(0.5, 0.5), dvec2(0.5, 0), dvec2(0, 0.5)};
constexpr std::size_t kCellChunk = 256;

/// The point of a triangle nearest to `p`, as weights of its corners.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  dvec3 weights{0};
  bool inside = false;  ///< the triangle, straight below `p`
};

/// The nearest place on the edge from corner a to corner b.
struct OnEdge {
  double square = std::numeric_limits<double>::infinity();  ///< of the distance
  double share = 0;                                         ///< from a
};

OnEdge nearest_on_edge(const dvec3& a, const dvec3& b, const dvec3& p) {
  const dvec3 edge = b - a;
  const double square = glm::dot(edge, edge);
  const double share = square > 0 ? std::clamp(glm::dot(p - a, edge) / square, 0.0, 1.0) : 0;
  const dvec3 off = p - (a + share * edge);
  return {glm::dot(off, off), share};
}

Nearest nearest_on_triangle(const std::array<dvec3, 3>& t, const dvec3& p) {
  const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double square = glm::dot(normal, normal);
  // Twice the area of p and two corners, beside that of the triangle: what the third one weighs.
  const dvec3 weights = dvec3(glm::dot(glm::cross(t[1] - p, t[2] - p), normal),
                              glm::dot(glm::cross(t[2] - p, t[0] - p), normal),
                              glm::dot(glm::cross(t[0] - p, t[1] - p), normal));
  if (square > 0 && weights.x >= 0 && weights.y >= 0 && weights.z >= 0) {
    return {std::abs(glm::dot(p - t[0], normal)) / std::sqrt(square), weights / square, true};
  }
  OnEdge best;
  int from = 0;
  for (int k = 0; k < 3; ++k) {
    // Only an edge that p is beyond can be nearest, unless rounding has it on the inside of all.
    if (square > 0 && weights[(k + 2) % 3] > 0) continue;
    const OnEdge edge = nearest_on_edge(t[static_cast<std::size_t>(k)],
                                        t[static_cast<std::size_t>((k + 1) % 3)], p);
    if (!(edge.square < best.square)) continue;
    best = edge;
    from = k;
  }
  Nearest nearest{std::sqrt(best.square), dvec3(0)};
  nearest.weights[from] = 1 - best.share;
  nearest.weights[(from + 1) % 3] = best.share;
  return nearest;
}

/// What the corners of a triangle weigh at (u, v); negative outside.
dvec3 weights_at(const Grid& grid, const Triangle& t, const dvec2& uv) {
  const auto& at = grid.mesh.uv;
  const auto area = [](const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double per_whole = 1 / area(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
  const auto weight = [&](std::size_t a, std::size_t b) {
    return area(at[t[a]] - uv, at[t[b]] - uv) * per_whole;
  };
  return {weight(1, 2), weight(2, 0), weight(0, 1)};
}

Nearest nearest_on(const Grid& grid, const Triangle& t, const dvec3& p) {
  return nearest_on_triangle({grid.local(t[0]), grid.local(t[1]), grid.local(t[2])}, p);
}

/// Of a point, in local units, from triangles, one of which is thought to be the nearest.
double distance(const Grid& grid, std::span<const Triangle> triangles, const dvec3& p,
                const Nearest& on_own) {
  double distance = on_own.distance;
  if (on_own.inside) return distance;
  for (const Triangle& t : triangles)
    distance = std::min(distance, nearest_on(grid, t, p).distance);
  return distance;
}

/// The distance of a triangle's point at (u, v) from the surface, which is at `p` there, in local
/// units: along its normal, since what is along the surface is no distance. 0 where the two are too
/// far apart for that, or (u, v) is not in the triangle.
double height_above(const Grid& grid, const Below& below, const dvec3& p, const dvec3& normal) {
  const auto& [triangle, weights] = below;
  const Triangle& t = *triangle;
  if (!(std::min({weights.x, weights.y, weights.z}) >= -kRounding)) return 0;
  const std::array<dvec3, 3> at = {grid.local(t[0]), grid.local(t[1]), grid.local(t[2])};
  const dvec3 off = weights.x * at[0] + weights.y * at[1] + weights.z * at[2] - p;
  const double height = std::fabs(glm::dot(off, normal));
  const double longest = std::max(
      {glm::distance(at[0], at[1]), glm::distance(at[1], at[2]), glm::distance(at[2], at[0])});
  const double aside = glm::dot(off, off) - height * height;
  if (!(height <= kMostAbove * longest)) return 0;
  return aside <= kMostAside * kMostAside * longest * longest ? height : 0;
}

LoopVector loop_vector(const dvec3& v) {
  return {v.x, v.y, v.z};
}

class SampleMeasurer {
 public:
  SampleMeasurer(const Surface& surface, const Grid& grid, std::span<const std::size_t> opened,
                 unsigned threads)
      : surface_(surface), grid_(grid), opened_(opened), threads_(threads) {}

  MeasuredError measure() const {
    const std::vector<std::size_t> cells = choose_cells();
    std::vector<dvec2> uv;
    uv.reserve(cells.size() * kWorstPlaces.size());
    for (const std::size_t cell : cells) append_places(cell, uv);
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);

    std::vector<SampledError> errors(points.size());
    parallel_chunks(points.size(), kCellChunk, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t cell = cells[k / kWorstPlaces.size()];
        errors[k] = sampled_error(grid_, grid_.triangles(cell), uv[k], points[k], surface_.flip);
      }
    });
    MeasuredError largest{0, 0, points.size()};
    for (const SampledError& e : errors) {
      largest.distance = std::max(largest.distance, e.distance);
      largest.normal_degrees = std::max(largest.normal_degrees, e.degrees);
    }
    return largest;
  }

 private:
  /// The largest sagitta of the edges of a cell's triangles.
  double estimate(std::size_t cell) const {
    double largest = 0;
    for (const Triangle& t : grid_.triangles(cell)) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k];
        const std::uint32_t b = t[(k + 1) % 3];
        const double edge =
            sagitta(mesh_.position[a], mesh_.normal[a], mesh_.position[b], mesh_.normal[b]);
        largest = std::max(largest, edge);
      }
    }
    return largest;
  }

  /// All cells with triangles, if they are few; else as many spread over the domain as chosen from
  /// the worst.
  std::vector<std::size_t> choose_cells() const {
    if (grid_.cell_count() <= kMostMeasuredCells) return spread_cells(grid_.cell_count());
    const std::size_t half = kMostMeasuredCells / 2;
    std::vector<std::size_t> cells = spread_cells(half);
    std::vector<CellSagitta> worst = grid_.worst;
    for (const std::size_t cell : opened_) worst.push_back({cell, estimate(cell)});
    if (worst.size() > half) {
      const auto end = worst.begin() + static_cast<std::ptrdiff_t>(half);
      std::nth_element(worst.begin(), end, worst.end(),
                       [](const CellSagitta& a, const CellSagitta& b) {
                         return a.sagitta != b.sagitta ? a.sagitta > b.sagitta : a.cell < b.cell;
                       });
      worst.resize(half);
    }
    for (const CellSagitta& candidate : worst) {
      if (grid_.triangle_count(candidate.cell) > 0) cells.push_back(candidate.cell);
    }
    return cells;
  }

  /// From each of `count` stretches of equal length of the grid's cells one at random, or the next
  /// one in the stretch that has triangles.
  std::vector<std::size_t> spread_cells(std::size_t count) const {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t begin = k * grid_.cell_count() / count;
      const std::size_t length = (k + 1) * grid_.cell_count() / count - begin;
      const auto first = static_cast<std::size_t>(random_unit(k) * static_cast<double>(length));
      for (std::size_t step = 0; step < length; ++step) {
        const std::size_t cell = begin + (first + step) % length;
        if (grid_.triangle_count(cell) == 0) continue;
        chosen.push_back(cell);
        break;
      }
    }
    return chosen;
  }

  void append_places(std::size_t cell, std::vector<dvec2>& uv) const {
    const auto vertices = grid_.vertices(cell);
    const dvec2 low = grid_.uv(vertices[0]);
    const dvec2 high = grid_.uv(vertices[2]);
    for (std::size_t k = 0; k < kWorstPlaces.size(); ++k) {
      const std::uint64_t key = 2 * (cell * kWorstPlaces.size() + k);
      const dvec2 random(random_unit(key), random_unit(key + 1));
      const dvec2 off = glm::sign(kWorstPlaces[k]) * (2.0 * random - 1.0) * kSampleJitter;
      const dvec2 part = kWorstPlaces[k] + off;
      uv.push_back(low * (1.0 - part) + high * part);
    }
  }

  const Surface& surface_;
  const Grid& grid_;
  const Mesh& mesh_ = grid_.mesh;
  std::span<const std::size_t> opened_;
  unsigned threads_;
};

}  // namespace

Below triangle_below(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv) {
  Below best{&triangles.front(), dvec3(std::numeric_limits<double>::quiet_NaN())};
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Triangle& t : triangles) {
    const dvec3 weights = weights_at(grid, t, uv);
    const double depth = std::min({weights.x, weights.y, weights.z});
    if (!(depth > deepest)) continue;
    best = {&t, weights};
    deepest = depth;
    if (deepest > 0) break;  // inside: they do not overlap
  }
  return best;
}

Seen seen_at(const std::optional<Bounds>& clip, const Grid& grid,
             std::span<const Triangle> triangles, const dvec2& uv, const dvec3& position) {
  if (!clip) return {true, !triangles.empty()};
  Seen seen{clip->contains(position), false};
  if (triangles.empty()) return seen;
  const auto& [below, weights] = triangle_below(grid, triangles, uv);
  if (!(std::min({weights.x, weights.y, weights.z}) >= -kRounding)) return seen;
  const dvec3 inside = glm::clamp(weights, 0.0, 1.0);
  const Triangle& t = *below;
  const auto& p = grid.mesh.position;
  seen.triangles = clip->contains(inside.x * p[t[0]] + inside.y * p[t[1]] + inside.z * p[t[2]]);
  return seen;
}

double distance_from(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                     const dvec3& position) {
  if (triangles.empty() || !is_finite(position)) return 0;
  const Triangle& own = *triangle_below(grid, triangles, uv).triangle;
  const dvec3 p = grid.local_scale * position;
  return distance(grid, triangles, p, nearest_on(grid, own, p)) / grid.local_scale;
}

SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const SurfacePoint& point, bool flip, double known) {
  const double size_u = safe_length(point.r_u);
  return sampled_error(grid, triangles, uv, point.position,
                       unit_normal(point, size_u, safe_length(point.r_v), flip), known);
}

SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const dvec3& position, const std::optional<dvec3>& normal,
                           double known) {
  if (triangles.empty() || !is_finite(position)) return {};
  const Below below = triangle_below(grid, triangles, uv);
  const Triangle& own = *below.triangle;
  const dvec3 p = grid.local_scale * position;
  const Nearest on_own = nearest_on(grid, own, p);
  dvec3 interpolated(0);
  for (int k = 0; k < 3; ++k) {
    interpolated += on_own.weights[k] * grid.mesh.normal[own[static_cast<std::size_t>(k)]];
  }
  const bool is_near = on_own.distance <= grid.local_scale * known;
  double away = is_near ? on_own.distance : distance(grid, triangles, p, on_own);
  if (normal) away = std::max(away, height_above(grid, below, p, *normal));
  return {away / grid.local_scale, normal ? degrees_between(*normal, interpolated) : 0};
}

Predicted predict(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                  const SurfacePoint& point, bool flip) {
  if (triangles.empty() || !is_finite(point.position)) return {0, uv};
  const auto normal = unit_normal(point, safe_length(point.r_u), safe_length(point.r_v), flip);
  if (!normal) return {0, uv};
  const dvec3 p = grid.local_scale * point.position;
  const Triangle* nearest = triangle_below(grid, triangles, uv).triangle;
  Nearest on_own = nearest_on(grid, *nearest, p);
  for (const Triangle& t : triangles) {
    if (on_own.inside) break;
    const Nearest on_it = nearest_on(grid, t, p);
    if (!on_it.inside && !(on_it.distance < on_own.distance)) continue;
    nearest = &t;
    on_own = on_it;
  }
  const Triangle& own = *nearest;
  const dvec3 corner = grid.local(own[0]);
  const dvec3 to_second = grid.local(own[1]) - corner;
  const dvec3 to_third = grid.local(own[2]) - corner;
  const auto& n = grid.mesh.normal;
  const StepShape shape =
      step_shape(loop_vector(to_second), loop_vector(to_third), loop_vector(n[own[1]] - n[own[0]]),
                 loop_vector(n[own[2]] - n[own[0]]), loop_vector(*normal));
  const double facing = glm::dot(*normal, glm::cross(to_second, to_third));
  const double above = glm::dot(p - corner, glm::cross(to_second, to_third));
  const NewtonStep newton_step =
      newton_step_from(shape, above * facing < 0 ? -on_own.distance : on_own.distance,
                       on_own.weights.y, on_own.weights.z);
  const auto& at = grid.mesh.uv;
  // The surface goes on from the place itself as the triangle does from the point below it.
  return {newton_step.height / grid.local_scale, uv + newton_step.to_b * (at[own[1]] - at[own[0]]) +
                                                     newton_step.to_c * (at[own[2]] - at[own[0]])};
}

double degrees_of_chord(double chord) {
  return 2 * std::asin(std::min(chord / 2, 1.0)) * 180 / std::numbers::pi;
}

double chord_of_degrees(double degrees) {
  return 2 * std::sin(degrees / 2 * std::numbers::pi / 180);
}

MeasuredError measure_error(const Surface& surface, const Grid& grid,
                            std::span<const std::size_t> opened, unsigned threads) {
  return SampleMeasurer(surface, grid, opened, threads).measure();
}

}  // namespace saddle
