#include "mesh/judge_many.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "mesh/leaf_loops.h"
#include "mesh/vertex_columns.h"

namespace saddle {

namespace {

/// The square of the sine of an angle in degrees; from a right angle on, 1.
double square_of_sine(double degrees) {
  if (!(degrees < 90)) return 1;
  const double sine = std::sin(degrees * std::numbers::pi / 180);
  return sine * sine;
}

void take(const Mesh& mesh, std::uint32_t vertex, std::size_t i, LeafVertices& to) {
  put_vertex(mesh.position[vertex], mesh.normal[vertex], i, to);
}

class Gatherer {
 public:
  Gatherer(const RefineOptions& options, const Judge& judge, const Lattice& lattice)
      : options_(options),
        judge_(judge),
        lattice_(lattice),
        sine_(square_of_sine(options.normal_tolerance)) {}

  /// Takes a leaf in as the i-th; returns its tolerance.
  double take_leaf(const Leaf& leaf, std::size_t i, LeafSamples& to) const {
    const Samples& samples = leaf.samples;
    const Mesh& mesh = lattice_.mesh();
    for (std::size_t k = 0; k < 4; ++k) {
      take(mesh, samples.corner[k], i, to.corner[k]);
      take(mesh, samples.side[k], i, to.side[k]);
      to.counts[k][i] = lattice_.is_used(samples.side[k]) ? 0 : 1;
      to.seen[k][i] = judge_.is_seen(leaf, k) ? 1 : 0;
    }
    take(mesh, samples.centre, i, to.centre);
    const double eps = judge_.allowed(leaf);
    // Scores are to be 1 / strictness; that of an angle is its square.
    const double strictness = leaf.turn_strictness;
    to.largest_distance[i] = eps / leaf.strictness;
    to.largest_sine[i] =
        strictness == 1 ? sine_ : square_of_sine(options_.normal_tolerance / std::sqrt(strictness));
    to.seen_turn[i] = kSeenTurn * eps;
    return eps;
  }

 private:
  const RefineOptions& options_;
  const Judge& judge_;
  const Lattice& lattice_;
  double sine_;
};

}  // namespace

std::vector<float> judge_many(std::span<const Leaf> leaves, const RefineOptions& options,
                              const Judge& judge, const Lattice& lattice) {
  std::vector<float> result(leaves.size(), kUnknown);
  const auto block = std::make_unique_for_overwrite<LeafSamples>();
  const auto verdicts = std::make_unique_for_overwrite<LeafVerdicts>();
  const JudgeLeaves loop = judge_loop(cpu_level());
  const Gatherer gatherer(options, judge, lattice);
  std::array<std::size_t, kLeafBlock> which;
  LeafNumbers tolerance;
  std::size_t count = 0;
  const auto flush = [&] {
    loop(*block, count, *verdicts);
    for (std::size_t i = 0; i < count; ++i) {
      if (verdicts->passes[i] > 0)
        result[which[i]] = static_cast<float>(verdicts->distance[i] / tolerance[i]);
    }
    count = 0;
  };
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const Leaf& leaf = leaves[k];
    if (leaf.on_rim || leaf.is_split || leaf.leads_to_pole) continue;
    which[count] = k;
    tolerance[count] = gatherer.take_leaf(leaf, count, *block);
    if (++count == kLeafBlock) flush();
  }
  if (count > 0) flush();
  return result;
}

}  // namespace saddle
