#include "mesh/error/estimate_many.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "mesh/error/error_loops.h"
#include "mesh/grid/vertex_columns.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

namespace {

void take(const Mesh& mesh, std::uint32_t vertex, std::size_t i, LeafVertices& to) {
  put_vertex(mesh.position[vertex], mesh.normal[vertex], i, to);
}

/// Stores the samples of a leaf in the i-th place of the columns.
void take_leaf(const Leaf& leaf, const ErrorIndicator& indicator, const CellTree& tree, double eps,
               std::size_t i, LeafSamples& to) {
  const SampleVertices& samples = leaf.samples;
  const Mesh& mesh = tree.mesh();
  for (std::size_t k = 0; k < 4; ++k) {
    take(mesh, samples.corner[k], i, to.corner[k]);
    take(mesh, samples.side[k], i, to.side[k]);
    to.counts[k][i] = tree.vertices().is_used(samples.side[k]) ? 0 : 1;
    to.seen[k][i] = indicator.is_seen(leaf, k) ? 1 : 0;
  }
  take(mesh, samples.centre, i, to.centre);
  to.seen_turn[i] = kSeenTurn * eps;
}

/// Whether normals of samples are limits: they tell nothing about the leaf's errors.
bool has_limits(const SampleVertices& samples, const CellTree& tree) {
  const auto is_limit = [&](std::uint32_t vertex) { return !tree.geometry().is_regular(vertex); };
  return is_limit(samples.centre) || std::ranges::any_of(samples.corner, is_limit) ||
         std::ranges::any_of(samples.side, is_limit);
}

ErrorRatios take(const LeafRatios& ratios, std::size_t i) {
  return {ratios.along_u[i], ratios.along_v[i], ratios.centre[i]};
}

ErrorRatios in_tolerances(const ErrorRatios& distances, double tolerance) {
  return {distances.along_u / tolerance, distances.along_v / tolerance,
          distances.centre / tolerance};
}

/// The square of the tangent of an angle; infinite from 90 degrees on.
double squared_tangent_of(double degrees) {
  if (!(degrees < 90)) return std::numeric_limits<double>::infinity();
  const double tangent = std::tan(degrees * std::numbers::pi / 180);
  return tangent * tangent;
}

}  // namespace

FastCellErrors estimate_many(std::span<const Leaf> leaves, const CellLimits& limits,
                             const ErrorIndicator& indicator, const CellTree& tree) {
  FastCellErrors result{std::vector<FastCellError>(leaves.size()), {}};
  const auto block = std::make_unique_for_overwrite<LeafSamples>();
  const auto errors = std::make_unique_for_overwrite<LeafErrors>();
  const EstimateLeaves loop = estimate_loop(cpu_level());
  const double allowed_turn = squared_tangent_of(limits.normal_tolerance);
  std::array<std::size_t, kLeafBlock> which;
  LeafNumbers tolerance;
  std::size_t count = 0;
  const auto put_result = [&](std::size_t i) {
    const Leaf& leaf = leaves[which[i]];
    FastCellError& fast = result.leaves[which[i]];
    const ErrorRatios distance = take(errors->distance, i);
    const ErrorRatios turn = take(errors->square_of_tangent, i);
    const double safety = leaf.normal_safety;
    const double allowed = safety == 1
                               ? allowed_turn
                               : squared_tangent_of(limits.normal_tolerance / std::sqrt(safety));
    const double worst = distance.worst() / tolerance[i];
    if (worst * leaf.safety <= 1 && turn.worst() <= allowed) {
      fast.is_known = fast.passes = true;
      fast.distance = static_cast<float>(worst);
      return;
    }
    if (limits.clip || has_limits(leaf.samples, tree)) return;
    fast.is_known = true;
    fast.error = static_cast<std::uint32_t>(result.errors.size());
    CellError& error = result.errors.emplace_back();
    error.distance = in_tolerances(distance, tolerance[i]);
    error.gap = error.distance;
    error.gap.centre = errors->gap_at_centre[i] / tolerance[i];
    error.turn = indicator.turn_ratios(turn);
  };
  const auto flush = [&] {
    loop(*block, count, *errors);
    for (std::size_t i = 0; i < count; ++i) {
      if (errors->is_plain[i] > 0) put_result(i);
    }
    count = 0;
  };
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const Leaf& leaf = leaves[k];
    if (!leaf.state.is_whole() || leaf.state.leads_to_pole()) continue;
    which[count] = k;
    tolerance[count] = indicator.allowed(leaf);
    take_leaf(leaf, indicator, tree, tolerance[count], count, *block);
    if (++count == kLeafBlock) flush();
  }
  if (count > 0) flush();
  return result;
}

}  // namespace saddle
