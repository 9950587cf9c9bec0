#include "mesh/error/judge_many.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "mesh/error/leaf_loops.h"
#include "mesh/grid/vertex_columns.h"

namespace saddle {

namespace {

void take(const Mesh& mesh, std::uint32_t vertex, std::size_t i, LeafVertices& to) {
  put_vertex(mesh.position[vertex], mesh.normal[vertex], i, to);
}

/// Takes a leaf in as the i-th.
void take_leaf(const Leaf& leaf, const Judge& judge, const Lattice& lattice, double eps,
               std::size_t i, LeafSamples& to) {
  const SampleVertices& samples = leaf.samples;
  const Mesh& mesh = lattice.mesh();
  for (std::size_t k = 0; k < 4; ++k) {
    take(mesh, samples.corner[k], i, to.corner[k]);
    take(mesh, samples.side[k], i, to.side[k]);
    to.counts[k][i] = lattice.is_used(samples.side[k]) ? 0 : 1;
    to.seen[k][i] = judge.is_seen(leaf, k) ? 1 : 0;
  }
  take(mesh, samples.centre, i, to.centre);
  to.seen_turn[i] = kSeenTurn * eps;
}

/// Whether normals of samples are limits, which say nothing of the leaf.
bool has_limits(const SampleVertices& samples, const Lattice& lattice) {
  const auto is_limit = [&](std::uint32_t vertex) { return !lattice.is_regular(vertex); };
  return is_limit(samples.centre) || std::ranges::any_of(samples.corner, is_limit) ||
         std::ranges::any_of(samples.side, is_limit);
}

Scores take(const LeafScores& scores, std::size_t i) {
  return {scores.along_u[i], scores.along_v[i], scores.centre[i]};
}

Scores in_tolerances(const Scores& distances, double tolerance) {
  return {distances.along_u / tolerance, distances.along_v / tolerance,
          distances.centre / tolerance};
}

/// The square of a tangent whose angle has the score 1.
double square_of_tangent(double degrees) {
  if (!(degrees < 90)) return std::numeric_limits<double>::infinity();
  const double tangent = std::tan(degrees * std::numbers::pi / 180);
  return tangent * tangent;
}

}  // namespace

Glances judge_many(std::span<const Leaf> leaves, const RefineOptions& options, const Judge& judge,
                   const Lattice& lattice) {
  Glances result{std::vector<Glance>(leaves.size()), {}};
  const auto block = std::make_unique_for_overwrite<LeafSamples>();
  const auto verdicts = std::make_unique_for_overwrite<LeafVerdicts>();
  const JudgeLeaves loop = judge_loop(cpu_level());
  const double allowed_turn = square_of_tangent(options.normal_tolerance);
  std::array<std::size_t, kLeafBlock> which;
  LeafNumbers tolerance;
  std::size_t count = 0;
  const auto file = [&](std::size_t i) {
    const Leaf& leaf = leaves[which[i]];
    Glance& glance = result.leaves[which[i]];
    const Scores distance = take(verdicts->distance, i);
    const Scores turn = take(verdicts->square_of_tangent, i);
    const double strictness = leaf.turn_strictness;
    const double allowed =
        strictness == 1 ? allowed_turn
                        : square_of_tangent(options.normal_tolerance / std::sqrt(strictness));
    const double worst = distance.worst() / tolerance[i];
    if (worst * leaf.strictness <= 1 && turn.worst() <= allowed) {
      glance.is_known = glance.passes = true;
      glance.distance = static_cast<float>(worst);
      return;
    }
    if (options.clip || has_limits(leaf.samples, lattice)) return;
    glance.is_known = true;
    glance.verdict = static_cast<std::uint32_t>(result.verdicts.size());
    Verdict& verdict = result.verdicts.emplace_back();
    verdict.distance = in_tolerances(distance, tolerance[i]);
    verdict.gap = verdict.distance;
    verdict.gap.centre = verdicts->gap_at_centre[i] / tolerance[i];
    verdict.turn = judge.turn_scores(turn);
  };
  const auto flush = [&] {
    loop(*block, count, *verdicts);
    for (std::size_t i = 0; i < count; ++i) {
      if (verdicts->is_plain[i] > 0) file(i);
    }
    count = 0;
  };
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const Leaf& leaf = leaves[k];
    if (leaf.on_rim || leaf.is_split || leaf.leads_to_pole) continue;
    which[count] = k;
    tolerance[count] = judge.allowed(leaf);
    take_leaf(leaf, judge, lattice, tolerance[count], count, *block);
    if (++count == kLeafBlock) flush();
  }
  if (count > 0) flush();
  return result;
}

}  // namespace saddle
