#include "mesh/adaptive_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.h"
#include "mesh/degenerate.h"
#include "mesh/leaf_mesh.h"
#include "mesh/measure.h"
#include "mesh/refine.h"
#include "mesh/tidy.h"
#include "mesh/weld.h"

namespace saddle {

namespace {

/// Times that leaves which fail on fresh samples are halved again.
constexpr int kRounds = 8;
/// What a sample finds at a kink says nothing about how fine the mesh must be.
constexpr double kMostStrict = 4;
/// Fresh samples in a leaf, away from where it was tested: within this part of its sides.
constexpr std::size_t kFreshSamples = 3;
constexpr double kFreshMargin = 0.1;
/// More lines than this each way cannot be numbered by a lattice.
constexpr std::size_t kMaxLines = 60000;

FixedLines fixed_lines(const Domain& domain, const AdaptiveOptions& options) {
  const auto lines = [](double first, double last, int count) {
    return even_lines(first, last, static_cast<std::size_t>(std::max(count, 2) - 1));
  };
  return {lines(domain.u0, domain.u1, options.lines_u),
          lines(domain.v0, domain.v1, options.lines_v)};
}

std::size_t cells(const FixedLines& lines) {
  return (lines.u.size() - 1) * (lines.v.size() - 1);
}

/// The lines of the root grid: coarser than the tolerance asks where that would take more triangles
/// than are allowed.
FixedLines root_lines(const Probe& probe, const Domain& domain, const Tolerance& tolerance,
                      const AdaptiveOptions& options, MeshReport& report) {
  const FixedLines fixed = fixed_lines(domain, options);
  FixedLines lines = probe.place_lines(fixed, tolerance);
  for (double factor = 2; 2 * cells(lines) > options.max_triangles && cells(lines) > cells(fixed);
       factor *= 2) {
    report.reached_limit = true;
    lines = probe.place_lines(fixed, [&](const dvec3& p) { return factor * tolerance(p); });
  }
  return lines;
}

bool is_usable(const Bounds& bounds, const Tolerance& tolerance) {
  if (bounds.empty() || !std::isnormal(bounds.diagonal())) return false;
  const double eps = tolerance(bounds.centre());
  return eps > 0 && std::isfinite(eps);
}

/// The leaves of a mesh and what they were last found to deviate by.
struct Measured {
  std::vector<Leaf> leaves;
  std::vector<Deviation> deviations;  ///< as many as leaves, or fewer: the rest is not measured yet
};

/// Measures leaves on fresh samples.
class Verifier {
 public:
  Verifier(const Surface& surface, const Grid& grid, const Lattice& lattice, unsigned threads)
      : surface_(surface), grid_(grid), lattice_(lattice), threads_(threads) {}

  /// Measures leaves from their triangles, the largest deviation of each.
  void measure(Measured& mesh, std::span<const std::size_t> which, const LeafTriangles& triangles) {
    std::vector<dvec2> uv;
    uv.reserve(which.size() * kFreshSamples);
    for (const std::size_t leaf : which) {
      const dvec2 low = lattice_.parameters(mesh.leaves[leaf].low);
      const dvec2 high = lattice_.parameters(mesh.leaves[leaf].high);
      for (std::size_t s = 0; s < kFreshSamples; ++s) {
        const dvec2 part(fresh(), fresh());
        uv.push_back(low * (1.0 - part) + high * part);
      }
    }
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
    evaluations_ += points.size();
    mesh.deviations.resize(mesh.leaves.size());
    for (std::size_t k = 0; k < which.size(); ++k) {
      Deviation& worst = mesh.deviations[which[k]] = {};
      for (std::size_t s = 0; s < kFreshSamples; ++s) {
        const SurfacePoint& point = points[k * kFreshSamples + s];
        const Deviation d = deviation(grid_, triangles.of(which[k]), point, surface_.flip);
        worst.distance = std::max(worst.distance, d.distance);
        worst.degrees = std::max(worst.degrees, d.degrees);
      }
    }
  }

  std::size_t evaluations() const { return evaluations_; }

 private:
  double fresh() { return kFreshMargin + (1 - 2 * kFreshMargin) * random_unit(key_++); }

  const Surface& surface_;
  const Grid& grid_;
  const Lattice& lattice_;
  unsigned threads_;
  std::uint64_t key_ = 0;
  std::size_t evaluations_ = 0;
};

std::vector<std::size_t> numbers(std::size_t begin, std::size_t end) {
  std::vector<std::size_t> result(end - begin);
  std::iota(result.begin(), result.end(), begin);
  return result;
}

/// How many times worse than allowed a leaf is.
double excess(const Deviation& d, double eps, double normal_tolerance) {
  const double turn = std::min(d.degrees, 180 - d.degrees) / normal_tolerance;  // see refine.cpp
  return std::max(d.distance / eps, turn * turn);
}

/// Takes the leaves that deviate too much out of `mesh` and halves them.
std::vector<Leaf> take_failed(Measured& mesh, const RefineOptions& options, const Grid& grid,
                              Lattice& lattice) {
  Measured kept;
  std::vector<Leaf> halves;
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    const std::uint32_t corner = *lattice.used_vertex(leaf.low);
    const double eps = options.tolerance(grid.mesh.position[corner]);
    const double too_much = excess(mesh.deviations[k], eps, options.normal_tolerance);
    // The leaf's longer way: what the tests along its sides did not see, they see at half.
    const bool longer_u = leaf.size_u() >= leaf.size_v();
    const auto two = too_much > 1 && !leaf.given_up ? halve(leaf, longer_u, lattice) : std::nullopt;
    if (!two) {
      kept.leaves.push_back(leaf);
      kept.deviations.push_back(mesh.deviations[k]);
      continue;
    }
    for (Leaf half : *two) {
      half.strictness *= static_cast<float>(std::min(too_much, kMostStrict));
      halves.push_back(half);
    }
  }
  mesh = std::move(kept);
  return halves;
}

}  // namespace

std::optional<GridMesh> mesh_within_tolerance(const Surface& surface,
                                              const AdaptiveOptions& options) {
  const Probe probe(surface, options.threads);
  const Tolerance tolerance = options.tolerance(probe);
  if (!is_usable(probe.bounds(), tolerance)) return std::nullopt;
  GridMesh result;
  MeshReport& report = result.report;
  FixedLines lines = root_lines(probe, surface.domain, tolerance, options, report);
  if (std::max(lines.u.size(), lines.v.size()) > kMaxLines) return std::nullopt;
  Grid grid = sample_grid(surface, std::move(lines.u), std::move(lines.v), options.threads);
  if (grid.left_out_count > 0) return std::nullopt;
  require_two_dimensional(surface, grid, options.threads);
  const Seams seams = weld(grid);
  Lattice lattice(surface, grid);

  const RefineOptions refining = {tolerance, options.normal_tolerance, options.max_triangles,
                                  options.threads};
  Refinement refinement = refine(root_leaves(grid), refining, grid, lattice);
  if (!refinement.all_defined) return std::nullopt;
  Measured measured{std::move(refinement.leaves), {}};
  std::vector<Leaf>& leaves = measured.leaves;
  Verifier verifier(surface, grid, lattice, options.threads);
  for (int round = 0;; ++round) {
    mirror_seams(seams, options.threads, grid, lattice);
    const LeafTriangles draft = triangulate_leaves(leaves, SingularCorners(), grid, lattice);
    verifier.measure(measured, numbers(measured.deviations.size(), leaves.size()), draft);
    if (round == kRounds) break;
    const std::vector<Leaf> halves = take_failed(measured, refining, grid, lattice);
    if (halves.empty()) break;
    const Refinement more = refine(halves, refining, grid, lattice);
    if (!more.all_defined) return std::nullopt;
    leaves.insert(leaves.end(), more.leaves.begin(), more.leaves.end());
    refinement.reached_limit = refinement.reached_limit || more.reached_limit;
  }
  const SingularCorners singular(surface, leaves, lattice, options.threads, grid, report);
  LeafTriangles triangles = triangulate_leaves(leaves, singular, grid, lattice);
  verifier.measure(measured, singular.leaves(), triangles);
  for (const Deviation& d : measured.deviations) {
    report.max_error = std::max(report.max_error, d.distance);
    report.max_normal_error = std::max(report.max_normal_error, d.degrees);
  }
  report.cells = leaves.size();
  report.reached_limit = report.reached_limit || refinement.reached_limit;
  report.tolerance = tolerance(probe.bounds().centre());
  report.least_triangles = probe.least_triangles(tolerance);
  report.closed_u = seams.closed_u;
  report.closed_v = seams.closed_v;
  report.evaluations +=
      probe.evaluations() + grid.vertex_count() + lattice.evaluations() + verifier.evaluations();
  grid.mesh.triangles = std::move(triangles.all);
  grid.mesh.lines = leaf_lines(grid, lattice, options.lines_u, options.lines_v);
  keep_used_corners(grid.mesh);
  result.mesh = std::move(grid.mesh);
  return result;
}

}  // namespace saddle
