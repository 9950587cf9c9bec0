// Generation by generation: samples the sides and the middles of triangles, and halves the sides on
// which the numbers bend. Sides between the same points are halved alike, whichever corners they
// have, so that no gap opens along a seam.
#include "mesh/color/color_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "mesh/color/color_limit.h"
#include "mesh/color/drawn_colors.h"
#include "mesh/model/pair_table.h"
#include "mesh/model/tolerances.h"
#include "surface/limit_path.h"

namespace saddle {
namespace {

/// Where a side is sampled: not evenly, so that waves as long as the mesh's cells are found. The
/// second place is that of the new corner.
constexpr std::array kOnSide = {0.27, 0.5, 0.77};

class ColorMesher {
 public:
  ColorMesher(const Surface& surface, const ColorOptions& options, Mesh& mesh)
      : surface_(surface), options_(options), mesh_(mesh) {}

  ColorReport run() {
    const std::vector<double> numbers = evaluate(mesh_.uv);
    mesh_.color.assign(numbers.begin(), numbers.end());
    take_limits(0);
    is_new_.assign(mesh_.triangles.size(), true);
    while (split_long_sides()) {
    }
    const auto drawn = find_range();
    if (drawn) {
      subdivide();
      const bool is_whole = !drawn->is_clamped && drawn->range.low < drawn->range.high;
      if (is_whole) find_range();  // there are more corners now
    } else {
      std::ranges::fill(mesh_.color, kNan);
    }
    separate_undefined();
    return report_;
  }

 private:
  void subdivide() {
    range_ = mesh_.color_range;
    is_new_.assign(mesh_.triangles.size(), true);
    for (int i = 0; i < kHalvingsToNearly && !report_.reached_limit; ++i) {
      if (!split_bent_sides()) break;
    }
  }

  /// Sets the range of the colours. Returns nothing if there are no numbers.
  std::optional<DrawnColors> find_range() {
    const auto drawn = drawn_colors(surface_, mesh_, options_.rounding, options_.clip);
    if (!drawn) return std::nullopt;
    report_.is_clamped = drawn->is_clamped;
    mesh_.color_range = options_.range.value_or(drawn->range);
    return drawn;
  }

  std::vector<double> evaluate(std::span<const dvec2> uv) {
    return evaluate_color(surface_, uv, options_.threads);
  }

  /// Corners from `first` on without a number take its limit from inside of a triangle.
  void take_limits(std::size_t first) {
    const auto isnan = [](double number) { return std::isnan(number); };
    if (std::none_of(mesh_.color.begin() + static_cast<std::ptrdiff_t>(first), mesh_.color.end(),
                     isnan)) {
      return;
    }
    std::vector<std::uint32_t> corners;
    std::vector<dvec2> paths;
    std::vector<bool> done(mesh_.color.size() - first);
    for (const Triangle& triangle : mesh_.triangles) {
      const dvec2 middle =
          (mesh_.uv[triangle[0]] + mesh_.uv[triangle[1]] + mesh_.uv[triangle[2]]) / 3.0;
      for (const std::uint32_t corner : triangle) {
        if (corner < first || !std::isnan(mesh_.color[corner]) || done[corner - first]) continue;
        done[corner - first] = true;
        corners.push_back(corner);
        const auto path = limit_path(mesh_.uv[corner], middle);
        paths.insert(paths.end(), path.begin(), path.end());
      }
    }
    if (corners.empty()) return;
    const std::vector<double> numbers = evaluate(paths);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto limit =
          extrapolated_limit(std::span(numbers).subspan(k * kLimitSteps, kLimitSteps));
      if (limit) mesh_.color[corners[k]] = *limit;
    }
  }

  // --- which sides -------------------------------------------------------------------------------

  static std::uint32_t next(const Triangle& triangle, std::size_t k) {
    return triangle[k == 2 ? 0 : k + 1];
  }

  double length(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(mesh_.position[a], mesh_.position[b]);
  }

  bool may_be_split(std::uint32_t a, std::uint32_t b) const {
    return mesh_.point[a] != mesh_.point[b] && length(a, b) > options_.least_edge;
  }

  void mark(std::uint32_t a, std::uint32_t b) {
    if (may_be_split(a, b)) marked_.insert(pair_of(mesh_.point[a], mesh_.point[b]));
  }

  bool split_long_sides() {
    const Domain& d = surface_.domain;
    const dvec2 longest = kFirstSide * dvec2(std::abs(d.u1 - d.u0), std::abs(d.v1 - d.v0));
    marked_.clear();
    for (const Triangle& triangle : mesh_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k];
        const std::uint32_t b = next(triangle, k);
        const dvec2 way = glm::abs(mesh_.uv[a] - mesh_.uv[b]);
        if (way.x > longest.x || way.y > longest.y) mark(a, b);
      }
    }
    return split_marked();
  }

  /// In the range, in colour steps.
  double step_of(double number) const {
    const double width = range_.high - range_.low;
    return width > 0
               ? kColorSteps * (std::clamp(number, range_.low, range_.high) - range_.low) / width
               : 0;
  }

  /// Whether the numbers that belong between others are more than a step from where they should be.
  bool exceeds_tolerance(double number, double straight) const {
    if (std::isnan(number) || std::isnan(straight)) {
      return std::isnan(number) != std::isnan(straight);
    }
    return std::abs(step_of(number) - straight) > 1;
  }

  /// A number of steps, NaN for one that is not defined.
  double straight(double number) const { return std::isnan(number) ? number : step_of(number); }

  bool split_bent_sides() {
    std::vector<std::array<std::uint32_t, 2>> sides;
    PairTable seen;
    std::vector<dvec2> uv;
    std::vector<std::size_t> triangles;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!is_new_[t]) continue;
      const Triangle& triangle = mesh_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k];
        const std::uint32_t b = next(triangle, k);
        if (may_be_split(a, b) && seen.insert(pair_of(a, b)).second) sides.push_back({a, b});
      }
      triangles.push_back(t);
    }
    for (const auto& [a, b] : sides) {
      for (const double s : kOnSide) uv.push_back(glm::mix(mesh_.uv[a], mesh_.uv[b], s));
    }
    for (const std::size_t t : triangles) {
      const auto& [a, b, c] = mesh_.triangles[t];
      uv.push_back((mesh_.uv[a] + mesh_.uv[b] + mesh_.uv[c]) / 3.0);
    }
    const std::vector<double> numbers = evaluate(uv);
    marked_.clear();
    for (std::size_t i = 0; i < sides.size(); ++i) test_side(sides[i], &numbers[3 * i]);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      test_middle(mesh_.triangles[triangles[i]], numbers[3 * sides.size() + i]);
    }
    return split_marked();
  }

  void test_side(const std::array<std::uint32_t, 2>& side, const double* numbers) {
    const double a = straight(mesh_.color[side[0]]);
    const double b = straight(mesh_.color[side[1]]);
    bool is_bent = std::isnan(a) != std::isnan(b);
    for (std::size_t k = 0; k < kOnSide.size(); ++k) {
      is_bent = is_bent || exceeds_tolerance(numbers[k], a + (b - a) * kOnSide[k]);
    }
    if (is_bent) mark(side[0], side[1]);
  }

  /// A triangle that is wrong in the middle, but on no side, is halved along all of them.
  void test_middle(const Triangle& triangle, double number) {
    const auto& [a, b, c] = triangle;
    const double mean =
        (straight(mesh_.color[a]) + straight(mesh_.color[b]) + straight(mesh_.color[c])) / 3;
    if (!exceeds_tolerance(number, mean)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      if (marked_.contains(pair_of(mesh_.point[triangle[k]], mesh_.point[next(triangle, k)])))
        return;
    }
    for (std::size_t k = 0; k < 3; ++k) mark(triangle[k], next(triangle, k));
  }

  // --- halving -----------------------------------------------------------------------------------

  /// Halves the marked sides; false if there are none, or too many.
  bool split_marked() {
    if (marked_.size() == 0) return false;
    if (mesh_.triangles.size() + 2 * marked_.size() > options_.max_triangles) {
      report_.reached_limit = true;
      return false;
    }
    middles_.clear();
    points_.clear();
    const std::size_t first = mesh_.position.size();
    const std::size_t count = mesh_.triangles.size();
    is_new_.assign(count, false);
    for (std::size_t t = 0; t < count; ++t) split(t);
    number_new_corners(first);
    for (std::vector<std::uint32_t>& line : mesh_.lines) split_line(line);
    return true;
  }

  void number_new_corners(std::size_t first) {
    const std::vector<double> numbers = evaluate(std::span(mesh_.uv).subspan(first));
    mesh_.color.insert(mesh_.color.end(), numbers.begin(), numbers.end());
    take_limits(first);
  }

  /// The middle of a side that is marked.
  std::optional<std::uint32_t> middle(std::uint32_t a, std::uint32_t b) {
    const Pair points = pair_of(mesh_.point[a], mesh_.point[b]);
    if (!marked_.contains(points)) return std::nullopt;
    const auto next_corner = static_cast<std::uint32_t>(mesh_.position.size());
    const auto [known, is_first] = middles_.insert(pair_of(a, b), next_corner);
    if (!is_first) return known;
    const dvec3 normal = mesh_.normal[a] + mesh_.normal[b];
    mesh_.position.push_back(0.5 * (mesh_.position[a] + mesh_.position[b]));
    mesh_.normal.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : mesh_.normal[a]);
    mesh_.uv.push_back(0.5 * (mesh_.uv[a] + mesh_.uv[b]));
    const auto point = points_.insert(points, mesh_.point_count);
    if (point.second) ++mesh_.point_count;
    mesh_.point.push_back(point.first);
    return next_corner;
  }

  /// Cuts a triangle along the middles of its sides into two, three or four.
  void split(std::size_t t) {
    Triangle triangle = mesh_.triangles[t];
    std::array<std::optional<std::uint32_t>, 3> middles;
    std::size_t halved = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      middles[k] = middle(triangle[k], next(triangle, k));
      if (middles[k]) ++halved;
    }
    if (halved == 0) return;
    // Turn it so that the side from the first corner is halved and, of two, the next one not.
    while (!middles[0] || (halved == 2 && middles[1])) {
      std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
      std::rotate(middles.begin(), middles.begin() + 1, middles.end());
    }
    const auto [a, b, c] = triangle;
    const std::uint32_t m = *middles[0];
    if (halved == 1) {
      replace(t, {{{a, m, c}, {m, b, c}}});
    } else if (halved == 2) {
      const std::uint32_t n = *middles[2];  // of c and a
      if (length(m, c) < length(n, b)) {
        replace(t, {{{a, m, n}, {m, c, n}, {m, b, c}}});
      } else {
        replace(t, {{{a, m, n}, {m, b, n}, {n, b, c}}});
      }
    } else {
      const std::uint32_t n = *middles[1];
      const std::uint32_t o = *middles[2];
      replace(t, {{{a, m, o}, {m, b, n}, {n, c, o}, {m, n, o}}});
    }
  }

  void replace(std::size_t t, const std::vector<Triangle>& parts) {
    mesh_.triangles[t] = parts[0];
    is_new_[t] = true;
    for (std::size_t k = 1; k < parts.size(); ++k) {
      mesh_.triangles.push_back(parts[k]);
      is_new_.push_back(true);
    }
  }

  void split_line(std::vector<std::uint32_t>& line) const {
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0) {
        const auto found = middles_.find(pair_of(line[i - 1], line[i]));
        if (found) result.push_back(*found);
      }
      result.push_back(line[i]);
    }
    line = std::move(result);
  }

  // --- corners without a number ------------------------------------------------------------------

  /// Gives triangles with a corner without a number three such corners of their own.
  void separate_undefined() {
    std::unordered_map<std::uint32_t, std::uint32_t> twins;
    double area = 0;
    double undefined = 0;
    for (Triangle& triangle : mesh_.triangles) {
      const auto& [a, b, c] = triangle;
      const dvec3& p = mesh_.position[a];
      const double twice = glm::length(glm::cross(mesh_.position[b] - p, mesh_.position[c] - p));
      area += twice;
      const auto has_none = [this](std::uint32_t i) { return std::isnan(mesh_.color[i]); };
      if (std::ranges::none_of(triangle, has_none)) continue;
      undefined += twice;
      for (std::uint32_t& corner : triangle) corner = twin(corner, twins);
    }
    report_.undefined_share = area > 0 ? undefined / area : 0;
  }

  /// A copy of a corner without a number.
  std::uint32_t twin(std::uint32_t corner,
                     std::unordered_map<std::uint32_t, std::uint32_t>& twins) {
    if (std::isnan(mesh_.color[corner])) return corner;
    const auto next_corner = static_cast<std::uint32_t>(mesh_.position.size());
    const auto [known, is_first] = twins.try_emplace(corner, next_corner);
    if (!is_first) return known->second;
    mesh_.position.push_back(dvec3(mesh_.position[corner]));
    mesh_.normal.push_back(dvec3(mesh_.normal[corner]));
    mesh_.uv.push_back(dvec2(mesh_.uv[corner]));
    mesh_.point.push_back(std::uint32_t{mesh_.point[corner]});
    mesh_.color.push_back(kNan);
    return next_corner;
  }

  const Surface& surface_;
  const ColorOptions& options_;
  Mesh& mesh_;
  ColorReport report_;
  ColorRange range_;
  std::vector<bool> is_new_;  // triangles that have not been looked at
  PairTable marked_;          // points whose sides are to be halved
  PairTable middles_;         // new corners between corners
  PairTable points_;          // new points between points
};

}  // namespace

ColorReport color_mesh(const Surface& surface, const ColorOptions& options, Mesh& mesh) {
  return ColorMesher(surface, options, mesh).run();
}

}  // namespace saddle
