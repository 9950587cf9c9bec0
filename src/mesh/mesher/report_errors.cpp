#include "mesh/mesher/report_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/random.h"
#include "mesh/distance/boundary_distance.h"
#include "mesh/distance/whole_mesh_error.h"
#include "mesh/error/largest_error.h"
#include "mesh/error/open_leaves.h"
#include "mesh/error/validation_points.h"
#include "mesh/mesher/adaptive_mesher.h"
#include "mesh/mesher/envelope.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/feature_search.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// One leaf in 16 is a small part of all. As many of the largest leaves, but kInBatch at least, are
/// searched for what samples miss; a grid of given cells is searched everywhere: nothing else chose
/// them. Oscillating leaves are waves if they are more; fewer are parts of a ridge.
constexpr std::size_t kFewOfAll = 16;

class ErrorReporter {
 public:
  ErrorReporter(const AdaptiveMesher& mesher, const MeshReport& report)
      : mesher_(mesher),
        mesh_(mesher.mesh()),
        tree_(mesher.tree()),
        grid_(mesher.grid()),
        waves_(static_cast<std::size_t>(std::ranges::count_if(
            mesher.mesh().leaves, [](const Leaf& leaf) { return leaf.state.oscillates(); }))),
        has_waves_(kFewOfAll * waves_ > mesher.mesh().leaves.size()),
        tolerance_(mesher.coarser() * *report.tolerance),
        strictest_(report.rounding ? std::numeric_limits<double>::infinity() : tolerance_) {}

  /// The largest errors of the triangles. Errors above the tolerance that the mesh was made for are
  /// searched for again, against the whole mesh.
  void report(const Surface& surface, const MeshRequest& request, const LeafTriangles& triangles,
              MeshReport& report) const {
    PlacedError worst;
    PlacedError beside_jumps;
    std::vector<SuspectLeaf> suspects;
    for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
      const Leaf& leaf = mesh_.leaves[k];
      // On the way to a pole that no search found, the surface may cross the box between vertices.
      const bool is_clipped = mesher_.is_clipped(leaf);
      if (is_clipped && (mesh_.is_near(k) || !leaf.state.is_whole())) continue;
      const bool is_missing = triangles.of(k).empty();
      if (is_missing && !is_missing_part(k)) continue;
      const PlacedError error = error_of(k);
      const bool is_far = error.distance > tolerance_;
      // A leaf that is above what it aims at, but too small to halve, may hold more.
      const bool has_moved = may_reach_extremes(leaf);
      const bool is_suspect = is_far || !mesh_.is_near(k) || has_moved;
      if (is_suspect && (is_missing || may_be_near(k, request.clip.has_value()))) {
        suspects.push_back({k, error.distance, has_moved});
        if (is_beside_jump(k)) take_larger(error, beside_jumps);
      } else if (is_missing || is_clipped) {
        continue;
      } else {
        take_larger(error, worst);
      }
      take_degrees(k, report);
    }
    std::vector<PlaceInLeaf> at_edges;
    const PlacedError beside = find_at_edges(surface, request, suspects, triangles, at_edges);
    take_larger(beside, worst);
    const PlacedError found = search(surface, request, suspects, at_edges, triangles);
    take_larger(found, worst);
    // Without work for the search, places of the mesh were not looked at.
    if (!surface.may_go_on()) take_larger(beside_jumps, worst);
    report.max_error = worst.distance;
    if (worst.distance > *report.tolerance) report.worst_place = worst.uv;
  }

 private:
  static void take_larger(const PlacedError& error, PlacedError& worst) {
    if (error.distance > worst.distance) worst = error;
  }

  void take_degrees(std::size_t k, MeshReport& report) const {
    const double degrees = mesh_.sampled_errors[k].degrees;
    if (degrees > report.max_normal_error &&
        thickness_of(mesh_.leaves[k], grid_, tree_) > kSeenTurn * mesh_.allowed[k])
      report.max_normal_error = degrees;
  }

  /// A tolerance that varies: errors are scaled to the strictest one.
  double scale_of(std::size_t k) const {
    return mesh_.allowed[k] > strictest_ ? strictest_ / mesh_.allowed[k] : 1;
  }

  /// The error of a leaf by its samples, scaled.
  PlacedError error_of(std::size_t k) const {
    const Leaf& leaf = mesh_.leaves[k];
    const SampledError& sampled = mesh_.sampled_errors[k];
    // The samples of a leaf that crosses the clip box may be outside of it.
    const double known = mesher_.crosses_box(leaf) ? 0 : leaf.known_error * mesh_.allowed[k];
    const double error = scale_of(k) * std::max(sampled.distance, known);
    const dvec2 middle = tree_.vertices().parameters(leaf.middle());
    return {error, sampled.distance >= known ? mesh_.error_place(k).value_or(middle) : middle};
  }

  /// Whether the error of a leaf is that of a place of the surface.
  bool is_of_surface(std::size_t k) const {
    const Leaf& leaf = mesh_.leaves[k];
    return mesh_.error_place(k) && !leaf.state.is_on_boundary() && !leaf.state.oscillates() &&
           !mesher_.landmarks().misses_hole(leaf);
  }

  /// Whether the error of a leaf is that of a place of the mesh beside a jump. Where more jumps
  /// cross the leaf than the mesh has, others may be nearer to it.
  bool is_beside_jump(std::size_t k) const {
    const Leaf& leaf = mesh_.leaves[k];
    return scale_of(k) == 1 && !mesh_.error_place(k) && !leaf.state.is_on_boundary() &&
           !is_beyond_search(leaf) && has_cut(FeatureKind::Jump, leaf, tree_);
  }

  /// Whether a leaf is part of waves.
  bool is_wave(const Leaf& leaf) const { return leaf.state.oscillates() && has_waves_; }

  /// Whether a leaf is part of waves, which no search follows, or covers a hole, whose error no
  /// other triangles reduce.
  bool is_beyond_search(const Leaf& leaf) const {
    return is_wave(leaf) || mesher_.landmarks().misses_hole(leaf);
  }

  /// Whether the surface over a leaf is defined and continuous.
  bool is_covered(const Leaf& leaf) const {
    if (leaf.state.is_on_boundary() || is_beyond_search(leaf)) return false;
    return leaf.state.is_whole() || count_features(leaf, tree_).is_continuous;
  }

  /// Whether a leaf without triangles, on a boundary, has a place of the surface.
  bool is_missing_part(std::size_t k) const {
    const Leaf& leaf = mesh_.leaves[k];
    return mesh_.error_place(k) && leaf.state.is_on_boundary() && !leaf.state.is_left_out();
  }

  /// Whether a place far from its leaf's triangles may be near others, or outside of the clip box.
  bool may_be_near(std::size_t k, bool has_clip_box) const {
    const Leaf& leaf = mesh_.leaves[k];
    const bool is_beside_box = leaf.state.leads_to_pole() || mesher_.crosses_box(leaf);
    return is_covered(leaf) || is_of_surface(k) || has_edge(leaf) || is_wave(leaf) ||
           is_beside_jump(k) || (has_clip_box && is_beside_box);
  }

  /// Whether the surface ends in a leaf: other leaves' triangles may be nearer to it than its own.
  bool has_edge(const Leaf& leaf) const {
    return leaf.state.is_on_boundary() && !is_beyond_search(leaf) &&
           !has_cut(FeatureKind::Jump, leaf, tree_) && !mesher_.crosses_box(leaf);
  }

  /// A place of a leaf, by the leaf's number.
  struct PlaceInLeaf {
    std::size_t leaf;
    dvec2 uv;
  };

  /// Appends the places of the surface that are far off beside its edges, leaf by leaf. Returns the
  /// largest error at the edges of the mesh, which its other triangles do not reduce.
  PlacedError find_at_edges(const Surface& surface, const MeshRequest& request,
                            std::span<const SuspectLeaf> suspects, const LeafTriangles& triangles,
                            std::vector<PlaceInLeaf>& places) const {
    BoundaryDistance edges(surface, grid_, tree_, request.clip, request.threads);
    for (const SuspectLeaf& suspect : suspects) {
      const Leaf& leaf = mesh_.leaves[suspect.leaf];
      if (has_edge(leaf))
        edges.add(leaf, suspect.leaf, triangles.of(suspect.leaf), mesh_.allowed[suspect.leaf]);
    }
    PlacedError worst;
    for (const auto& found : edges.measure()) {
      const double error = scale_of(found.leaf) * found.distance;
      if (found.uv) {
        places.push_back({found.leaf, *found.uv});
      } else if (error > worst.distance) {
        worst = {error, searched(found.leaf, triangles).box.middle()};
      }
    }
    std::ranges::stable_sort(places, {}, &PlaceInLeaf::leaf);
    return worst;
  }

  /// The largest error of suspects; of all of a mesh that is off in leaves which are not clipped.
  PlacedError search(const Surface& surface, const MeshRequest& request,
                     std::span<SuspectLeaf> suspects, std::span<const PlaceInLeaf> at_edges,
                     const LeafTriangles& triangles) const {
    const bool is_off = std::ranges::any_of(suspects, [this](const SuspectLeaf& suspect) {
      return suspect.error > tolerance_ && !mesher_.is_clipped(mesh_.leaves[suspect.leaf]);
    });
    std::vector<SearchedPart> others;
    const bool is_sampled = request.samples.has_value();
    std::vector<std::size_t> leaves = searchable_leaves(triangles);
    if (!is_sampled) keep_largest(leaves);
    for (const std::size_t k : leaves) {
      if (is_sampled || is_off || triangles.of(k).empty()) others.push_back(searched(k, triangles));
    }
    std::optional<WholeMeshError> whole;
    const auto measured = [&]() -> const WholeMeshError& {
      return whole.emplace(surface, grid_, triangles.all, request.clip, request.threads,
                           tree_.edges().has_cliffs());
    };
    const auto part = [&](std::size_t leaf) { return searched(leaf, triangles); };
    const auto places = [&](std::size_t leaf) {
      std::vector<dvec2> result;
      append_places(surface.domain, leaf, triangles.of(leaf).empty(), result);
      auto at = std::ranges::lower_bound(at_edges, leaf, {}, &PlaceInLeaf::leaf);
      for (; at != at_edges.end() && at->leaf == leaf; ++at) result.push_back(at->uv);
      return result;
    };
    return largest_error(surface, suspects, others, mesher_.hulls(),
                         {tolerance_, request.clip, share_of_search(request), request.threads, part,
                          places, measured});
  }

  /// Where waves fill an area, samples alone show that the mesh is off by about their height.
  double share_of_search(const MeshRequest& request) const {
    const double share = share_of_searches(request.least_effort);
    return has_waves_ ? share / static_cast<double>(kFewOfAll) : share;
  }

  SearchedPart searched(std::size_t k, const LeafTriangles& triangles) const {
    SearchedPart part = part_of(mesh_, k, triangles.of(k), grid_, tree_);
    for (const dvec3& p : corner_positions(mesh_.leaves[k], tree_)) part.around.add(p);
    part.scale = scale_of(k);
    return part;
  }

  /// Appends places of a leaf at which its error, or a larger one, may be.
  void append_places(const Domain& domain, std::size_t k, bool is_missing,
                     std::vector<dvec2>& places) const {
    if (is_wave(mesh_.leaves[k])) return append_in_waves(k, places);
    append_samples(k, places);
    if (is_missing) append_around(domain, places);
  }

  /// Appends random places of a leaf in waves, every other one on a side of it: errors are largest
  /// at the edge of the domain, where no triangles lie beyond.
  void append_in_waves(std::size_t k, std::vector<dvec2>& places) const {
    places.push_back(error_of(k).uv);
    const dvec2 low = tree_.vertices().parameters(mesh_.leaves[k].low);
    const dvec2 high = tree_.vertices().parameters(mesh_.leaves[k].high());
    // All together at most half as many as vertices have tried, or one.
    const std::size_t tries = tries_in_waves(2 * waves_, 1);
    for (std::size_t i = 0; i < tries; ++i) {
      const std::uint64_t key = k * tries + i;
      dvec2 part(random_unit(2 * key), random_unit(2 * key + 1));
      const int axis = key / 2 % 2 == 0 ? 0 : 1;
      if (key % 2 == 0) part[axis] = std::round(part[axis]);
      places.push_back(glm::mix(low, high, part));
    }
  }

  /// The place of the leaf's error, or the places of which it is one.
  void append_samples(std::size_t k, std::vector<dvec2>& places) const {
    const Leaf& leaf = mesh_.leaves[k];
    const SampledError& sampled = mesh_.sampled_errors[k];
    const dvec2 low = tree_.vertices().parameters(leaf.low);
    const dvec2 high = tree_.vertices().parameters(leaf.high());
    if (const auto place = mesh_.error_place(k)) {
      places.push_back(*place);
    } else {
      for (const dvec2& part : validation_places(leaf)) places.push_back(glm::mix(low, high, part));
    }
    if (leaf.known_error * mesh_.allowed[k] <= sampled.distance) return;
    const auto append = [&](std::uint32_t vertex) {
      if (vertex != SampleVertices::kUnasked) places.push_back(grid_.mesh.uv[vertex]);
    };
    std::ranges::for_each(leaf.samples.side, append);
    append(leaf.samples.centre);
  }

  /// Appends places near the last one and far from it: the surface may go on there, in leaves
  /// whose vertices are undefined.
  static void append_around(const Domain& domain, std::vector<dvec2>& places) {
    const ParameterBox box = box_of(domain);
    const dvec2 from = places.back();
    dvec2 step = 0.5 * (box.high - box.low);
    for (int k = 0; k < kHalvingsToNearly; ++k, step *= 0.5) {
      for (const dvec2& way : kFourWays) places.push_back(nearest_in(box, from + step * way));
    }
  }

  /// Leaves whose samples may miss a feature; only those without a proof, if one was tried.
  std::vector<std::size_t> searchable_leaves(const LeafTriangles& triangles) const {
    const bool was_proved = mesher_.proof().was_tried();
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
      const Leaf& leaf = mesh_.leaves[k];
      if (!is_covered(leaf) || leaf.state.leads_to_pole() || mesher_.is_clipped(leaf)) continue;
      // A leaf that is left out at a crease is below the tolerance, unless a ridge sticks out of
      // it.
      if (triangles.of(k).empty() && leaf.state.is_whole()) continue;
      if (!was_proved || !mesher_.proof().is_proved(mesh_, k)) result.push_back(k);
    }
    return result;
  }

  /// Keeps the largest leaves by their parameters.
  void keep_largest(std::vector<std::size_t>& which) const {
    std::ranges::stable_sort(which, std::ranges::greater(), [this](std::size_t k) {
      return static_cast<double>(mesh_.leaves[k].size_u()) * mesh_.leaves[k].size_v();
    });
    which.resize(std::min(which.size(), std::max(kInBatch, mesh_.leaves.size() / kFewOfAll)));
  }

  const AdaptiveMesher& mesher_;
  const ValidatedMesh& mesh_;
  const CellTree& tree_;
  const Grid& grid_;
  std::size_t waves_;  ///< leaves that oscillate
  bool has_waves_;     ///< an area oscillates: no triangles there are near the surface
  double tolerance_;   ///< that the mesh was made for
  double strictest_;   ///< tolerance_; infinite if rounding alone makes it vary
};

}  // namespace

void report_errors(const Surface& surface, const MeshRequest& request, const AdaptiveMesher& mesher,
                   const LeafTriangles& triangles, MeshReport& report) {
  ErrorReporter(mesher, report).report(surface, request, triangles, report);
}

}  // namespace saddle
