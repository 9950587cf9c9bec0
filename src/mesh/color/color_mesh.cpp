// Generation by generation: samples the sides and the middles of triangles, and halves the sides on
// which the numbers bend.
#include "mesh/color/color_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "mesh/color/drawn_colors.h"
#include "mesh/color/numbered_mesh.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// Where a side is sampled: not evenly, so that waves as long as the mesh's cells are found. The
/// second place is that of the new corner.
constexpr std::array kOnSide = {0.27, 0.5, 0.77};

class ColorMesher {
 public:
  ColorMesher(const Surface& surface, const ColorOptions& options, Mesh& mesh)
      : surface_(surface),
        options_(options),
        mesh_(mesh),
        numbered_(surface, {options.least_edge, options.max_triangles, options.threads}, mesh) {}

  ColorReport run() {
    numbered_.number_corners();
    const auto drawn = find_range();
    if (drawn) {
      subdivide();
      const bool is_whole = !drawn->is_clamped && drawn->range.low < drawn->range.high;
      if (is_whole) find_range();  // there are more corners now
    } else {
      std::ranges::fill(mesh_.color, kNan);
    }
    report_.undefined_share = numbered_.separate_undefined();
    report_.reached_limit = numbered_.reached_limit();
    return report_;
  }

 private:
  void subdivide() {
    range_ = mesh_.color_range;
    numbered_.renew();
    for (int i = 0; i < kHalvingsToNearly && !numbered_.reached_limit(); ++i) {
      if (!split_bent_sides()) break;
    }
  }

  /// Sets the range of the colours. Returns nothing if there are no numbers.
  std::optional<DrawnColors> find_range() {
    const auto drawn = drawn_colors(surface_, mesh_, options_.rounding, options_.clip);
    if (!drawn) return std::nullopt;
    report_.is_clamped = drawn->is_clamped;
    mesh_.color_range = options_.range.value_or(drawn->range);
    auto& [low, high, below, above] = mesh_.color_range;
    const double rounding = kSame * (high - low);  // an end that is the extreme but for rounding
    below = drawn->all.low < low - rounding;
    above = drawn->all.high > high + rounding;
    return drawn;
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
      if (!numbered_.is_new(t)) continue;
      const Triangle& triangle = mesh_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k];
        const std::uint32_t b = next_corner(triangle, k);
        if (numbered_.may_be_split(a, b) && seen.insert(pair_of(a, b)).second)
          sides.push_back({a, b});
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
    const std::vector<double> numbers = numbered_.numbers(uv);
    numbered_.unmark();
    for (std::size_t i = 0; i < sides.size(); ++i) test_side(sides[i], &numbers[3 * i]);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      test_middle(mesh_.triangles[triangles[i]], numbers[3 * sides.size() + i]);
    }
    return numbered_.split_marked();
  }

  void test_side(const std::array<std::uint32_t, 2>& side, const double* numbers) {
    const double a = straight(mesh_.color[side[0]]);
    const double b = straight(mesh_.color[side[1]]);
    bool is_bent = std::isnan(a) != std::isnan(b);
    for (std::size_t k = 0; k < kOnSide.size(); ++k) {
      is_bent = is_bent || exceeds_tolerance(numbers[k], a + (b - a) * kOnSide[k]);
    }
    if (is_bent) numbered_.mark(side[0], side[1]);
  }

  /// A triangle that is wrong in the middle, but on no side, is halved along all of them.
  void test_middle(const Triangle& triangle, double number) {
    const auto& [a, b, c] = triangle;
    const double mean =
        (straight(mesh_.color[a]) + straight(mesh_.color[b]) + straight(mesh_.color[c])) / 3;
    if (!exceeds_tolerance(number, mean)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      if (numbered_.is_marked(triangle[k], next_corner(triangle, k))) return;
    }
    for (std::size_t k = 0; k < 3; ++k) numbered_.mark(triangle[k], next_corner(triangle, k));
  }

  const Surface& surface_;
  const ColorOptions& options_;
  Mesh& mesh_;
  ColorReport report_;
  ColorRange range_;
  NumberedMesh numbered_;
};

}  // namespace

ColorReport color_mesh(const Surface& surface, const ColorOptions& options, Mesh& mesh) {
  return ColorMesher(surface, options, mesh).run();
}

}  // namespace saddle
