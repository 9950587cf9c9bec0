#include "mesh/error/estimate_many.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "mesh/error/error_loops.h"
#include "mesh/grid/vertex_columns.h"
#include "mesh/model/tolerances.h"
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

/// The estimate of a chunk of leaves, on one thread.
class ChunkEstimate {
 public:
  /// `results`: of the leaves.
  ChunkEstimate(std::span<const Leaf> leaves, const CellLimits& limits,
                const ErrorIndicator& indicator, const CellTree& tree,
                std::span<FastCellError> results)
      : leaves_(leaves),
        limits_(limits),
        indicator_(indicator),
        tree_(tree),
        results_(results),
        allowed_turn_(squared_tangent_of(limits.normal_tolerance)) {}

  /// Sets the results. FastCellError::error is a number in the list that it returns.
  std::vector<CellError> estimate() {
    for (std::size_t k = 0; k < leaves_.size(); ++k) {
      const Leaf& leaf = leaves_[k];
      if (!leaf.state.is_whole() || leaf.state.leads_to_pole()) continue;
      which_[count_] = k;
      tolerance_[count_] = indicator_.allowed(leaf);
      take_leaf(leaf, indicator_, tree_, tolerance_[count_], count_, *block_);
      if (++count_ == kLeafBlock) estimate_block();
    }
    if (count_ > 0) estimate_block();
    return std::move(errors_);
  }

 private:
  void estimate_block() {
    estimate_loop(cpu_level())(*block_, count_, *block_errors_);
    for (std::size_t i = 0; i < count_; ++i) {
      if (block_errors_->is_plain[i] > 0) put_result(i);
    }
    count_ = 0;
  }

  void put_result(std::size_t i) {
    const Leaf& leaf = leaves_[which_[i]];
    FastCellError& fast = results_[which_[i]];
    const ErrorRatios distance = take(block_errors_->distance, i);
    const ErrorRatios turn = take(block_errors_->square_of_tangent, i);
    const double safety = leaf.normal_safety;
    const double allowed = safety == 1
                               ? allowed_turn_
                               : squared_tangent_of(limits_.normal_tolerance / std::sqrt(safety));
    const double worst = distance.worst() / tolerance_[i];
    if (worst * leaf.safety <= 1 && turn.worst() <= allowed) {
      fast.is_known = fast.passes = true;
      fast.distance = static_cast<float>(worst);
      return;
    }
    if (limits_.clip || has_limits(leaf.samples, tree_)) return;
    fast.is_known = true;
    fast.error = static_cast<std::uint32_t>(errors_.size());
    CellError& error = errors_.emplace_back();
    error.distance = in_tolerances(distance, tolerance_[i]);
    error.gap = error.distance;
    error.gap.centre = block_errors_->gap_at_centre[i] / tolerance_[i];
    error.turn = indicator_.turn_ratios(turn);
  }

  std::span<const Leaf> leaves_;
  const CellLimits& limits_;
  const ErrorIndicator& indicator_;
  const CellTree& tree_;
  std::span<FastCellError> results_;
  double allowed_turn_;
  std::vector<CellError> errors_;
  // The block and its leaves:
  std::unique_ptr<LeafSamples> block_ = std::make_unique_for_overwrite<LeafSamples>();
  std::unique_ptr<LeafErrors> block_errors_ = std::make_unique_for_overwrite<LeafErrors>();
  std::array<std::size_t, kLeafBlock> which_;
  LeafNumbers tolerance_;
  std::size_t count_ = 0;
};

}  // namespace

FastCellErrors estimate_many(std::span<const Leaf> leaves, const CellLimits& limits,
                             const ErrorIndicator& indicator, const CellTree& tree) {
  FastCellErrors result{std::vector<FastCellError>(leaves.size()), {}};
  const std::vector<std::vector<CellError>> errors = results_of_chunks(
      leaves.size(), kInBatch, limits.threads, [&](std::size_t begin, std::size_t end) {
        ChunkEstimate some(leaves.subspan(begin, end - begin), limits, indicator, tree,
                           std::span(result.leaves).subspan(begin, end - begin));
        return some.estimate();
      });
  for (std::size_t begin = 0; begin < leaves.size(); begin += kInBatch) {
    const auto before = static_cast<std::uint32_t>(result.errors.size());
    const auto some = std::span(result.leaves).subspan(begin);
    for (FastCellError& fast : some.first(std::min(kInBatch, some.size()))) fast.error += before;
    std::ranges::copy(errors[begin / kInBatch], std::back_inserter(result.errors));
  }
  return result;
}

void estimate_others(std::span<const Leaf> leaves, const CellLimits& limits,
                     const ErrorIndicator& indicator, const CellTree& tree,
                     FastCellErrors& errors) {
  using Other = std::pair<std::size_t, CellError>;
  const std::vector<Other> others = gather_in_chunks<Other>(
      leaves.size(), kInBatch, limits.threads, [&](std::size_t k, std::vector<Other>& some) {
        const Leaf& leaf = leaves[k];
        if (errors.leaves[k].is_known || count_defined(tree, leaf) < 9) return;
        if (!indicator.is_clipped(leaf)) some.emplace_back(k, indicator.estimate(leaf));
      });
  for (const auto& [k, error] : others) {
    errors.leaves[k].is_known = true;
    errors.leaves[k].error = static_cast<std::uint32_t>(errors.errors.size());
    errors.errors.push_back(error);
  }
}

}  // namespace saddle
