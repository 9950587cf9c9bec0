#include "mesh/verify.h"

#include <algorithm>
#include <limits>

#include "base/random.h"

namespace saddle {

namespace {

/// One fresh sample in each quarter of a leaf, up to this part of its sides from the quarter's
/// middle: there the error of an arc with a turning point is largest, which its middle does not
/// show.
constexpr std::size_t kQuarters = 4;
constexpr double kJitter = 0.15;

/// Where a leaf's s-th sample is, in sides of the leaf: always the same for the same leaf.
dvec2 sample_place(const Leaf& leaf, std::size_t s) {
  std::uint64_t seed = 0;
  for (const std::uint32_t part : {leaf.low.u, leaf.low.v, leaf.size_u(), leaf.size_v()}) {
    seed = (seed ^ part) * 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio: spreads the bits
    seed ^= seed >> 32U;
  }
  const auto jitter = [&](std::uint64_t axis) {
    return kJitter * (2 * random_unit(seed + 2 * s + axis) - 1);
  };
  return {(s % 2 == 0 ? 0.25 : 0.75) + jitter(0), (s / 2 == 0 ? 0.25 : 0.75) + jitter(1)};
}

bool share_corner(const Triangle& a, const Triangle& b) {
  return std::ranges::any_of(
      a, [&](std::uint32_t corner) { return std::ranges::find(b, corner) != b.end(); });
}

/// Triangles from the front that are connected; those of a leaf's pieces follow each other.
std::size_t count_connected(std::span<const Triangle> triangles) {
  std::size_t count = 1;
  const auto is_connected = [&](const Triangle& t) {
    return std::ranges::any_of(triangles.first(count),
                               [&](const Triangle& other) { return share_corner(t, other); });
  };
  while (count < triangles.size() && is_connected(triangles[count])) ++count;
  return count;
}

}  // namespace

/// Where a leaf is cut, its pieces meet along a chord of the true line: what lies between the two
/// is no farther from the surface than the other piece, and faces as that one does.
Deviation Verifier::deviation_of(const Leaf& leaf, std::span<const Triangle> triangles,
                                 const dvec2& uv, const SurfacePoint& point) const {
  if (!leaf.is_split || triangles.empty())
    return deviation(grid_, triangles, uv, point, surface_.flip);
  Deviation best{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  while (!triangles.empty()) {
    const std::size_t count = count_connected(triangles);
    const Deviation d = deviation(grid_, triangles.first(count), uv, point, surface_.flip);
    best.distance = std::min(best.distance, d.distance);
    best.degrees = std::min(best.degrees, d.degrees);
    triangles = triangles.subspan(count);
  }
  return best;
}

void Verifier::append_samples(const Leaf& leaf, std::span<const Triangle> triangles,
                              std::vector<dvec2>& uv) const {
  const dvec2 low = lattice_.parameters(leaf.low);
  const dvec2 high = lattice_.parameters(leaf.high);
  for (std::size_t s = 0; s < kQuarters; ++s) {
    const dvec2 part = sample_place(leaf, s);
    uv.push_back(low * (1.0 - part) + high * part);
  }
  if (triangles.size() <= 2) return;
  // The diagonals of a leaf with more corners were not tested: the middles of its triangles are.
  const auto& at = grid_.mesh.uv;
  for (const Triangle& t : triangles) uv.push_back((at[t[0]] + at[t[1]] + at[t[2]]) / 3.0);
}

void Verifier::measure(Measured& mesh, std::span<const std::size_t> which,
                       const LeafTriangles& triangles) {
  std::vector<dvec2> uv;
  uv.reserve(which.size() * kQuarters);
  std::vector<std::size_t> first;  // sample of each leaf, and the end
  first.reserve(which.size() + 1);
  for (std::size_t k = 0; k < which.size(); ++k) {
    first.push_back(uv.size());
    append_samples(mesh.leaves[which[k]], triangles.of(k), uv);
  }
  first.push_back(uv.size());
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += points.size();
  mesh.deviations.resize(mesh.leaves.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    Deviation& worst = mesh.deviations[which[k]] = {};
    for (std::size_t s = first[k]; s < first[k + 1]; ++s) {
      const Deviation d = deviation_of(mesh.leaves[which[k]], triangles.of(k), uv[s], points[s]);
      worst.distance = std::max(worst.distance, d.distance);
      worst.degrees = std::max(worst.degrees, d.degrees);
    }
  }
}

}  // namespace saddle
