#include "mesh/color/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "base/numbers.h"
#include "mesh/color/contour_tracer.h"
#include "mesh/color/drawn_colors.h"
#include "mesh/color/numbered_mesh.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// Where each side of a triangle is sampled: not evenly, as for colours.
constexpr std::array kOnContourSide = {0.27, 0.5, 0.77};
constexpr std::size_t kOnMiddle = 1;
/// Samples of a triangle: of its sides and in its middle.
constexpr std::size_t kSamples = 3 * kOnContourSide.size() + 1;
/// A level that is an extreme is met where rounding allows it: it is moved inward by this many
/// roundings, less than a line's width by far.
constexpr double kInward = 4;
/// Share of the area: so many triangles whose corners and middles have a level are no chance.
constexpr double kLeastArea = 1e-6;

/// The extreme of a parabola through 0, 1/2 and 1, if it is between; else the value at 0.
double parabola_extreme(double first, double middle, double last) {
  const double bend = 2 * (first + last) - 4 * middle;
  const double slope = last - first - bend;
  const double place = -slope / (2 * bend);
  return place > 0 && place < 1 ? first + slope * place / 2 : first;
}

/// The value where a quadratic function on a triangle is level, if that is inside; else that of the
/// first corner. `m[k]`: in the middle of the side after corner k.
double inner_extreme(const std::array<double, 3>& f, const std::array<double, 3>& m) {
  const double ss = 2 * (f[0] + f[1]) - 4 * m[0];
  const double tt = 2 * (f[0] + f[2]) - 4 * m[2];
  const double s = f[1] - f[0] - ss;
  const double t = f[2] - f[0] - tt;
  const double st = 4 * (m[1] - f[0]) - 2 * (s + t) - ss - tt;
  const double det = 4 * ss * tt - st * st;
  const double at_s = (st * t - 2 * tt * s) / det;
  const double at_t = (st * s - 2 * ss * t) / det;
  const bool is_inside = at_s > 0 && at_t > 0 && at_s + at_t < 1;
  return is_inside ? f[0] + (s * at_s + t * at_t) / 2 : f[0];
}

/// Halves triangles until each has a level at most once.
class ContourRefiner {
 public:
  ContourRefiner(const Surface& surface, const ContourOptions& options, Mesh& mesh)
      : mesh_(mesh),
        numbered_(surface, {options.tolerance, options.max_triangles, options.threads}, mesh) {}

  NumberedMesh& numbered() { return numbered_; }

  void separate(const Levels& levels) {
    numbered_.renew();
    for (int i = 0; i < kHalvingsToNearly && !numbered_.reached_limit(); ++i) {
      if (!split_once(levels)) break;
    }
  }

  bool split(std::span<const std::size_t> triangles) {
    numbered_.unmark();
    for (const std::size_t t : triangles) mark_all(mesh_.triangles[t]);
    return numbered_.split_marked();
  }

 private:
  void mark_all(const Triangle& triangle) {
    for (std::size_t k = 0; k < 3; ++k) numbered_.mark(triangle[k], next_corner(triangle, k));
  }

  bool split_once(const Levels& levels) {
    std::vector<std::size_t> triangles;
    std::vector<dvec2> uv;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!numbered_.is_new(t)) continue;
      triangles.push_back(t);
      const Triangle& triangle = mesh_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const dvec2& a = mesh_.uv[triangle[k]];
        const dvec2& b = mesh_.uv[next_corner(triangle, k)];
        for (const double part : kOnContourSide) uv.push_back(glm::mix(a, b, part));
      }
      const auto [a, b, c] = triangle;
      uv.push_back((mesh_.uv[a] + mesh_.uv[b] + mesh_.uv[c]) / 3.0);
    }
    const std::vector<double> numbers = numbered_.numbers(uv);
    numbered_.unmark();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      test(mesh_.triangles[triangles[i]], std::span(numbers).subspan(kSamples * i, kSamples),
           levels);
    }
    return numbered_.split_marked();
  }

  void test(const Triangle& triangle, std::span<const double> numbers, const Levels& levels) {
    std::array<double, 3> corners{};
    std::array<double, 3> middles{};
    bool is_marked = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::span<const double> on_side = numbers.subspan(kOnContourSide.size() * k);
      corners[k] = mesh_.color[triangle[k]];
      middles[k] = on_side[kOnMiddle];
      const double next = mesh_.color[next_corner(triangle, k)];
      if (!crosses_twice({corners[k], on_side[0], on_side[1], on_side[2], next}, levels)) continue;
      numbered_.mark(triangle[k], next_corner(triangle, k));
      is_marked = true;
    }
    const bool has_numbers = std::ranges::none_of(corners, [](double f) { return std::isnan(f); });
    if (is_marked || !has_numbers) return;
    const auto [low, high] = std::ranges::minmax(corners);
    const std::size_t least = levels.reached_by(low);
    const std::size_t most = levels.reached_by(high);
    for (const double inside : {numbers.back(), inner_extreme(corners, middles)}) {
      const std::size_t reached = levels.reached_by(inside);
      if (std::isnan(inside) || reached < least || reached > most) return mark_all(triangle);
    }
  }

  /// Whether the way from the first number to the last meets a level more often than it must, or is
  /// only partly defined.
  static bool crosses_twice(const std::array<double, 5>& way, const Levels& levels) {
    const auto undefined = std::ranges::count_if(way, [](double f) { return std::isnan(f); });
    if (undefined > 0) return undefined < std::ssize(way);
    const std::size_t first = levels.reached_by(way.front());
    const std::size_t last = levels.reached_by(way.back());
    std::size_t met = 0;
    for (std::size_t k = 1; k < way.size(); ++k) {
      const std::size_t a = levels.reached_by(way[k - 1]);
      const std::size_t b = levels.reached_by(way[k]);
      met += std::max(a, b) - std::min(a, b);
    }
    const auto [least, most] = std::minmax(first, last);
    const std::size_t extreme =
        levels.reached_by(parabola_extreme(way.front(), way[1 + kOnMiddle], way.back()));
    return met > most - least || extreme < least || extreme > most;
  }

  Mesh& mesh_;
  NumberedMesh numbered_;
};

/// Sorted, and moved inward from the ends of the range.
Levels working_levels(std::vector<double> levels, const ColorRange& all, double rounding) {
  Levels result{std::move(levels), rounding};
  const double size = std::max(std::abs(all.low), std::abs(all.high));
  if (std::isfinite(size)) result.rounding = std::max(rounding, kRounding * size);
  const double inward = kInward * result.rounding;
  for (double& level : result.levels) {
    if (std::abs(level - all.low) <= inward) level = all.low + inward;
    if (std::abs(level - all.high) <= inward) level = all.high - inward;
  }
  std::ranges::sort(result.levels);
  return result;
}

/// The levels that the number has all over triangles of a notable area.
std::vector<double> levels_on_areas(const NumberedMesh& numbered, const Mesh& mesh,
                                    const Levels& levels) {
  const double on_level = 2 * kInward * levels.rounding;
  std::vector<std::pair<std::size_t, double>> found;  // a level, and the area of a triangle
  std::vector<dvec2> middles;
  double whole = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c] = triangle;
    const double area = glm::length(
        glm::cross(mesh.position[b] - mesh.position[a], mesh.position[c] - mesh.position[a]));
    whole += area;
    const auto level = std::ranges::lower_bound(levels.levels, mesh.color[a] - on_level);
    if (level == levels.levels.end()) continue;
    const auto is_on = [&](std::uint32_t k) {
      return std::abs(mesh.color[k] - *level) <= on_level;
    };
    if (!is_on(a) || !is_on(b) || !is_on(c)) continue;
    found.emplace_back(static_cast<std::size_t>(level - levels.levels.begin()), area);
    middles.push_back((mesh.uv[a] + mesh.uv[b] + mesh.uv[c]) / 3.0);
  }
  const std::vector<double> numbers = numbered.numbers(middles);
  std::vector<double> areas(levels.levels.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& [level, area] = found[i];
    if (std::abs(numbers[i] - levels.levels[level]) <= on_level) areas[level] += area;
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] > kLeastArea * whole) result.push_back(levels.levels[i]);
  }
  return result;
}

}  // namespace

ContourReport add_contours(const Surface& surface, const ContourOptions& options, Mesh& mesh) {
  ContourReport report;
  Mesh halved = mesh;
  halved.lines.clear();
  ContourRefiner refiner(surface, options, halved);
  refiner.numbered().number_corners();
  const auto drawn = drawn_colors(surface, halved, options.rounding, options.clip);
  if (!drawn) return report;
  report.range = drawn->range;
  report.levels = options.levels(drawn->range);
  if (drawn->range.low == drawn->range.high) {
    for (const double level : report.levels) {
      const double same = std::max(options.rounding, kRounding * std::abs(level));
      if (std::abs(level - drawn->range.low) <= same) report.on_areas.push_back(level);
    }
    return report;
  }
  const Levels levels = working_levels(report.levels, drawn->all, options.rounding);
  refiner.separate(levels);
  report.on_areas = levels_on_areas(refiner.numbered(), halved, levels);
  for (int i = 0;; ++i) {
    ContourTracer tracer(surface, halved, levels, options.tolerance, options.mesh_error,
                         options.threads);
    const std::vector<std::size_t> ends = tracer.cross_sides();
    if (i < kHalvingsToNearly && !ends.empty() && refiner.split(ends)) continue;
    const std::size_t before = mesh.contours.lines.size();
    tracer.trace(mesh.contours);
    report.lines = mesh.contours.lines.size() - before;
    break;
  }
  report.reached_limit = refiner.numbered().reached_limit();
  return report;
}

}  // namespace saddle
