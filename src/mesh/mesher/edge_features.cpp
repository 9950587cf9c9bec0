#include "mesh/mesher/edge_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/features/approach.h"
#include "mesh/features/discontinuities.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/match_seams.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Bisections of a side that the boundary crosses: a side is at most 2^10 times as long as its
/// distance from 0, so that doubles between its ends run out.
constexpr int kBoundaryBisections = 62;
/// Sides that are looked at together, before anybody asks whether that was enough: some
/// milliseconds if each one takes hundreds of looks.
constexpr std::size_t kSidesAtATime = 512;

class FeatureTracer {
 public:
  FeatureTracer(const TraceOptions& options, CellTree& tree) : options_(options), tree_(tree) {}

  /// Cuts sides that are known to lead to poles: where the surface leaves the clip box on its way
  /// there from either end. Without a box the last vertices on either side of the pole tell where
  /// the surface goes; they are no part of the mesh.
  void cut_poles(std::span<const Side> sides) {
    if (sides.empty()) return;
    std::vector<Between> places;
    std::vector<PoleWay> ways;
    for (const auto& [a, b] : sides) {
      const auto& [beside_a, beside_b] = tree_.edges().pole_between(a, b);
      places.push_back({a, b, beside_a});
      places.push_back({a, b, beside_b});
      const dvec2 pole = place_of_pole(beside_a, beside_b);
      ways.push_back({a, beside_a, pole});
      ways.push_back({b, beside_b, pole});
    }
    const bool to_faces = options_.clip && has_room();
    if (to_faces) {
      const std::vector<dvec2> faces = leave_box(ways);
      for (std::size_t k = 0; k < faces.size(); ++k) places[k].uv = faces[k];
    }
    std::uint32_t next = tree_.geometry().add_between(places, options_.threads);
    tree_.geometry().take_known_normals();
    for (const auto& [a, b] : sides) {
      const FeatureKind kind = to_faces ? FeatureKind::Face : FeatureKind::Pole;
      tree_.edges().set_feature(a, b, EdgeFeature{kind, a, next, next + 1});
      next += 2;
    }
  }

  /// Cuts sides at poles where something else cuts them, too: only one cut of a side is kept.
  void find_poles_beside_cuts(std::span<const Side> sides) {
    const Mesh& mesh = tree_.mesh();
    double delta = std::numeric_limits<double>::infinity();
    std::vector<Line> parts;
    std::vector<Side> whole;  // of each part, the end that it begins at first
    for (const Side& side : sides) {
      const std::optional<EdgeFeature> cut = tree_.edges().feature(side[0], side[1]);
      for (std::size_t end = 0; end < 2; ++end) {
        const std::uint32_t from = side[end];
        const std::uint32_t to = cut->beside(from);
        if (!tree_.geometry().is_defined(from) || mesh.uv[from] == mesh.uv[to]) continue;
        parts.push_back({mesh.uv[from], mesh.uv[to]});
        whole.push_back({from, side[1 - end]});
        delta = std::min(delta, options_.tolerance(mesh.position[from]));
      }
    }
    const auto found = find_discontinuities(tree_.surface(), parts, delta, options_.threads,
                                            tree_.effort().looks());
    std::vector<Side> poles;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto& [from, to] = whole[k];
      const Side side = {std::min(from, to), std::max(from, to)};
      if (found[k].kind != Discontinuity::Pole || tree_.edges().leads_to_pole(from, to)) continue;
      const auto& [near, far] = found[k].ends;
      tree_.edges().set_leads_to_pole(from, to,
                                      from < to ? std::array{near, far} : std::array{far, near});
      poles.push_back(side);
    }
    cut_poles(poles);
  }

  /// Finds all but creases. Returns the sides along which the surface is continuous.
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
    return continuous;
  }

  void look_at(std::span<const Side> sides) {
    const std::vector<Side> continuous = find_jumps(sides);
    for (const auto& [a, b] : continuous) tree_.edges().set_feature(a, b, std::nullopt);
    find_creases_in(continuous);
  }

 private:
  Line line(const Side& side) const { return {tree_.mesh().uv[side[0]], tree_.mesh().uv[side[1]]}; }

  /// Whether there may be more triangles: leaves that are cut at a face have twice as many.
  bool has_room() const {
    return options_.max_triangles == 0 || !tree_.budget().has_many(options_.max_triangles);
  }

  /// Fits sides of which one end is defined to the boundary.
  void fit_boundaries(std::span<const Side> sides) {
    std::vector<Line> ends;
    for (const Side& side : sides) {
      ends.push_back(line(side));
      if (!tree_.geometry().is_defined(side[0])) std::swap(ends.back()[0], ends.back()[1]);
    }
    const std::vector<dvec2> uv =
        last_defined(tree_.surface(), ends, kBoundaryBisections, options_.threads);
    std::vector<Between> places;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      places.push_back({sides[k][0], sides[k][1], uv[k]});
    }
    const std::vector<bool> goes_far = diverge_at(places);
    const std::vector<bool> at_face = end_at_faces(goes_far, places);
    const std::uint32_t first = tree_.geometry().add_between(places, options_.threads);
    tree_.geometry().take_known_normals();
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const auto boundary = static_cast<std::uint32_t>(first + k);
      const auto [a, b] = sides[k];
      const PointSingularity::Kind singularity =
          tree_.geometry().singularity(tree_.geometry().is_defined(a) ? b : a);
      const FeatureKind kind =
          at_face[k]                                                   ? FeatureKind::Face
          : singularity == PointSingularity::Kind::NoLimit             ? FeatureKind::Essential
          : goes_far[k] || singularity == PointSingularity::Kind::Pole ? FeatureKind::Pole
                                                                       : FeatureKind::Boundary;
      tree_.edges().set_feature(a, b, EdgeFeature{kind, a, boundary, boundary});
    }
  }

  /// Ends sides at which the surface goes to infinity at the boundary on a face of the clip box.
  /// Which ones it did that with.
  std::vector<bool> end_at_faces(const std::vector<bool>& goes_far, std::span<Between> boundaries) {
    std::vector<bool> at_face(boundaries.size(), false);
    if (!options_.clip) return at_face;
    std::vector<PoleWay> ways;
    for (std::size_t k = 0; k < boundaries.size(); ++k) {
      const Between& boundary = boundaries[k];
      const bool first = tree_.geometry().is_defined(boundary.a);
      const auto [end, other] =
          first ? std::pair(boundary.a, boundary.b) : std::pair(boundary.b, boundary.a);
      if (!goes_far[k] || tree_.geometry().singularity(other) == PointSingularity::Kind::NoLimit)
        continue;
      at_face[k] = true;
      tree_.edges().add_pole_beyond_face({boundary.uv, boundary.uv});
      ways.push_back({end, boundary.uv, tree_.mesh().uv[other]});
    }
    const std::vector<dvec2> faces = leave_box(ways);
    std::size_t next = 0;
    for (std::size_t k = 0; k < boundaries.size(); ++k) {
      if (at_face[k]) boundaries[k].uv = faces[next++];
    }
    return at_face;
  }

  /// A way from a vertex to infinity.
  struct PoleWay {
    std::uint32_t from;
    dvec2 last;    ///< the last known place before the pole
    dvec2 beyond;  ///< the pole, or a place beyond it: doubles may go on to there
  };

  /// Of a pole between two places, where the search for it ended: between their signs is 0.
  static dvec2 place_of_pole(const dvec2& a, const dvec2& b) {
    dvec2 place = 0.5 * a + 0.5 * b;
    for (int k = 0; k < 2; ++k) {
      if (std::signbit(a[k]) != std::signbit(b[k])) place[k] = 0;
    }
    return place;
  }

  /// Where ways leave the clip box; those that begin outside of it, at once.
  std::vector<dvec2> leave_box(std::span<const PoleWay> ways) const {
    std::vector<dvec2> last;
    for (const PoleWay& way : ways) last.push_back(way.last);
    const auto at_last = evaluate(tree_.surface(), last, options_.threads);
    std::vector<dvec2> places;
    std::vector<Line> inside;
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < ways.size(); ++k) {
      const PoleWay& way = ways[k];
      places.push_back(tree_.mesh().uv[way.from]);
      if (!options_.clip->contains(tree_.mesh().position[way.from])) continue;
      const bool goes_on = options_.clip->contains(at_last[k].position);
      inside.push_back(goes_on ? Line{way.last, way.beyond} : Line{places.back(), way.last});
      numbers.push_back(k);
    }
    const auto faces =
        last_defined(tree_.surface(), inside, kHalvingsToLeast, options_.threads, options_.clip);
    for (std::size_t i = 0; i < faces.size(); ++i) places[numbers[i]] = faces[i];
    return places;
  }

  /// Whether the surface goes to infinity at each boundary.
  std::vector<bool> diverge_at(std::span<const Between> boundaries) const {
    std::vector<Line> ways;
    double delta = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, boundary] : boundaries) {
      const std::uint32_t defined = tree_.geometry().is_defined(a) ? a : b;
      ways.push_back({boundary, tree_.mesh().uv[defined]});
      delta = std::min(delta, options_.tolerance(tree_.mesh().position[defined]));
    }
    return diverge(tree_.surface(), ways, delta, options_.threads);
  }

  /// Adds the sides along which the surface is continuous.
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
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (found[k].has_more) tree_.edges().set_has_more(sides[k][0], sides[k][1]);
      switch (found[k].kind) {
        case Discontinuity::None:
          continuous.push_back(sides[k]);
          tree_.edges().set_continuous(sides[k][0], sides[k][1]);
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
    if (options_.poles || (options_.clip && has_room())) cut_poles(poles);
    add_pairs(FeatureKind::Jump, jumping, jumps);
  }

  void find_creases_in(std::vector<Side> sides) {
    // At a singular point the normal is no sign of a crease.
    std::erase_if(sides, [&](const Side& side) {
      return !tree_.geometry().is_regular(side[0]) || !tree_.geometry().is_regular(side[1]);
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
    const auto found =
        find_creases(tree_.surface(), lines, normals, options_.threads, tree_.effort().looks());
    std::vector<Side> creased;
    std::vector<LocatedDiscontinuity> creases;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (found[k].kind == Discontinuity::None) continue;
      creased.push_back(sides[k]);
      creases.push_back(found[k]);
    }
    add_pairs(FeatureKind::Crease, creased, creases);
  }

  /// A vertex beside a cut, and the end of the side that it is on the way from.
  struct Beside {
    std::uint32_t neighbour;
    bool is_opposite;  ///< its normal is the opposite of the one before
  };

  /// Beside a cusp the normal's digits are rounding: it takes the one-sided limit along the side.
  /// `vertices`: from number `first`.
  void approach(std::span<const Beside> vertices, std::uint32_t first) {
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

  /// Vertices on either side of each cut; those that are the ends of sides are there already.
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
    if (kind == FeatureKind::Crease) approach(vertices, first);
    tree_.geometry().take_known_normals();
    std::uint32_t next = first;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      std::array<std::uint32_t, 2> beside{};
      for (std::size_t end = 0; end < 2; ++end) {
        const bool is_there = found[k].ends[end] == tree_.mesh().uv[sides[k][end]];
        beside[end] = is_there ? sides[k][end] : next++;
      }
      const std::uint32_t kept = place_to_keep(sides[k], beside);
      for (const std::uint32_t vertex : beside) {
        // An end of the side stays where it is, even if the cut is as wide as the side.
        if (vertex == kept || vertex == sides[k][0] || vertex == sides[k][1]) continue;
        if (kind == FeatureKind::Crease) tree_.geometry().join(kept, vertex);
        tree_.vertices().share_place(kept, vertex);
      }
      tree_.edges().set_feature(sides[k][0], sides[k][1],
                                EdgeFeature{kind, sides[k][0], beside[0], beside[1]});
    }
  }

  /// The vertex in whose place a cut is: an end of its side, if it is within rounding of that.
  std::uint32_t place_to_keep(const Side& side, const std::array<std::uint32_t, 2>& beside) const {
    for (std::size_t end = 0; end < 2; ++end) {
      if (tree_.vertices().place_between(beside[end]) == tree_.vertices().place_between(side[end]))
        return side[end];
    }
    return beside[0];
  }

  const TraceOptions& options_;
  CellTree& tree_;
};

/// Whether something other than the boundary cuts a side of a leaf.
bool is_crossed(const Leaf& leaf, const CellTree& tree) {
  bool is_crossed = false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const std::optional<EdgeFeature> feature = tree.edges().feature(a, b);
    is_crossed = is_crossed || (feature && !feature->is_boundary());
  });
  return is_crossed;
}

/// Calls look(some) with some sides after the other, until that was enough.
template <class Look>
void search_within_budget(std::span<const Side> sides, const TraceOptions& options,
                          const CellTree& tree, Look look) {
  while (!sides.empty() && !tree.budget().is_spent(options.max_triangles)) {
    const std::size_t count = std::min(sides.size(), kSidesAtATime);
    look(sides.first(count));
    sides = sides.subspan(count);
  }
}

}  // namespace

void trace_features(std::span<const Side> sides, const TraceOptions& options, CellTree& tree) {
  search_within_budget(sides, options, tree, [&](std::span<const Side> some) {
    FeatureTracer(options, tree).look_at(some);
  });
}

void find_jumps(std::span<const Side> sides, const TraceOptions& options, CellTree& tree) {
  search_within_budget(sides, options, tree, [&](std::span<const Side> some) {
    FeatureTracer(options, tree).find_jumps(some);
  });
}

void cut_poles(std::span<const Side> sides, const TraceOptions& options, CellTree& tree) {
  for (std::size_t begin = 0; begin < sides.size(); begin += kSidesAtATime) {
    const std::size_t count = std::min(sides.size() - begin, kSidesAtATime);
    FeatureTracer(options, tree).cut_poles(sides.subspan(begin, count));
  }
}

void find_poles_beside_cuts(std::span<const Side> sides, const TraceOptions& options,
                            CellTree& tree) {
  FeatureTracer(options, tree).find_poles_beside_cuts(sides);
}

void append_unsearched(const Leaf& leaf, const CellTree& tree, std::vector<Side>& sides) {
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    if (!tree.edges().is_searched(a, b)) sides.push_back({std::min(a, b), std::max(a, b)});
  });
}

void sort_sides(std::vector<Side>& sides) {
  std::ranges::sort(sides);
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
}

std::vector<std::size_t> follow_features(const TraceOptions& options, std::span<Leaf> leaves,
                                         CellTree& tree) {
  std::vector<std::size_t> split;
  while (true) {
    std::vector<Side> sides;
    const std::uint32_t now = tree.revisions().next();
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      Leaf& leaf = leaves[k];
      if (!tree.revisions().has_changed(leaf, leaf.bisected)) continue;
      leaf.bisected = now;
      LeafState& state = leaf.state;
      if (!state.is_cut_by_feature() && tree.edges().may_be_crossed(leaf) &&
          is_crossed(leaf, tree)) {
        state.set_features(true, count_features(leaf, tree).leads_to_pole);
        split.push_back(k);
      }
      if (state.is_whole()) continue;
      append_unsearched(leaf, tree, sides);
    }
    if (sides.empty() || tree.budget().is_spent(options.max_triangles)) return split;
    sort_sides(sides);
    trace_features(sides, options, tree);
  }
}

void trace_features_across_seams(const Seams& seams, const TraceOptions& options, const Grid& grid,
                                 CellTree& tree) {
  std::vector<Side> sides;
  for (const SeamSide& both : seam_sides_with_features(seams, grid, tree)) {
    const auto [a, b] = std::minmax(both.other[0], both.other[1]);
    if (!tree.edges().is_searched(a, b)) sides.push_back({a, b});
  }
  if (!sides.empty()) trace_features(sides, options, tree);
}

}  // namespace saddle
