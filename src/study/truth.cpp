#include "study/truth.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "study/exact_surface.h"

namespace saddle {
namespace {

/// Points that a thread takes at a time: some milliseconds.
constexpr std::size_t kChunk = 16;

/// |r_u x r_v| up to this share of |r_u| |r_v| inside is zero but for the rounding of parameters:
/// pi as a double is 1e-16 beside a pole, on an arbitrary side.
const char* const kNoDirection = "1e-14";

/// The way to a corner: shares tau^2 of the way from inside. In tau, normals with a square root in
/// them are analytic. A cross product that vanishes like the square of the way keeps 26 digits at
/// the last.
constexpr int kExtrapolations = 4;
constexpr int kFirstExponent = 3;  // tau = 1e-3, 1e-4 ...

/// Limits that the last step of extrapolation still moves by more (radians) are none.
constexpr double kSettled = 1e-6;

dvec3 rounded(const RealVector& a) {
  return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}

bool is_number(const RealVector& a) {
  return std::ranges::all_of(a, [](const Real& x) { return isfinite(x); });
}

TruePosition split(const RealVector& r) {
  TruePosition result{rounded(r), dvec3(0)};
  for (int k = 0; k < 3; ++k) {
    const auto c = static_cast<std::size_t>(k);
    if (isfinite(r[c])) result.rest[k] = static_cast<double>(Real(r[c] - result.value[k]));
  }
  return result;
}

/// The unit normal of a point, or nothing where |r_u x r_v| is at most `least`.
std::optional<RealVector> direction(const ExactPoint& p, const Real& least) {
  if (!is_number(p.r_u) || !is_number(p.r_v)) return std::nullopt;
  RealVector across = cross(p.r_u, p.r_v);
  const Real size = length(across);
  if (!(size > least)) return std::nullopt;
  for (Real& component : across) component /= size;
  return across;
}

/// The limit along the way from inside, by Richardson's extrapolation to tau = 0.
std::optional<dvec3> limit(const ExactSurface& surface, const Approach& approach) {
  std::array<RealVector, kExtrapolations> row;
  RealVector before;
  for (int i = 0; i < kExtrapolations; ++i) {
    const Real share = pow(Real(10), -2 * (kFirstExponent + i));
    const auto at = [&](double corner, double inside) {
      return Real(corner + (Real(inside) - corner) * share);
    };
    const auto normal = direction(
        surface(at(approach.corner.x, approach.inside.x), at(approach.corner.y, approach.inside.y)),
        Real(0));
    if (!normal) return std::nullopt;
    RealVector entry = *normal;
    Real power = 1;
    for (int k = 0; k < i; ++k) {
      power *= 10;
      const RealVector last = row[static_cast<std::size_t>(k)];
      row[static_cast<std::size_t>(k)] = entry;
      for (std::size_t c = 0; c < 3; ++c) entry[c] += (entry[c] - last[c]) / (power - 1);
    }
    row[static_cast<std::size_t>(i)] = entry;
    if (i + 1 < kExtrapolations) before = entry;
  }
  const RealVector& last = row.back();
  if (glm::distance(rounded(last), rounded(before)) > kSettled) return std::nullopt;
  return glm::normalize(rounded(last));
}

std::optional<dvec3> normal(const ExactSurface& surface, const Approach& approach) {
  const ExactPoint inside = surface(approach.inside.x, approach.inside.y);
  const Real least = Real(kNoDirection) * length(inside.r_u) * length(inside.r_v);
  const auto there = direction(surface(approach.corner.x, approach.corner.y), least);
  return there ? rounded(*there) : limit(surface, approach);
}

}  // namespace

struct Truth::Impl {
  ExactSurface surface;
};

Truth::Truth(const Scene& scene, const SurfaceSpec& spec)
    : impl_(std::make_unique<Impl>(Impl{ExactSurface(scene, spec)})) {}
Truth::~Truth() = default;

std::vector<TruePosition> Truth::positions(std::span<const dvec2> uv, unsigned threads) const {
  std::vector<TruePosition> result(uv.size());
  parallel_chunks(uv.size(), kChunk, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      result[i] = split(impl_->surface.position(uv[i].x, uv[i].y));
    }
  });
  return result;
}

std::vector<std::optional<dvec3>> Truth::normals(std::span<const Approach> approaches,
                                                 unsigned threads) const {
  std::vector<std::optional<dvec3>> result(approaches.size());
  parallel_chunks(approaches.size(), kChunk, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      result[i] = normal(impl_->surface, approaches[i]);
    }
  });
  return result;
}

}  // namespace saddle
