#include "mesh/error/validate_in_chunks.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "base/parallel.h"
#include "mesh/error/face_distance.h"
#include "mesh/error/validator.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"

namespace saddle {

namespace {

/// Leaves that one thread validates at a time: few enough for several threads, and no fewer than
/// make a loop of the evaluator worth its start.
std::size_t chunk_of(std::size_t leaves) {
  return std::clamp(leaves / 8, kInBatch / 4, kInBatch);
}

}  // namespace

ValidationCost validate_in_chunks(const Surface& surface, const Grid& grid, const CellTree& tree,
                                  const CellLimits& limits, const LeavesToValidate& leaves,
                                  ValidatedMesh& mesh) {
  const std::span<const std::size_t> which = leaves.which;
  const LeafTriangles& triangles = leaves.triangles;
  mesh.sampled_errors.resize(mesh.leaves.size());
  parallel_chunks(which.size(), kInBatch, limits.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Leaf& leaf = mesh.leaves[which[k]];
      const std::size_t count =
          triangles.ranges[k].is_plain ? 4 : count_polygon_vertices(leaf, tree);
      leaf.polygon_size = static_cast<std::uint16_t>(
          std::min<std::size_t>(count, std::numeric_limits<std::uint16_t>::max()));
    }
  });
  std::atomic<std::size_t> evaluations = 0;
  std::atomic<std::size_t> looks = 0;
  const std::size_t chunk = chunk_of(which.size());
  // Whether work is left is not asked within chunks: how far the others are by then depends on the
  // machine.
  const std::size_t between_checks = 32 * chunk;
  for (std::size_t from = 0; from < which.size() && surface.may_go_on(); from += between_checks) {
    const auto some = which.subspan(from, std::min(between_checks, which.size() - from));
    parallel_chunks(some.size(), chunk, limits.threads, [&](std::size_t begin, std::size_t end) {
      Validator validator(surface, grid, tree, limits);
      validator.measure(mesh, some.subspan(begin, end - begin),
                        {triangles, from + begin, end - begin});
      evaluations += validator.evaluations();
      looks += validator.looks();
    });
  }
  ValidationCost cost{evaluations, looks};
  if (!limits.clip || !surface.may_go_on()) return cost;
  FaceDistance faces(surface, grid, *limits.clip, limits.threads);
  for (std::size_t k = 0; k < which.size(); ++k) {
    const auto of_leaf = triangles.of(k);
    const LeafState& state = mesh.leaves[which[k]].state;
    const bool may_be_off = state.may_be_halved() && mesh.is_near(which[k]);
    if (may_be_off && reach_outside(limits.clip, grid.mesh, of_leaf))
      faces.add(which[k], state.is_cut_by_feature(), of_leaf);
  }
  faces.measure(mesh, which, triangles);
  cost.evaluations += faces.evaluations();
  return cost;
}

}  // namespace saddle
