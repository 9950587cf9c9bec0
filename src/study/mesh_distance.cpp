#include "study/mesh_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "base/random.h"
#include "mesh/model/triangle_tree.h"
#include "study/descent.h"

namespace saddle {
namespace {

/// The domain is cut into so many tiles each way; of each the true surface is looked at in a random
/// point, and in that of kScan x kScan points at which its neighbours are farthest from straight.
constexpr int kTiles = 64;
constexpr int kScan = 12;
/// Points on each edge of the domain.
constexpr int kEdgePoints = 256;

/// The worst points are moved to where they are worse: so many, in so many steps.
constexpr std::size_t kClimbers = 32;
constexpr int kClimbs = 14;

/// Triangles of which points are taken: all, or the largest and some at random.
constexpr std::size_t kLargest = 1024;
constexpr std::size_t kAtRandom = 8192;

/// The farthest points that descend again at a time.
constexpr std::size_t kSecondTries = 256;

constexpr std::size_t kPointChunk = 64;
constexpr std::uint64_t kSeed = 0x5eed;

bool is_inside(const std::optional<Bounds>& box, const dvec3& p) {
  return !box || box->contains(p);
}

dvec2 at_share(const Domain& d, const dvec2& share) {
  return {d.u0 + (d.u1 - d.u0) * share.x, d.v0 + (d.v1 - d.v0) * share.y};
}

dvec2 random_pair(std::size_t k) {
  return {random_unit(kSeed + 2 * k), random_unit(kSeed + 2 * k + 1)};
}

/// The scanned point of each tile where the surface bends most, as parameters.
void append_bends(const Subject& subject, std::vector<dvec2>& uv) {
  constexpr int kSide = kTiles * kScan;
  std::vector<dvec2> scan;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const dvec2 share = (dvec2(i, j) + random_pair(scan.size())) / static_cast<double>(kSide);
      scan.push_back(at_share(subject.bound.domain, share));
    }
  }
  const std::vector<SurfacePoint> points = evaluate(subject.surface, scan, subject.threads);
  const auto bend = [&](int i, int j, int di, int dj) {
    const auto p = [&](std::ptrdiff_t k) {
      const std::ptrdiff_t row = j + k * dj;
      const std::ptrdiff_t column = i + k * di;
      return points[static_cast<std::size_t>(row * kSide + column)].position;
    };
    const double height = glm::length(p(-1) - 2.0 * p(0) + p(1));
    return std::isfinite(height) ? height : 0.0;
  };
  for (int tile = 0; tile < kTiles * kTiles; ++tile) {
    std::size_t worst = 0;
    double most = -1;
    for (int k = 0; k < kScan * kScan; ++k) {
      const int i = std::clamp(tile % kTiles * kScan + k % kScan, 1, kSide - 2);
      const int j = std::clamp(tile / kTiles * kScan + k / kScan, 1, kSide - 2);
      const double height = std::max(bend(i, j, 1, 0), bend(i, j, 0, 1));
      if (height <= most) continue;
      most = height;
      worst = static_cast<std::size_t>(j) * kSide + i;
    }
    uv.push_back(scan[worst]);
  }
}

std::vector<dvec2> places(const Subject& subject) {
  std::vector<dvec2> uv;
  append_bends(subject, uv);
  for (int tile = 0; tile < kTiles * kTiles; ++tile) {
    const dvec2 share = (dvec2(tile % kTiles, tile / kTiles) + random_pair(uv.size())) /
                        static_cast<double>(kTiles);
    uv.push_back(at_share(subject.bound.domain, share));
  }
  for (int k = 0; k <= kEdgePoints; ++k) {
    const double s = static_cast<double>(k) / kEdgePoints;
    for (const dvec2& share : {dvec2(s, 0), dvec2(s, 1), dvec2(0, s), dvec2(1, s)}) {
      uv.push_back(at_share(subject.bound.domain, share));
    }
  }
  return uv;
}

/// The indices of the `count` largest, the largest first.
std::vector<std::size_t> largest(const std::vector<double>& values, std::size_t count) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  count = std::min(count, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  order.resize(count);
  return order;
}

std::vector<double> distances(const TriangleTree& tree, const std::vector<dvec3>& points,
                              unsigned threads) {
  std::vector<double> result(points.size());
  parallel_chunks(points.size(), kPointChunk, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      result[k] = is_finite(points[k]) ? tree.distance(points[k]) : 0;
    }
  });
  return result;
}

/// The middles of some triangles and of their edges.
std::vector<Descent> mesh_points(const Mesh& mesh, const std::optional<Bounds>& clip) {
  std::vector<std::size_t> chosen;
  const std::size_t count = mesh.triangles.size();
  if (count <= kLargest + kAtRandom) {
    chosen.resize(count);
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  } else {
    std::vector<double> sizes;
    for (const Triangle& t : mesh.triangles) {
      sizes.push_back(glm::distance(mesh.position[t[0]], mesh.position[t[1]]) +
                      glm::distance(mesh.position[t[1]], mesh.position[t[2]]));
    }
    chosen = largest(sizes, kLargest);
    for (std::size_t k = 0; k < kAtRandom; ++k) {
      chosen.push_back(
          static_cast<std::size_t>(random_unit(kSeed + k) * static_cast<double>(count)));
    }
  }
  constexpr std::array<dvec3, 4> kWeights = {dvec3(1.0 / 3), dvec3(0.5, 0.5, 0), dvec3(0, 0.5, 0.5),
                                             dvec3(0.5, 0, 0.5)};
  std::vector<Descent> points;
  for (const std::size_t k : chosen) {
    const Triangle& t = mesh.triangles[k];
    for (const dvec3& w : kWeights) {
      Descent d;
      d.from = w.x * mesh.position[t[0]] + w.y * mesh.position[t[1]] + w.z * mesh.position[t[2]];
      for (std::size_t i = 0; i < 3; ++i) d.corners[i] = mesh.uv[t[i]];
      d.uv = d.place = w.x * d.corners[0] + w.y * d.corners[1] + w.z * d.corners[2];
      if (is_inside(clip, d.from)) points.push_back(d);
    }
  }
  return points;
}

}  // namespace

MeshDistance::MeshDistance(const Subject& subject) : subject_(subject) {
  const std::vector<dvec2> uv = places(subject);
  const std::vector<TruePosition> truth = subject.truth.positions(uv, subject.threads);
  for (std::size_t k = 0; k < uv.size(); ++k) {
    if (!is_finite(truth[k].value) || !is_inside(subject.clip, truth[k].value)) continue;
    uv_.push_back(uv[k]);
    points_.push_back(truth[k].value);
  }
}

double MeshDistance::operator()(const Mesh& mesh) const {
  return from_mesh(mesh, from_surface(mesh));
}

double MeshDistance::from_surface(const Mesh& mesh) const {
  const TriangleTree tree(mesh, subject_.threads);
  const std::vector<double> found = distances(tree, points_, subject_.threads);
  const std::vector<std::size_t> worst = largest(found, kClimbers);
  std::vector<dvec2> at;
  std::vector<double> heights;
  for (const std::size_t k : worst) {
    at.push_back(uv_[k]);
    heights.push_back(found[k]);
  }
  const Domain& d = subject_.bound.domain;
  dvec2 reach = glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0)) / static_cast<double>(kTiles);
  constexpr std::array<dvec2, 4> kAxes = {dvec2(1, 0), dvec2(-1, 0), dvec2(0, 1), dvec2(0, -1)};
  for (int round = 0; round < kClimbs; ++round, reach *= 0.6) {
    std::vector<dvec2> tries;
    for (const dvec2& uv : at) {
      for (const dvec2& axis : kAxes) {
        tries.push_back(in_domain(d, uv + axis * reach));
      }
    }
    std::vector<dvec3> positions;
    for (const SurfacePoint& p : evaluate(subject_.surface, tries, subject_.threads)) {
      const bool counts = is_finite(p.position) && is_inside(subject_.clip, p.position);
      positions.push_back(counts ? p.position : dvec3(std::nan("")));
    }
    const std::vector<double> there = distances(tree, positions, subject_.threads);
    for (std::size_t k = 0; k < there.size(); ++k) {
      if (there[k] <= heights[k / kAxes.size()]) continue;
      heights[k / kAxes.size()] = there[k];
      at[k / kAxes.size()] = tries[k];
    }
  }
  return heights.empty() ? 0 : std::ranges::max(heights);
}

/// No less than `known`: what is nearer need not be found.
double MeshDistance::from_mesh(const Mesh& mesh, double known) const {
  std::vector<Descent> points = mesh_points(mesh, subject_.clip);
  descend(subject_, points);
  std::erase_if(points, [known](const Descent& d) { return d.distance <= known; });
  std::vector<double> left;  // distances of points that have not been looked at twice
  left.reserve(points.size());
  for (const Descent& d : points) left.push_back(d.distance);
  double worst = known;
  while (true) {
    std::vector<Descent> farthest;
    for (const std::size_t k : largest(left, kSecondTries)) {
      if (left[k] <= worst) break;
      farthest.push_back(points[k]);
      left[k] = 0;
    }
    if (farthest.empty()) return worst;
    for (const double distance : descend_again(subject_, farthest, uv_, points_)) {
      worst = std::max(worst, distance);
    }
  }
}

}  // namespace saddle
