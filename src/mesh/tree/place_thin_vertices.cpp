#include "mesh/tree/place_thin_vertices.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/features/approach.h"
#include "mesh/features/thin_parts.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/continuity.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

namespace {

/// A side between neighbours, and its vertices.
struct PlacedSide {
  std::array<std::uint32_t, 2> ends;
  std::array<DyadicPoint, 2> places;
  std::uint32_t middle = SampleVertices::kUnasked;  ///< of a whole side of a leaf
};

/// A place in a thin part, and how near to its position in space that of a vertex is to be.
struct Target {
  dvec2 uv;
  dvec3 position{0};
  double near = kInfinity;
};

/// How far the middle of three points is from the others' middle.
double fall_beside(std::span<const dvec3, 3> points) {
  return glm::distance(points[1], 0.5 * (points[0] + points[2]));
}

DyadicPoint middle_of(const DyadicPoint& a, const DyadicPoint& b) {
  return {a.u / 2 + b.u / 2 + (a.u % 2 + b.u % 2) / 2, a.v / 2 + b.v / 2 + (a.v % 2 + b.v % 2) / 2};
}

class ThinVertexPlacer {
 public:
  ThinVertexPlacer(std::span<const Leaf> leaves, const Tolerance& tolerance, unsigned threads,
                   CellTree& tree)
      : leaves_(leaves), tolerance_(tolerance), threads_(threads), tree_(tree) {}

  /// A round finds a thin part of each side, and the next one those between it and the ends. A side
  /// with more than kMostLineParts has waves, as beside u=0 in gamma(1/u): there is no end of them.
  void run() {
    for (std::size_t parts = 1; parts < kMostLineParts && place_in(alike_sides());) parts *= 2;
  }

 private:
  /// The sides between alike vertices that were not searched before.
  std::vector<PlacedSide> alike_sides() {
    std::vector<PlacedSide> sides;
    std::vector<std::uint32_t> vertices;  // of a side
    std::vector<DyadicPoint> places;
    for (const Leaf& leaf : leaves_) {
      const auto corners = leaf.corners();
      for (std::size_t k = 0; k < 4; ++k) {
        vertices.clear();
        places.clear();
        tree_.vertices().walk(leaf, k, [&](std::uint32_t vertex, DyadicPoint place) {
          vertices.push_back(vertex);
          places.push_back(place);
        });
        vertices.push_back(leaf.samples.corner[(k + 1) % 4]);
        places.push_back(corners[(k + 1) % 4]);
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
          const std::array ends = {vertices[i], vertices[i + 1]};
          if (tree_.geometry().is_defined(ends[0]) != tree_.geometry().is_defined(ends[1]))
            continue;
          if (!tree_.thin().starts_search(ends[0], ends[1])) continue;
          sides.push_back({ends,
                           {places[i], places[i + 1]},
                           vertices.size() == 2 ? leaf.samples.side[k] : SampleVertices::kUnasked});
        }
      }
    }
    return sides;
  }

  bool is_defined(const PlacedSide& side) const {
    return tree_.geometry().is_defined(side.ends[0]);
  }

  /// Returns whether vertices were added.
  bool place_in(const std::vector<PlacedSide>& sides) {
    std::vector<AlikeEnds> lines;
    lines.reserve(sides.size());
    for (const PlacedSide& side : sides) {
      lines.push_back(
          {{tree_.mesh().uv[side.ends[0]], tree_.mesh().uv[side.ends[1]]}, is_defined(side)});
    }
    std::size_t work = 0;
    auto found = find_thin_parts(tree_.surface(), lines, threads_, work);
    drop_narrow_gaps(lines, found, work);
    std::vector<PlacedSide> thin;
    std::vector<Target> targets;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!found[k]) continue;
      thin.push_back(sides[k]);
      targets.push_back({*found[k]});
    }
    aim_at_crests(thin, targets, work);
    const std::vector<int> depths = depths_of(thin, targets, work);
    tree_.effort().looks() += work;
    std::vector<std::uint32_t> last;
    std::vector<bool> was_defined;
    for (std::size_t k = 0; k < thin.size(); ++k) {
      if (depths[k] == 0) continue;
      was_defined.push_back(is_defined(thin[k]));
      last.push_back(use_middles(thin[k], targets[k].uv, depths[k]));
    }
    tree_.geometry().evaluate(threads_);
    for (std::size_t k = 0; k < last.size(); ++k) {
      if (tree_.geometry().is_defined(last[k]) != was_defined[k]) tree_.thin().add(last[k]);
    }
    return !last.empty();
  }

  /// Drops the gaps whose edges are within the tolerance of each other, and those beside vertices
  /// that only a limit defines: a line may have no values at all, as v/(u+sqrt(u^2-v)) at v=0.
  void drop_narrow_gaps(std::span<const AlikeEnds> lines, std::span<std::optional<dvec2>> found,
                        std::size_t& work) const {
    std::vector<std::size_t> gaps;
    std::vector<Line> ways;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!found[k] || !lines[k].are_defined) continue;
      gaps.push_back(k);
      for (const dvec2& end : lines[k].line) ways.push_back({end, *found[k]});
    }
    const auto edges = last_defined(tree_.surface(), ways, kHalvingsToNearly, threads_);
    const std::vector<SurfacePoint> points = evaluate(tree_.surface(), edges, threads_);
    work += kHalvingsToNearly * edges.size();
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      const dvec3& first = points[2 * i].position;
      const dvec3& second = points[2 * i + 1].position;
      if (!(glm::distance(first, second) > tolerance_(first))) found[gaps[i]].reset();
    }
  }

  /// Moves the targets in strips with a crest along their middle to the crest. From a crest the
  /// surface falls in proportion to the way; from a smooth top, to its square.
  void aim_at_crests(std::span<const PlacedSide> sides, std::span<Target> targets,
                     std::size_t& work) const {
    std::vector<std::size_t> strips;
    std::vector<Line> ways;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (is_defined(sides[k])) continue;
      strips.push_back(k);
      for (const std::uint32_t end : sides[k].ends)
        ways.push_back({targets[k].uv, tree_.mesh().uv[end]});
    }
    const auto edges = last_defined(tree_.surface(), ways, kHalvingsToNearly, threads_);
    std::vector<dvec2> uv;
    for (std::size_t i = 0; i < edges.size(); i += 2) {
      for (const double part : {1.0, kFarApart}) {
        for (const double share : kAlongLine)
          uv.push_back(glm::mix(edges[i], edges[i + 1], 0.5 + part * (share - 0.5)));
      }
    }
    const std::vector<dvec3> points = evaluate_positions(tree_.surface(), uv, threads_);
    work += kHalvingsToNearly * edges.size() + points.size();
    for (std::size_t i = 0; i < strips.size(); ++i) {
      const auto all = std::span(points).subspan(6 * i, 6);
      const double fall = fall_beside(all.first<3>());
      const double fall_near = fall_beside(all.last<3>());
      const double allowed = kUnnoticed * tolerance_(all[1]);
      // Between what is left of either on a way of kFarApart.
      const double between = kFarApart * std::sqrt(kFarApart);
      if (fall > allowed && fall_near > between * fall)
        targets[strips[i]] = {uv[6 * i + 1], all[1], allowed};
    }
  }

  /// Replaces a side by its half toward a target.
  DyadicPoint halve_toward(const dvec2& target, std::array<DyadicPoint, 2>& places,
                           std::size_t* replaced = nullptr) const {
    const DyadicPoint middle = middle_of(places[0], places[1]);
    const int axis = places[0].u != places[1].u ? 0 : 1;
    const double from = tree_.vertices().parameters(places[0])[axis];
    const double at = tree_.vertices().parameters(middle)[axis];
    const bool is_first = (target[axis] < at) == (from < at);
    places[is_first ? 1 : 0] = middle;
    if (replaced != nullptr) *replaced = is_first ? 1 : 0;
    return middle;
  }

  /// Halvings of each side toward its target that lead to a vertex in the thin part; 0: none does.
  std::vector<int> depths_of(const std::vector<PlacedSide>& sides,
                             const std::vector<Target>& targets, std::size_t& work) const {
    std::vector<int> depths(sides.size(), 0);
    std::vector<std::size_t> open;
    std::vector<std::array<DyadicPoint, 2>> places;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      open.push_back(k);
      places.push_back(sides[k].places);
    }
    for (int depth = 1; !open.empty(); ++depth) {
      std::vector<std::size_t> next;
      std::vector<dvec2> uv;
      for (const std::size_t k : open) {
        const std::array<DyadicPoint, 2> before = places[k];
        const DyadicPoint middle = halve_toward(targets[k].uv, places[k]);
        if (middle == before[0] || middle == before[1]) continue;
        next.push_back(k);
        uv.push_back(tree_.vertices().parameters(middle));
      }
      const std::vector<SurfacePoint> points = evaluate(tree_.surface(), uv, threads_);
      work += points.size();
      open.clear();
      for (std::size_t i = 0; i < next.size(); ++i) {
        const std::size_t k = next[i];
        const bool is_inside = is_finite(points[i].position) != is_defined(sides[k]);
        if (is_inside) depths[k] = depth;
        const double distance = glm::distance(points[i].position, targets[k].position);
        if (!is_inside || distance > targets[k].near) open.push_back(k);
      }
    }
    return depths;
  }

  /// Returns the last middle.
  std::uint32_t use_middles(PlacedSide side, const dvec2& target, int depth) {
    std::uint32_t vertex = side.middle;
    for (int k = 0; k < depth; ++k) {
      std::size_t replaced = 0;
      const DyadicPoint middle = halve_toward(target, side.places, &replaced);
      if (k > 0 || vertex == SampleVertices::kUnasked) vertex = tree_.vertices().vertex(middle);
      tree_.use_middle(side.ends[0], vertex, side.ends[1]);
      side.ends[replaced] = vertex;
    }
    return vertex;
  }

  std::span<const Leaf> leaves_;
  const Tolerance& tolerance_;
  unsigned threads_;
  CellTree& tree_;
};

}  // namespace

void place_thin_vertices(std::span<const Leaf> leaves, const Tolerance& tolerance, unsigned threads,
                         CellTree& tree) {
  if (!leaves.empty()) ThinVertexPlacer(leaves, tolerance, threads, tree).run();
}

}  // namespace saddle
