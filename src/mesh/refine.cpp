#include "mesh/refine.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "mesh/clip.h"
#include "mesh/crossings.h"
#include "mesh/triangulate.h"

namespace saddle {

namespace {

/// A chord's sample that is farther away than this part of the chord is no small arc: its distance
/// along the normal says nothing.
constexpr double kSmallArc = 0.3;
/// Corner normals of a leaf spread by at most this, degrees: samples between them are then enough.
constexpr double kMaxSpread = 40;
/// A score falls to a quarter when a smooth arc is halved, to half at a kink, to 0.71 at a vertical
/// tangent; where it stays above this share, so many times in a row, halving is in vain.
constexpr double kHelps = 0.8;
constexpr std::uint8_t kMaxInVain = 14;
/// The same for normals, which do not settle at points where sheets meet.
constexpr std::uint8_t kMaxTurnedInVain = 14;
/// After every so many halvings in vain, of distances and of normals, a leaf's sides are looked at
/// for jumps and creases. A leaf halved the wrong way once is no better for it, either.
constexpr std::uint8_t kLookAfter = 3;
constexpr std::uint8_t kLookAfterTurned = 2;
/// Halvings of a root cell that the rim crosses, to begin with, and of one in which a cut is more
/// than one line, at most.
constexpr int kRimHalvings = 4;
constexpr int kMostCutHalvings = 14;

/// How bad a leaf is along u, along v and at its centre; 1 is just good enough. Errors fall with
/// the square of a leaf's size and angles with the size itself: the square of an angle's share is
/// comparable.
struct Scores {
  double along_u = 0;
  double along_v = 0;
  double centre = 0;
  double worst() const { return std::max({along_u, along_v, centre}); }
};

/// The scores of distances and of normals.
struct Verdict {
  Scores distance;
  Scores turn;
  bool is_folded = false;  ///< the normals at two corners face opposite ways
};

Scores worse(const Scores& a, const Scores& b) {
  return {std::max(a.along_u, b.along_u), std::max(a.along_v, b.along_v),
          std::max(a.centre, b.centre)};
}

class Judge {
 public:
  Judge(const RefineOptions& options, const Grid& grid, const Lattice& lattice)
      : options_(options), grid_(grid), mesh_(grid.mesh), lattice_(lattice) {}

  /// `corner`: vertices of the leaf's corners; `side`: of the middles of its sides, the k-th
  /// between corners k and k + 1; `centre`: of its middle.
  Verdict score(const Leaf& leaf, const std::array<std::uint32_t, 4>& corner,
                const std::array<std::uint32_t, 4>& side, std::uint32_t centre) const {
    const double eps = options_.tolerance(mesh_.position[centre]);
    const bool normals_count = diameter(corner) > kVisible * eps;
    Verdict verdict;
    const auto judge = [&](std::uint32_t a, std::uint32_t b, std::uint32_t sample, bool border,
                           double Scores::*part) {
      const double distance = distance_of_sample(a, b, sample, border) / eps;
      verdict.distance.*part = std::max(verdict.distance.*part, distance);
      if (!normals_count) return;
      verdict.turn.*part = std::max(verdict.turn.*part, normal_score(a, b, sample));
    };
    for (std::size_t k = 0; k < 4; ++k) {
      if (lattice_.is_used(side[k])) continue;  // the side is no edge of the mesh: its halves are
      judge(corner[k], corner[(k + 1) % 4], side[k], is_on_border(leaf, k),
            k % 2 == 0 ? &Scores::along_u : &Scores::along_v);
    }
    const std::size_t first = cut_from(corner);
    judge(corner[first], corner[first + 2], centre, false, &Scores::centre);
    verdict.is_folded = normals_count && has_opposed(corner);
    if (normals_count && spread(corner) > kMaxSpread) {
      const double u = turn(corner[0], corner[1]) + turn(corner[3], corner[2]);
      const double v = turn(corner[0], corner[3]) + turn(corner[1], corner[2]);
      double& along = u >= v ? verdict.turn.along_u : verdict.turn.along_v;
      along = std::max(along, 2.0);
    }
    return verdict;
  }

  /// Which way to halve a leaf that failed.
  bool splits_u(const Scores& scores, const std::array<std::uint32_t, 4>& corner) const {
    // A twisted leaf has straight sides; its longer ones are halved.
    constexpr double kStraight = 0.1;
    if (std::max(scores.along_u, scores.along_v) > kStraight * scores.centre) {
      return scores.along_u >= scores.along_v;
    }
    const auto length = [&](std::size_t a, std::size_t b) {
      return glm::distance(mesh_.position[corner[a]], mesh_.position[corner[b]]);
    };
    return length(0, 1) + length(3, 2) >= length(0, 3) + length(1, 2);
  }

 private:
  double diameter(const std::array<std::uint32_t, 4>& corner) const {
    const auto& p = mesh_.position;
    return std::max(glm::distance(p[corner[0]], p[corner[2]]),
                    glm::distance(p[corner[1]], p[corner[3]]));
  }

  bool is_on_border(const Leaf& leaf, std::size_t side) const {
    switch (side) {
      case 0:
        return leaf.low.v == 0;
      case 1:
        return leaf.high.u == grid_.cells_u * kCellUnit;
      case 2:
        return leaf.high.v == grid_.cells_v * kCellUnit;
      default:
        return leaf.low.u == 0;
    }
  }

  bool is_regular(std::uint32_t vertex) const { return lattice_.is_regular(vertex); }

  double turn(std::uint32_t a, std::uint32_t b) const {
    if (!is_regular(a) || !is_regular(b)) return 0;
    return turn_of_line(degrees_between(mesh_.normal[a], mesh_.normal[b]));
  }

  bool has_opposed(const std::array<std::uint32_t, 4>& corner) const {
    const auto& n = mesh_.normal;
    // The products with a normal of no direction, which is zero, are not negative.
    for (std::size_t k = 1; k < 4; ++k) {
      if (glm::dot(n[corner[0]], n[corner[k]]) < 0) return true;
    }
    return glm::dot(n[corner[1]], n[corner[3]]) < 0;
  }

  double spread(const std::array<std::uint32_t, 4>& corner) const {
    double largest = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a + 1; b < 4; ++b)
        largest = std::max(largest, turn(corner[a], corner[b]));
    }
    return largest;
  }

  /// The distance of a sample from the chord of a and b, which would be an edge of the mesh: along
  /// the normal, since the triangles go on beside the edge; at the domain's border in any
  /// direction.
  double distance_of_sample(std::uint32_t a, std::uint32_t b, std::uint32_t sample,
                            bool border) const {
    const dvec3 chord = mesh_.position[b] - mesh_.position[a];
    const dvec3 off = mesh_.position[sample] - 0.5 * (mesh_.position[a] + mesh_.position[b]);
    const double length = glm::length(chord);
    if (!(glm::length(off) <= kSmallArc * length)) return glm::length(off);
    if (!border && is_regular(sample)) return std::fabs(glm::dot(off, mesh_.normal[sample]));
    const dvec3 along = length > 0 ? chord / length : dvec3(0);
    return glm::length(off - glm::dot(off, along) * along);
  }

  /// The corner that the diagonal starts from along which the cell would be cut: 0 or 1.
  std::size_t cut_from(const std::array<std::uint32_t, 4>& corner) const {
    const auto arc = [&](std::size_t a, std::size_t b) {
      return sagitta(mesh_.position[corner[a]], mesh_.normal[corner[a]], mesh_.position[corner[b]],
                     mesh_.normal[corner[b]]);
    };
    return is_smaller(arc(1, 3), arc(0, 2)) ? 1 : 0;
  }

  double normal_score(std::uint32_t a, std::uint32_t b, std::uint32_t sample) const {
    if (!is_regular(a) || !is_regular(b) || !is_regular(sample)) return 0;
    const dvec3 sum = mesh_.normal[a] + mesh_.normal[b];
    const double share =
        turn_of_line(degrees_between(sum, mesh_.normal[sample])) / options_.normal_tolerance;
    return share * share;
  }

  const RefineOptions& options_;
  const Grid& grid_;
  const Mesh& mesh_;
  const Lattice& lattice_;
};

/// A leaf and the vertices that it is judged by.
struct Samples {
  std::array<std::uint32_t, 4> corner;
  std::array<std::uint32_t, 4> side;
  std::uint32_t centre;
};

Samples request_samples(const Leaf& leaf, Lattice& lattice) {
  const LatticePlace m = leaf.middle();
  const auto& [low, high] = std::pair(leaf.low, leaf.high);
  Samples samples;
  const auto corners = leaf.corners();
  for (std::size_t k = 0; k < 4; ++k) samples.corner[k] = lattice.vertex(corners[k]);
  samples.side = {lattice.vertex({m.u, low.v}), lattice.vertex({high.u, m.v}),
                  lattice.vertex({m.u, high.v}), lattice.vertex({low.u, m.v})};
  samples.centre = lattice.vertex(m);
  return samples;
}

/// How many of the nine samples are defined.
int count_defined(const Lattice& lattice, const Samples& samples) {
  int count = lattice.is_defined(samples.centre) ? 1 : 0;
  for (std::size_t k = 0; k < 4; ++k) {
    count += lattice.is_defined(samples.corner[k]) ? 1 : 0;
    count += lattice.is_defined(samples.side[k]) ? 1 : 0;
  }
  return count;
}

/// Halvings of a root cell that the leaf came from.
int halvings(const Leaf& leaf) {
  return std::countr_zero(kCellUnit / leaf.size_u()) + std::countr_zero(kCellUnit / leaf.size_v());
}

/// A leaf that is still to be judged, and how bad the one was that it is a half of.
struct Candidate {
  Leaf leaf;
  double parent_distance;
  double parent_turn;
};

std::uint8_t count_in_vain(std::uint8_t before, double score, double parent_score) {
  return score <= std::max(kHelps * parent_score, 1.0) ? std::uint8_t{0}
                                                       : static_cast<std::uint8_t>(before + 1);
}

/// A candidate that was judged.
struct Judged {
  Candidate candidate;
  Samples samples;
  Verdict verdict;
};

class Refiner {
 public:
  Refiner(const RefineOptions& options, const Grid& grid, Lattice& lattice)
      : options_(options), grid_(grid), lattice_(lattice), judge_(options, grid, lattice) {}

  /// Judges a generation, and puts the next one in its place.
  void advance(std::vector<Candidate>& candidates) {
    std::vector<Samples> samples;
    samples.reserve(candidates.size());
    for (const Candidate& c : candidates) samples.push_back(request_samples(c.leaf, lattice_));
    lattice_.evaluate(options_.threads);
    next_.clear();
    std::vector<Judged> doubtful;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const int defined = count_defined(lattice_, samples[k]);
      if (defined == 0) continue;  // what is defined nowhere is no part of the mesh
      if (defined < 9) {
        judge_rim(candidates[k]);
        continue;
      }
      Judged judged = judge(candidates[k], samples[k]);
      if (judged.verdict.is_folded || is_doubtful(judged.candidate.leaf)) {
        doubtful.push_back(judged);
      } else {
        settle(judged);
      }
    }
    look_for_cuts(doubtful);
    std::swap(candidates, next_);
  }

  Refinement take() { return std::move(result_); }

 private:
  /// Whether nothing of a leaf will be left.
  bool is_clipped(const Samples& samples) const {
    if (!options_.clip) return false;
    std::array<dvec3, 9> positions;
    for (std::size_t k = 0; k < 4; ++k) {
      positions[k] = grid_.mesh.position[samples.corner[k]];
      positions[4 + k] = grid_.mesh.position[samples.side[k]];
    }
    positions[8] = grid_.mesh.position[samples.centre];
    return is_beyond(*options_.clip, positions);
  }

  /// Halves a leaf that is cut until the cut is nearly straight in it; what remains to be done
  /// fresh samples tell. The halves do not know yet what cuts them.
  void judge_cut(const Candidate& candidate, Leaf leaf, int wanted_halvings) {
    const bool full = lattice_.is_full(options_.max_triangles);
    const int done = halvings(leaf);
    const auto halves = done < wanted_halvings && !full
                            ? halve(leaf, leaf.size_u() >= leaf.size_v(), lattice_)
                            : std::nullopt;
    if (!halves) {
      leaf.given_up = done >= kMostCutHalvings || full;
      result_.leaves.push_back(leaf);
      return;
    }
    for (Leaf half : *halves) {
      half.on_rim = false;
      next_.push_back({half, candidate.parent_distance, candidate.parent_turn});
    }
  }

  void judge_rim(const Candidate& candidate) {
    Leaf leaf = candidate.leaf;
    leaf.on_rim = true;
    judge_cut(candidate, leaf, kRimHalvings);
  }

  /// Whether a leaf's sides are to be looked at.
  static bool is_doubtful(const Leaf& leaf) {
    const auto is_due = [](std::uint8_t in_vain, std::uint8_t period) {
      return in_vain > 0 && in_vain % period == 0;
    };
    return leaf.is_split || is_due(leaf.in_vain, kLookAfter) ||
           is_due(leaf.turned_in_vain, kLookAfterTurned);
  }

  void look_for_cuts(std::span<Judged> doubtful) {
    std::vector<Side> sides;
    for (const Judged& judged : doubtful) {
      const std::vector<Side> more = unsearched_sides(judged.candidate.leaf, lattice_);
      sides.insert(sides.end(), more.begin(), more.end());
    }
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    find_crossings(sides, {options_.tolerance, false, options_.threads}, lattice_);
    std::vector<bool> is_through(doubtful.size());  // before halves put new vertices on the sides
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      Leaf& leaf = doubtful[k].candidate.leaf;
      const CutCount cuts = count_cuts(leaf, lattice_);
      is_through[k] = cuts.is_through();
      leaf.is_split = cuts.crossings > 0 || (doubtful[k].verdict.is_folded && is_through[k]);
    }
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      const auto& [candidate, samples, verdict] = doubtful[k];
      if (candidate.leaf.is_split) {
        judge_cut(candidate, candidate.leaf, is_through[k] ? 0 : kMostCutHalvings);
      } else {
        settle(doubtful[k]);
      }
    }
  }

  /// What the samples say of a leaf.
  Judged judge(const Candidate& candidate, const Samples& samples) const {
    Judged judged{candidate, samples, {}};
    if (is_clipped(samples)) return judged;
    Leaf& leaf = judged.candidate.leaf;
    judged.verdict = judge_.score(leaf, samples.corner, samples.side, samples.centre);
    const double distance = judged.verdict.distance.worst() * leaf.strictness;
    const double turn = judged.verdict.turn.worst() * leaf.strictness;
    leaf.in_vain = count_in_vain(leaf.in_vain, distance, candidate.parent_distance);
    leaf.turned_in_vain = count_in_vain(leaf.turned_in_vain, turn, candidate.parent_turn);
    return judged;
  }

  /// Keeps a leaf, or goes on with its halves.
  void settle(const Judged& judged) {
    Leaf leaf = judged.candidate.leaf;
    const Verdict& verdict = judged.verdict;
    const double distance = verdict.distance.worst() * leaf.strictness;
    const double turn = verdict.turn.worst() * leaf.strictness;
    const bool is_far = distance > 1 && leaf.in_vain <= kMaxInVain;
    const bool is_turned = turn > 1 && leaf.turned_in_vain <= kMaxTurnedInVain;
    std::optional<std::array<Leaf, 2>> halves;
    if (is_far || is_turned) {
      const bool full = lattice_.is_full(options_.max_triangles);
      result_.reached_limit = result_.reached_limit || full;
      const Scores scores = !is_turned ? verdict.distance
                            : !is_far  ? verdict.turn
                                       : worse(verdict.distance, verdict.turn);
      if (!full) halves = halve(leaf, judge_.splits_u(scores, judged.samples.corner), lattice_);
    }
    if (!halves) {
      leaf.given_up = distance > 1 || turn > 1;
      leaf.known_error = static_cast<float>(verdict.distance.worst());
      result_.leaves.push_back(leaf);
      return;
    }
    for (const Leaf& half : *halves) next_.push_back({half, distance, turn});
  }

  const RefineOptions& options_;
  const Grid& grid_;
  Lattice& lattice_;
  Judge judge_;
  std::vector<Candidate> next_;
  Refinement result_;
};

}  // namespace

std::vector<Leaf> root_leaves(const Grid& grid) {
  std::vector<Leaf> leaves;
  leaves.reserve(grid.cell_count());
  for (std::uint32_t j = 0; j < grid.cells_v; ++j) {
    for (std::uint32_t i = 0; i < grid.cells_u; ++i) {
      leaves.push_back(
          {{i * kCellUnit, j * kCellUnit}, {(i + 1) * kCellUnit, (j + 1) * kCellUnit}});
    }
  }
  return leaves;
}

std::optional<std::array<Leaf, 2>> halve(const Leaf& leaf, bool across_u, Lattice& lattice) {
  if ((across_u ? leaf.size_u() : leaf.size_v()) < 2) return std::nullopt;
  const LatticePlace middle = leaf.middle();
  std::array<Leaf, 2> halves = {leaf, leaf};
  if (across_u) {
    halves[0].high.u = halves[1].low.u = middle.u;
    lattice.use(lattice.vertex({middle.u, leaf.low.v}));
    lattice.use(lattice.vertex({middle.u, leaf.high.v}));
  } else {
    halves[0].high.v = halves[1].low.v = middle.v;
    lattice.use(lattice.vertex({leaf.low.u, middle.v}));
    lattice.use(lattice.vertex({leaf.high.u, middle.v}));
  }
  return halves;
}

Refinement refine(std::span<const Leaf> active, const RefineOptions& options, const Grid& grid,
                  Lattice& lattice) {
  Refiner refiner(options, grid, lattice);
  std::vector<Candidate> candidates;
  candidates.reserve(active.size());
  for (const Leaf& leaf : active) {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    candidates.push_back({leaf, kUnknown, kUnknown});
  }
  while (!candidates.empty()) refiner.advance(candidates);
  return refiner.take();
}

}  // namespace saddle
