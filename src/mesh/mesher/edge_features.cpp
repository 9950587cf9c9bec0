#include "mesh/mesher/edge_features.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "mesh/features/approach.h"
#include "mesh/features/cliffs.h"
#include "mesh/features/creases.h"
#include "mesh/features/discontinuities.h"
#include "mesh/mesher/pole_features.h"
#include "mesh/mesher/strip_features.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "surface/normal.h"
#include "surface/parameter_box.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Searches a batch of sides.
class FeatureTracer {
 public:
  FeatureTracer(const TraceOptions& options, CellTree& tree) : options_(options), tree_(tree) {}

  /// Finds all features but creases. Returns the sides without any along which the surface is
  /// continuous.
  std::vector<Side> find_jumps(std::span<const Side> sides) {
    std::vector<Side> boundaries;
    std::vector<Side> inner;
    std::vector<Side> continuous;
    for (const Side& side : sides) {
      const bool first = tree_.geometry().is_defined(side[0]);
      const bool second = tree_.geometry().is_defined(side[1]);
      if (first != second) {
        boundaries.push_back(side);
      } else if (!first) {
        tree_.edges().set_feature(side[0], side[1], std::nullopt);
      } else if (!options_.poles && tree_.edges().is_continuous(side[0], side[1])) {
        continuous.push_back(side);
      } else {
        inner.push_back(side);
      }
    }
    if (!boundaries.empty()) fit_boundaries(boundaries);
    if (!inner.empty()) find_jumps_in(inner, continuous);
    if (!options_.poles) cut_at_cliffs(continuous);
    return continuous;
  }

  void find_features(std::span<const Side> sides) {
    const std::vector<Side> continuous = find_jumps(sides);
    for (const auto& [a, b] : continuous) tree_.edges().set_feature(a, b, std::nullopt);
    find_creases_in(continuous);
  }

 private:
  Line line(const Side& side) const { return {tree_.mesh().uv[side[0]], tree_.mesh().uv[side[1]]}; }

  /// Places boundaries on sides with one defined end.
  void fit_boundaries(std::span<const Side> sides) {
    std::vector<Line> ends;
    for (const Side& side : sides) {
      ends.push_back(line(side));
      if (!tree_.geometry().is_defined(side[0])) std::swap(ends.back()[0], ends.back()[1]);
    }
    const std::vector<dvec2> uv =
        last_defined(tree_.surface(), ends, kAllHalvings, options_.threads);
    std::vector<Between> places;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      places.push_back({sides[k][0], sides[k][1], uv[k]});
    }
    const std::vector<bool> goes_far = diverge_at(places, options_, tree_);
    stop_at_jumps(sides, ends, goes_far, places);
    const std::vector<bool> at_face = end_at_faces(goes_far, places, options_, tree_);
    const std::uint32_t first = tree_.geometry().add_between(places, options_.threads);
    tree_.geometry().take_known_normals();
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const auto boundary = static_cast<std::uint32_t>(first + k);
      const auto [a, b] = sides[k];
      const PointSingularity::Kind singularity =
          tree_.geometry().singularity(tree_.geometry().is_defined(a) ? b : a);
      const FeatureKind kind =
          at_face[k]                                                   ? FeatureKind::Face
          : singularity == PointSingularity::Kind::Essential           ? FeatureKind::Essential
          : goes_far[k] || singularity == PointSingularity::Kind::Pole ? FeatureKind::Pole
                                                                       : FeatureKind::Boundary;
      tree_.edges().set_feature(a, b, EdgeFeature{kind, a, boundary, boundary});
    }
  }

  /// Moves boundaries, which are past jumps from the defined ends of their sides, to the jumps.
  /// Ways that go to infinity, as past the jumps of floor(1/u), stay.
  void stop_at_jumps(std::span<const Side> sides, std::span<const Line> lines,
                     const std::vector<bool>& goes_far, std::span<Between> places) {
    SurfaceEnclosure enclosure(tree_.surface(), Bounded::Position);
    std::vector<std::size_t> open;
    std::vector<Line> parts;
    double delta = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const std::span<const Interval> bounds = enclosure.enclose({lines[k][0], places[k].uv});
      const bool is_continuous = std::ranges::all_of(bounds, &Interval::continuous);
      if (is_continuous || goes_far[k] || lines[k][0] == places[k].uv) continue;
      open.push_back(k);
      parts.push_back({lines[k][0], places[k].uv});
      const std::uint32_t end = sides[k][tree_.geometry().is_defined(sides[k][0]) ? 0 : 1];
      delta = std::min(delta, options_.tolerance(tree_.mesh().position[end]));
    }
    if (open.empty()) return;
    const auto found = find_discontinuities(tree_.surface(), parts, delta, options_.threads,
                                            tree_.effort().looks());
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (found[i].kind != Discontinuity::Jump) continue;
      const std::size_t k = open[i];
      const dvec2& beyond = found[i].ends[1];
      // The rim itself may have a value of its own, which is no second feature.
      if (glm::distance(beyond, places[k].uv) > kSame * glm::distance(lines[k][0], lines[k][1]))
        tree_.edges().set_has_more(sides[k][0], sides[k][1], 0.5 * (beyond + places[k].uv));
      places[k].uv = found[i].ends[0];
    }
  }

  /// Finds jumps and poles. Appends the sides along which the surface is continuous.
  void find_jumps_in(std::span<const Side> sides, std::vector<Side>& continuous) {
    double delta = std::numeric_limits<double>::infinity();
    std::vector<Line> lines;
    for (const Side& side : sides) {
      lines.push_back(line(side));
      delta = std::min(delta, options_.tolerance(tree_.mesh().position[side[0]]));
    }
    const auto found = find_discontinuities(tree_.surface(), lines, delta, options_.threads,
                                            tree_.effort().looks());
    std::vector<Side> jumping;
    std::vector<LocatedDiscontinuity> jumps;
    std::vector<Side> poles;
    const std::vector<bool> is_done = add_strips(sides, found, delta, options_, tree_);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (is_done[k]) continue;
      if (const auto& between = found[k].between)
        tree_.edges().set_has_more(sides[k][0], sides[k][1], *between);
      switch (found[k].kind) {
        case Discontinuity::None:
          continuous.push_back(sides[k]);
          tree_.edges().set_continuous(sides[k][0], sides[k][1]);
          if (found[k].is_proved) tree_.edges().set_proved(sides[k][0], sides[k][1]);
          break;
        case Discontinuity::Jump:
          jumping.push_back(sides[k]);
          jumps.push_back(found[k]);
          break;
        case Discontinuity::Pole:
          tree_.edges().set_feature(sides[k][0], sides[k][1], std::nullopt);
          tree_.edges().set_leads_to_pole(sides[k][0], sides[k][1], found[k].ends);
          poles.push_back(sides[k]);
      }
    }
    if (options_.poles || (options_.clip && tree_.budget().has_room_for_faces(options_.triangles)))
      cut_poles(poles, options_, tree_);
    add_pairs(FeatureKind::Jump, jumping, jumps);
    for (std::size_t k = 0; k < jumps.size(); ++k) {
      if (jumps[k].is_proved && jumps[k].jumps.size() == 1)
        tree_.edges().set_proved(jumping[k][0], jumping[k][1]);
    }
  }

  /// Finds cliffs. Leaves the sides that have none.
  void cut_at_cliffs(std::vector<Side>& sides) {
    if (!tree_.edges().may_have_cliffs()) return;
    const bool has_seams = tree_.edges().has_seams();
    const ParameterBox domain = box_of(tree_.surface().domain);
    std::vector<Line> lines;
    double delta = std::numeric_limits<double>::infinity();
    for (const Side& side : sides) {
      const auto [a, b] = line(side);
      const bool is_on_seam = has_seams && is_on_edge({a, b}, domain);
      lines.push_back({a, is_on_seam ? a : b});  // a line without length has no cliff
      delta = std::min(delta, options_.tolerance(tree_.mesh().position[side[0]]));
    }
    const auto cliffs =
        find_cliffs(tree_.surface(), lines, delta, options_.threads, tree_.effort().looks());
    std::vector<Side> cut;
    std::vector<Cliff> found;
    std::vector<Side> others;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (cliffs[k].empty()) {
        others.push_back(sides[k]);
        continue;
      }
      cut.push_back(sides[k]);
      found.push_back(cliffs[k]);
    }
    tree_.edges().count_cliffs(sides.size(), cut.size());
    if (!cut.empty()) add_cliffs(cut, found, options_.threads, tree_);
    sides = std::move(others);
  }

  void find_creases_in(std::vector<Side> sides) {
    // A turn of the normal at a singular point is no crease. A thin strip has a vertex on its
    // crest, and no crease beside it: few of the sides that it crosses would show one.
    std::erase_if(sides, [&](const Side& side) {
      return tree_.thin().contains(side[0]) || tree_.thin().contains(side[1]) ||
             !tree_.geometry().is_regular(side[0]) || !tree_.geometry().is_regular(side[1]);
    });
    if (sides.empty()) return;
    std::vector<Line> lines(sides.size());
    std::ranges::transform(sides, lines.begin(), [&](const Side& side) { return line(side); });
    const double front = tree_.surface().flip ? -1 : 1;
    const auto& normal = tree_.mesh().normal;
    std::vector<std::array<dvec3, 2>> normals(sides.size());
    std::ranges::transform(sides, normals.begin(), [&](const Side& side) {
      return std::array{front * normal[side[0]], front * normal[side[1]]};
    });
    const auto found = find_creases(tree_.surface(), lines, normals, options_.threads,
                                    tree_.edges().patience(), tree_.effort().looks());
    std::vector<Side> creased;
    std::vector<LocatedDiscontinuity> creases;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (found[k].kind == Discontinuity::None) continue;
      creased.push_back(sides[k]);
      creases.push_back(found[k]);
    }
    add_slight_jumps(creased, creases);
    add_pairs(FeatureKind::Crease, creased, creases);
  }

  /// Adds jumps at creases that are smaller than the tolerance, but not small. Leaves the others.
  void add_slight_jumps(std::vector<Side>& sides, std::vector<LocatedDiscontinuity>& creases) {
    std::vector<dvec2> uv;
    for (const LocatedDiscontinuity& crease : creases)
      uv.insert(uv.end(), crease.ends.begin(), crease.ends.end());
    const std::vector<dvec3> at = evaluate_positions(tree_.surface(), uv, options_.threads);
    tree_.effort().looks() += uv.size();
    std::vector<std::size_t> open;
    std::vector<Line> lines;
    double delta = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const double least = kUnnoticed * options_.tolerance(at[2 * k]);
      if (!(glm::distance(at[2 * k], at[2 * k + 1]) > least)) continue;
      open.push_back(k);
      lines.push_back(line(sides[k]));
      delta = std::min(delta, least);
    }
    if (open.empty()) return;
    const auto found = find_discontinuities(tree_.surface(), lines, delta, options_.threads,
                                            tree_.effort().looks());
    std::vector<Side> jumping;
    std::vector<LocatedDiscontinuity> jumps;
    std::vector<bool> is_jump(sides.size());
    for (std::size_t i = 0; i < open.size(); ++i) {
      const double away = glm::distance(found[i].ends[0], creases[open[i]].ends[0]);
      is_jump[open[i]] = found[i].kind == Discontinuity::Jump && !found[i].between &&
                         away <= kNearly * glm::distance(lines[i][0], lines[i][1]);
      if (!is_jump[open[i]]) continue;
      jumping.push_back(sides[open[i]]);
      jumps.push_back(found[i]);
    }
    add_pairs(FeatureKind::Jump, jumping, jumps);
    std::erase_if(sides, [&](const Side& side) { return is_jump[&side - sides.data()]; });
    std::erase_if(creases, [&](const auto& crease) { return is_jump[&crease - creases.data()]; });
  }

  /// A vertex beside a feature.
  struct Beside {
    std::uint32_t neighbour;  ///< the end of the side on the same side of the feature
    bool is_opposite;         ///< its normal is the opposite of the previous vertex's
  };

  /// Sets the normals of vertices, numbered from `first`, to the one-sided limits along their
  /// sides: beside a cusp the normal itself is rounding error.
  void set_limit_normals(std::span<const Beside> vertices, std::uint32_t first) {
    const Mesh& mesh = tree_.mesh();
    std::vector<Approach> approaches;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      if (vertices[k].is_opposite) continue;
      approaches.push_back({mesh.uv[first + k], mesh.uv[vertices[k].neighbour]});
    }
    const auto limits = limit_normals(tree_.surface(), approaches, options_.threads);
    std::optional<dvec3> normal;
    std::size_t next = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      normal = !vertices[k].is_opposite ? limits[next++].normal
               : normal                 ? std::optional(-*normal)
                                        : std::nullopt;
      if (normal) tree_.geometry().set_normal(static_cast<std::uint32_t>(first + k), *normal);
    }
  }

  void set_normals_beside_jumps(std::span<const Beside> vertices, std::uint32_t first) {
    const auto& uv = tree_.mesh().uv;
    std::vector<std::uint32_t> numbers(vertices.size());
    std::iota(numbers.begin(), numbers.end(), first);
    std::vector<dvec2> at;
    for (std::size_t k = 0; k < vertices.size(); ++k)
      at.push_back(beside_jump(uv[numbers[k]], uv[vertices[k].neighbour]));
    set_normals(numbers, at, options_.threads, tree_);
  }

  /// Records features with a vertex on either side of each; an end of a side may be one of them.
  void add_pairs(FeatureKind kind, std::span<const Side> sides,
                 std::span<const LocatedDiscontinuity> found) {
    const auto& uv = tree_.mesh().uv;
    std::vector<Between> places;
    std::vector<Beside> vertices;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      bool is_second = false;
      for (std::size_t end = 0; end < 2; ++end) {
        if (found[k].ends[end] == uv[sides[k][end]]) continue;
        places.push_back({sides[k][0], sides[k][1], found[k].ends[end]});
        vertices.push_back({sides[k][end], is_second && found[k].is_cusp});
        is_second = true;
      }
    }
    const std::uint32_t first = tree_.geometry().add_between(places, options_.threads);
    if (kind == FeatureKind::Crease) set_limit_normals(vertices, first);
    if (kind == FeatureKind::Jump) set_normals_beside_jumps(vertices, first);
    tree_.geometry().take_known_normals();
    std::uint32_t next = first;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      std::array<std::uint32_t, 2> beside{};
      for (std::size_t end = 0; end < 2; ++end) {
        const bool is_there = found[k].ends[end] == tree_.mesh().uv[sides[k][end]];
        beside[end] = is_there ? sides[k][end] : next++;
      }
      const std::uint32_t kept = place_to_keep(sides[k], beside, tree_);
      for (const std::uint32_t vertex : beside) {
        // The ends of a side keep their places, even if the feature is as wide as the side.
        if (vertex == kept || vertex == sides[k][0] || vertex == sides[k][1]) continue;
        if (kind == FeatureKind::Crease) tree_.geometry().join(kept, vertex);
        tree_.vertices().share_place(kept, vertex);
      }
      tree_.edges().set_feature(sides[k][0], sides[k][1],
                                EdgeFeature{kind, sides[k][0], beside[0], beside[1]});
    }
  }

  const TraceOptions& options_;
  CellTree& tree_;
};

/// Calls search(batch) with batches of sides until the budget is spent.
template <class Search>
void search_within_budget(std::span<const Side> sides, const TraceOptions& options,
                          const CellTree& tree, Search search) {
  while (!sides.empty() && !tree.budget().is_spent(options.triangles)) {
    const std::size_t count = std::min(sides.size(), 4 * kInBatch);
    search(sides.first(count));
    sides = sides.subspan(count);
  }
}

}  // namespace

void trace_features(std::span<const Side> sides, const TraceOptions& options, CellTree& tree) {
  search_within_budget(sides, options, tree, [&](std::span<const Side> batch) {
    FeatureTracer(options, tree).find_features(batch);
  });
}

void find_jumps(std::span<const Side> sides, const TraceOptions& options, CellTree& tree) {
  search_within_budget(sides, options, tree, [&](std::span<const Side> batch) {
    FeatureTracer(options, tree).find_jumps(batch);
  });
}

void append_unsearched(const Leaf& leaf, const CellTree& tree, std::vector<Side>& sides) {
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    if (!tree.edges().is_searched(a, b)) sides.push_back(side_of(a, b));
  });
}

std::vector<Side> unsearched_sides(std::span<const Leaf> leaves, unsigned threads,
                                   const CellTree& tree) {
  std::vector<Side> sides = gather_in_chunks<Side>(
      leaves.size(), kInBatch, threads,
      [&](std::size_t k, std::vector<Side>& some) { append_unsearched(leaves[k], tree, some); });
  sort_sides(sides);
  return sides;
}

void sort_sides(std::vector<Side>& sides) {
  std::ranges::sort(sides);
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
}

}  // namespace saddle
