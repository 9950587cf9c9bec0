#include "mesh/color/drawn_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/surface.h"

namespace saddle {
namespace {

/// Part of the area outside of the range, at each end where the numbers go to infinity.
constexpr double kLeftOut = 0.05;

/// A maximum is a pole if numbers fall on two opposite sides of it, at kSame of the ranges, by 0.1
/// of its height above the lowest number. A logarithm falls by a third there.
constexpr double kFalls = 0.1;

/// If numbers go to infinity, few triangles hold most of the range. Each is then cut into this many
/// parts a side.
constexpr int kParts = 6;

/// Numbers with the area that has them.
using Sample = std::pair<double, double>;

/// The number below which `share` of the area is.
double sample_quantile(std::span<const Sample> sorted, double share) {
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

/// The same for parts of triangles: even lines cut each into kParts^2.
std::vector<Sample> fine_samples_of(const Surface& surface, const Mesh& mesh) {
  std::vector<dvec2> middles;
  std::vector<Sample> samples;
  for (const auto& [a, b, c] : mesh.triangles) {
    const dvec3& p = mesh.position[a];
    const double area = glm::length(glm::cross(mesh.position[b] - p, mesh.position[c] - p));
    const dvec2 s = (mesh.uv[b] - mesh.uv[a]) / (3.0 * kParts);
    const dvec2 r = (mesh.uv[c] - mesh.uv[a]) / (3.0 * kParts);
    for (int i = 0; i < kParts; ++i) {
      for (int j = 0; i + j < kParts; ++j) {
        middles.push_back(mesh.uv[a] + (3.0 * i + 1) * s + (3.0 * j + 1) * r);
        samples.emplace_back(0, area);
        if (i + j + 1 == kParts) continue;
        middles.push_back(mesh.uv[a] + (3.0 * i + 2) * s + (3.0 * j + 2) * r);
        samples.emplace_back(0, area);
      }
    }
  }
  const std::vector<double> numbers = evaluate_color(surface, middles, 1);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].first = numbers[i];
  std::erase_if(samples, [](const Sample& sample) { return !std::isfinite(sample.first); });
  std::ranges::sort(samples);
  return samples;
}

/// A compass search uphill from a corner, within the drawn part of the surface.
class Climber {
 public:
  Climber(const Surface& surface, const std::optional<Bounds>& clip, double sign)
      : surface_(surface), clip_(clip), sign_(sign) {}

  /// The maximum, nothing if it is a pole. `spread`: the difference to the lowest number.
  std::optional<double> climb(dvec2 start, double number, double spread) {
    place_ = start;
    height_ = sign_ * number;
    const double bottom = height_ - spread;
    const Domain& d = surface_.domain;
    const dvec2 ranges(std::abs(d.u1 - d.u0), std::abs(d.v1 - d.v0));
    // Two steps of each length reach any place within four first steps, as far as a cell of the
    // mesh.
    for (double share = kFirstSide; share > kRounding && std::isfinite(height_); share /= 2) {
      if (go_up(share * ranges)) go_up(share * ranges);
    }
    if (!std::isfinite(height_)) return std::nullopt;
    if (is_needle(kSame * ranges, kFalls * (height_ - bottom))) return std::nullopt;
    return sign_ * height_;
  }

 private:
  /// The eight places around, opposite ones four apart.
  std::array<dvec2, 8> around(const dvec2& step) const {
    const Domain& d = surface_.domain;
    const auto [low_u, high_u] = std::minmax(d.u0, d.u1);
    const auto [low_v, high_v] = std::minmax(d.v0, d.v1);
    std::array<dvec2, 8> places;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const dvec2 place = place_ + kEightWays[k] * step;
      places[k] = {std::clamp(place.x, low_u, high_u), std::clamp(place.y, low_v, high_v)};
    }
    return places;
  }

  /// Steps to the highest of the places around.
  bool go_up(const dvec2& step) {
    const std::array<dvec2, 8> places = around(step);
    const std::vector<double> numbers = evaluate_color(surface_, places, 1);
    std::vector<SurfacePoint> points;
    if (clip_) points = evaluate(surface_, places, 1);
    bool is_higher = false;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!(sign_ * numbers[k] > height_)) continue;
      if (clip_ && !clip_->contains(points[k].position)) continue;
      height_ = sign_ * numbers[k];
      place_ = places[k];
      is_higher = true;
    }
    return is_higher;
  }

  /// Whether numbers fall by that much on two opposite sides; beside a jump they do on one.
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

  const Surface& surface_;
  const std::optional<Bounds>& clip_;
  double sign_;
  dvec2 place_{0, 0};
  double height_ = 0;
};

/// The lowest and the highest number, and their corners.
struct Ends {
  ColorRange range{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  std::size_t lowest = 0;
  std::size_t highest = 0;

  explicit Ends(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.color.size(); ++i) {
      if (mesh.color[i] < range.low) range.low = mesh.color[lowest = i];
      if (mesh.color[i] > range.high) range.high = mesh.color[highest = i];
    }
  }
};

/// Whether all numbers are equal within rounding.
bool are_one_number(const ColorRange& all, const ColorRange& most, double rounding) {
  const double size = std::max(std::abs(all.low), std::abs(all.high));
  const bool is_rounding = rounding > 0 && most.high - most.low <= rounding;
  return is_rounding || all.low == all.high ||
         (std::isfinite(size) && all.high - all.low <= kSame * size);
}

}  // namespace

std::optional<DrawnColors> drawn_colors(const Surface& surface, const Mesh& mesh, double rounding,
                                        const std::optional<Bounds>& clip) {
  const std::vector<Sample> samples = samples_of(mesh);
  if (samples.empty()) return std::nullopt;
  const Ends ends(mesh);
  const ColorRange most{sample_quantile(samples, kLeftOut), sample_quantile(samples, 1 - kLeftOut)};
  if (are_one_number(ends.range, most, rounding)) {
    const double middle = sample_quantile(samples, 0.5);
    return DrawnColors{{middle, middle}, {middle, middle}};
  }
  const double spread = samples.back().first - samples.front().first;  // finite
  const auto top = [&](std::size_t corner, double sign) -> std::optional<double> {
    const double number = mesh.color[corner];
    if (!std::isfinite(number)) return std::nullopt;
    return Climber(surface, clip, sign).climb(mesh.uv[corner], number, spread);
  };
  const std::optional<double> low = top(ends.lowest, -1);
  const std::optional<double> high = top(ends.highest, 1);
  if (low && high) return DrawnColors{{*low, *high}, {*low, *high}};
  const std::vector<Sample> fine = fine_samples_of(surface, mesh);
  return DrawnColors{{low ? *low : sample_quantile(fine, kLeftOut),
                      high ? *high : sample_quantile(fine, 1 - kLeftOut)},
                     {low.value_or(-kInfinity), high.value_or(kInfinity)},
                     true};
}

}  // namespace saddle
