#include "mesh/color_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/vector_relational.hpp>

namespace saddle {
namespace {

/// Shares of the area that are left outside where the numbers go to infinity: as many below as
/// above.
constexpr double kLeftOut = 0.05;

/// A climb begins with steps of this share of the ranges of u and v, and halves them so many times,
/// to the last digits of the parameters. Two steps of each length reach any place that is within
/// four of the first: a cell of the mesh away.
constexpr double kFirstStep = 1.0 / 32;
constexpr int kHalvings = 40;
constexpr int kStepsOfALength = 2;
/// A top is a pole if numbers at this share of the ranges on both sides of it, one way or another,
/// are lower by this share of the whole range, however far down the climb began. A logarithm's fall
/// by a third.
constexpr double kAround = 1e-8;
constexpr double kFalls = 0.1;

/// Numbers whose differences are this share of them are the same but for what rounding adds up to.
constexpr double kRounding = 1e-9;

/// What is drawn stands out of the box around the corners by the mesh's tolerance, at most by this
/// share of its size.
constexpr double kBesideBox = 0.01;

/// Numbers with the area that has them.
using Sample = std::pair<double, double>;

/// The number below which `share` of the area is.
double quantile(std::span<const Sample> sorted, double share) {
  double total = 0;
  for (const auto& [number, area] : sorted) total += area;
  double passed = 0;
  for (const auto& [number, area] : sorted) {
    passed += area;
    if (passed >= share * total) return number;
  }
  return sorted.back().first;
}

/// The triangles' numbers and areas, by number.
std::vector<Sample> samples_of(const Mesh& mesh) {
  std::vector<Sample> samples;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double number = (mesh.color[a] + mesh.color[b] + mesh.color[c]) / 3;
    const dvec3& p = mesh.position[a];
    const double area = glm::length(glm::cross(mesh.position[b] - p, mesh.position[c] - p));
    if (std::isfinite(number)) samples.emplace_back(number, area);
  }
  std::ranges::sort(samples);
  return samples;
}

/// Goes uphill from a corner, over what is drawn of the surface.
class Climber {
 public:
  Climber(const Surface& surface, const Mesh& mesh, double sign)
      : surface_(surface), mesh_(mesh), sign_(sign) {}

  /// Whether the top is a pole; `spread`: how far the lowest number is below.
  bool goes_to_infinity(dvec2 start, double number, double spread) {
    place_ = start;
    height_ = sign_ * number;
    const double bottom = height_ - spread;
    const Domain& d = surface_.domain;
    const dvec2 ranges(std::abs(d.u1 - d.u0), std::abs(d.v1 - d.v0));
    dvec2 step = kFirstStep * ranges;
    for (int i = 0; i < kHalvings && std::isfinite(height_); ++i, step *= 0.5) {
      for (int k = 0; k < kStepsOfALength && go_up(step); ++k) {
      }
    }
    return !std::isfinite(height_) || is_needle(kAround * ranges, kFalls * (height_ - bottom));
  }

 private:
  /// The eight places around, opposite ones four apart.
  std::array<dvec2, 8> around(const dvec2& step) const {
    constexpr std::array<dvec2, 8> kWays = {
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    const Domain& d = surface_.domain;
    const auto [low_u, high_u] = std::minmax(d.u0, d.u1);
    const auto [low_v, high_v] = std::minmax(d.v0, d.v1);
    std::array<dvec2, 8> places;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const dvec2 place = place_ + kWays[k] * step;
      places[k] = {std::clamp(place.x, low_u, high_u), std::clamp(place.y, low_v, high_v)};
    }
    return places;
  }

  /// One step to the highest of the places around.
  bool go_up(const dvec2& step) {
    const std::array<dvec2, 8> places = around(step);
    const std::vector<double> numbers = evaluate_color(surface_, places, 1);
    const std::vector<SurfacePoint> points = evaluate(surface_, places, 1);
    bool is_higher = false;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!(sign_ * numbers[k] > height_) || !is_drawn(points[k].position)) continue;
      height_ = sign_ * numbers[k];
      place_ = places[k];
      is_higher = true;
    }
    return is_higher;
  }

  /// Whether numbers fall that much on both sides, as they do not beside a jump.
  bool is_needle(const dvec2& step, double fall) const {
    const std::array<dvec2, 8> places = around(step);
    const std::vector<double> numbers = evaluate_color(surface_, places, 1);
    const auto falls = [&](std::size_t k) {
      return places[k] != place_ && !(height_ - sign_ * numbers[k] <= fall);  // NaN falls
    };
    for (std::size_t k = 0; k < 4; ++k) {
      if (falls(k) && falls(k + 4)) return true;
    }
    return false;
  }

  bool is_drawn(const dvec3& p) const {
    const dvec3 slack = dvec3(kBesideBox * mesh_.bounds.diagonal());
    return is_finite(p) && glm::all(glm::greaterThanEqual(p, mesh_.bounds.low - slack)) &&
           glm::all(glm::lessThanEqual(p, mesh_.bounds.high + slack));
  }

  const Surface& surface_;
  const Mesh& mesh_;
  double sign_;
  dvec2 place_{0, 0};
  double height_ = 0;
};

}  // namespace

DrawnColors drawn_colors(const Surface& surface, const Mesh& mesh, double rounding) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low = kInfinity;
  double high = -kInfinity;
  std::size_t lowest = 0;
  std::size_t highest = 0;
  for (std::size_t i = 0; i < mesh.color.size(); ++i) {
    if (mesh.color[i] < low) low = mesh.color[lowest = i];
    if (mesh.color[i] > high) high = mesh.color[highest = i];
  }
  if (low > high) return {};  // undefined everywhere
  const std::vector<Sample> samples = samples_of(mesh);
  if (samples.empty()) return {};
  const ColorRange most{quantile(samples, kLeftOut), quantile(samples, 1 - kLeftOut)};
  const double size = std::max(std::abs(low), std::abs(high));
  const bool is_rounding = rounding > 0 && most.high - most.low <= rounding;
  if (is_rounding || low == high || (std::isfinite(size) && high - low <= kRounding * size)) {
    const double middle = quantile(samples, 0.5);
    return {{middle, middle}};
  }
  DrawnColors drawn{{low, high}};
  const auto leaves = [&](std::size_t corner, double sign) {
    const double number = mesh.color[corner];
    return !std::isfinite(number) ||
           Climber(surface, mesh, sign).goes_to_infinity(mesh.uv[corner], number, high - low);
  };
  const bool has_pole_below = low < high && leaves(lowest, -1);
  const bool has_pole_above = low < high && leaves(highest, 1);
  if (has_pole_below) drawn.range.low = most.low;
  if (has_pole_above) drawn.range.high = most.high;
  drawn.is_clamped = has_pole_below || has_pole_above;
  return drawn;
}

}  // namespace saddle
