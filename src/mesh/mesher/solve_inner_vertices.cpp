#include "mesh/mesher/solve_inner_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/features/sheet_ends.h"
#include "mesh/mesher/sheet_chord.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

namespace {

/// Rounds of rays: each divides the bracket of a corner by 8 at least, and by far more on straight
/// lines.
constexpr int kRayRounds = 5;
/// An edge has a corner if two neighbouring places hold 0.6 of its turn, and enough of it: of a
/// smooth arc they hold 0.3.
constexpr double kShareOfCorner = 0.6;
/// An edge nearer to its chord than 1e-5 of the leaf is straight.
constexpr double kStraight = 1e-5;
/// A ray to a corner of the feature goes on by 1e-4 of itself, to show that the sheet ends there.
constexpr double kOvershoot = 1e-4;
/// Chords that are near enough are looked at on the rays of kAlongLine alone. Two neighbouring
/// places hold 0.85 of the turn at a corner, and 0.67 of that of an arc.
constexpr double kGlanceAtCorner = 0.85;

/// Whether a place, in sides of a leaf from its low corner, is in the leaf.
bool is_in_leaf(const dvec2& place) {
  return std::min(place.x, place.y) >= 0 && std::max(place.x, place.y) <= 1;
}

/// Whether an edge has a corner that turns by so many radians between two neighbouring places: on a
/// steep rim a small turn is a deep notch.
bool is_corner(double sharpest_turn) {
  return sharpest_turn > glm::radians(kCreaseDegrees);
}

/// Whether an edge that turns by so many radians in all is no straight line.
bool is_bent(double total_turn) {
  return total_turn > glm::radians(kSharpDegrees);
}

class Solver {
 public:
  Solver(std::span<const std::size_t> which, const CellLimits& limits, ValidatedMesh& mesh,
         CellTree& tree)
      : limits_(limits), mesh_(mesh), tree_(tree) {
    for (const std::size_t leaf : which) {
      delta_ = std::min(delta_, mesh.allowed[leaf]);
      add_chords(leaf);
    }
  }

  std::vector<std::size_t> run() {
    for (SheetChord& chord : chords_) {
      chord.nodes.front() = chord.ends[0];
      chord.nodes.back() = chord.ends[1];
      for (std::size_t k = 0; k < kNodes; ++k)
        chord.shares[k] = static_cast<double>(k) / (kNodes - 1);
    }
    glance();
    for (int round = 0; round < kRayRounds; ++round) {
      shoot(round);
      for (SheetChord& chord : chords_) narrow(chord, round == 0);
    }
    return add_vertices();
  }

 private:
  dvec2 to_parameters(std::size_t leaf, const dvec2& place) const {
    const dvec2 low = tree_.vertices().parameters(mesh_.leaves[leaf].low);
    const dvec2 high = tree_.vertices().parameters(mesh_.leaves[leaf].high());
    return glm::mix(low, high, place);
  }
  dvec2 from_parameters(std::size_t leaf, const dvec2& uv) const {
    const dvec2 low = tree_.vertices().parameters(mesh_.leaves[leaf].low);
    const dvec2 high = tree_.vertices().parameters(mesh_.leaves[leaf].high());
    return (uv - low) / (high - low);
  }
  dvec2 to_units(std::size_t leaf, const dvec2& place) const {
    const Leaf& of = mesh_.leaves[leaf];
    return glm::mix(dvec2(of.low.u, of.low.v), dvec2(of.high().u, of.high().v), place);
  }

  /// Adds the sides of sub-polygons that go through the leaf.
  void add_chords(std::size_t number) {
    const Leaf& leaf = mesh_.leaves[number];
    if (tree_.inner().has(leaf)) return;
    const dvec2 low(leaf.low.u, leaf.low.v);
    const dvec2 size(leaf.size_u(), leaf.size_v());
    for (const Polygon& polygon : sub_polygons(leaf, tree_)) {
      const auto place = [&](std::size_t k) {
        return (polygon[k % polygon.size()].place - low) / size;
      };
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const PolygonCorner& start = polygon[k];
        const PolygonCorner& next = polygon[(k + 1) % polygon.size()];
        const dvec2 middle = 0.5 * (place(k) + place(k + 1));
        if (!is_chord(middle, {start.corner, next.corner}, tree_)) continue;
        SheetChord chord{number, {start, next}, {place(k), place(k + 1)}, middle};
        double height = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const double above = cross(chord.ends[1] - chord.ends[0], place(i) - chord.ends[0]);
          if (above <= height) continue;
          height = above;
          chord.from = place(i);
        }
        chord.is_open = height > kNearly;
        chord.is_near = !mesh_.sampled_errors[number].is_off_chord;
        chords_.push_back(chord);
      }
    }
  }

  /// The last place of a sheet on a ray.
  struct EdgePlace {
    dvec2 place;
    dvec2 uv;
    bool is_edge;      ///< the sheet does not go on beyond
    bool is_boundary;  ///< the surface is undefined beyond
  };
  /// Finds the last places of sheets on rays that lead to no pole.
  std::vector<std::optional<EdgePlace>> edges_on(std::span<const std::size_t> leaves,
                                                 std::span<const Line> rays, int bisections) {
    std::vector<Line> lines;
    for (std::size_t k = 0; k < rays.size(); ++k) {
      lines.push_back({to_parameters(leaves[k], rays[k][0]), to_parameters(leaves[k], rays[k][1])});
    }
    std::size_t work = 0;
    const auto ends = sheet_ends(tree_.surface(), lines, {delta_, bisections, limits_.clip},
                                 limits_.threads, work);
    tree_.effort().add_places(work);
    std::vector<std::optional<EdgePlace>> edges(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k) {
      if (!ends[k]) continue;
      const SheetEnd::Kind kind = ends[k]->kind;
      // A value of its own ends where it is.
      const bool is_edge = rays[k][0] == rays[k][1] || kind != SheetEnd::Kind::Open;
      edges[k] = {from_parameters(leaves[k], ends[k]->uv), ends[k]->uv, is_edge,
                  kind == SheetEnd::Kind::Boundary};
    }
    return edges;
  }

  /// Looks at the edges of open chords on rays through shares_of(chord). Calls take(chord, places)
  /// with a place for each ray. Closes chords that have a ray without an edge, but for those whose
  /// other rays end at a boundary: there the sheet touches another one.
  template <class Shares, class Take>
  void look(Shares shares_of, int bisections, Take take) {
    std::vector<std::size_t> leaves;
    std::vector<Line> rays;
    std::vector<SheetChord*> looked_at;
    for (SheetChord& chord : chords_) {
      const std::span<const double> shares = shares_of(chord);
      if (!chord.is_open || shares.empty()) continue;
      looked_at.push_back(&chord);
      for (const double share : shares) {
        leaves.push_back(chord.leaf);
        rays.push_back({chord.from, border_of_square(chord.from, chord.at(share) - chord.from)});
      }
    }
    const auto edges = edges_on(leaves, rays, bisections);
    std::size_t next = 0;
    std::vector<std::optional<dvec2>> places;
    for (SheetChord* const chord : looked_at) {
      places.clear();
      bool slips = false;
      bool is_boundary = true;
      for (std::size_t k = 0; k < shares_of(*chord).size(); ++k, ++next) {
        chord->is_open = chord->is_open && edges[next];
        if (!chord->is_open) continue;
        const bool is_edge = edges[next]->is_edge;
        slips = slips || !is_edge;
        is_boundary = is_boundary && (!is_edge || edges[next]->is_boundary);
        places.push_back(is_edge ? std::optional(edges[next]->place) : std::nullopt);
      }
      chord->is_open = chord->is_open && (!slips || is_boundary);
      if (chord->is_open) take(*chord, places);
    }
  }

  /// Closes the chords that are near enough and have no corner. Notes the leaves of which no half
  /// can have one.
  void glance() {
    const auto shares_of = [](const SheetChord& chord) {
      return chord.is_near ? std::span<const double>(kAlongLine) : std::span<const double>();
    };
    using Places = std::span<const std::optional<dvec2>>;
    look(shares_of, kHalvingsOfSecondOrder, [](SheetChord& chord, Places places) {
      const auto is_there = [](const auto& place) { return place.has_value(); };
      if (!std::ranges::all_of(places, is_there)) return;
      const std::array<dvec2, kAlongLine.size() + 2> nodes = {chord.ends[0], *places[0], *places[1],
                                                              *places[2], chord.ends[1]};
      std::array<double, kAlongLine.size()> turns = {};
      for (std::size_t k = 0; k < turns.size(); ++k)
        turns[k] = turn_between(nodes[k + 1] - nodes[k], nodes[k + 2] - nodes[k + 1]);
      const double sum = std::fabs(turns[0]) + std::fabs(turns[1]) + std::fabs(turns[2]);
      const double sharp = std::max(std::fabs(turns[0] + turns[1]), std::fabs(turns[1] + turns[2]));
      chord.is_open = sharp > kGlanceAtCorner * sum && is_corner(sharp);
      chord.is_smooth = !chord.is_open && !is_bent(sum);
    });
    for_leaves_of(chords_, [this](std::span<const SheetChord> chords) {
      if (std::ranges::all_of(chords, &SheetChord::is_smooth))
        mesh_.leaves[chords[0].leaf].state.note_smooth_cut();
    });
  }

  void shoot(int round) {
    const auto shares_of = [](const SheetChord& chord) {
      return std::span<const double>(chord.shares).subspan(1, kRays);
    };
    look(shares_of, round == 0 ? kHalvingsToNearly : kAllHalvings,
         [](SheetChord& chord, std::span<const std::optional<dvec2>> places) {
           chord.slipping.reset();
           for (std::size_t k = 0; k < kRays; ++k) {
             if (places[k]) {
               chord.nodes[k + 1] = *places[k];
             } else {
               chord.slipping = {chord.slipping ? (*chord.slipping)[0] : k + 1, k + 1};
             }
           }
         });
  }

  /// Narrows the bracket of the corner. On a smooth edge, chooses the place farthest from the
  /// chord.
  static void narrow(SheetChord& chord, bool is_first) {
    if (!chord.is_open) return;
    if (chord.slipping) return narrow_to_touch(chord);
    const auto& nodes = chord.nodes;
    std::array<double, kNodes> turns = {};
    double sum = 0;
    for (std::size_t k = 1; k <= kRays; ++k) {
      turns[k] = turn_between(nodes[k] - nodes[k - 1], nodes[k + 1] - nodes[k]);
      sum += std::fabs(turns[k]);
    }
    std::size_t sharpest = 0;  // the corner is between this node and the next
    double sharp = -1;
    for (std::size_t k = 0; k <= kRays; ++k) {
      const double both = std::fabs(turns[k] + turns[k + 1]);
      if (both <= sharp) continue;
      sharpest = k;
      sharp = both;
    }
    if (is_first) {
      std::size_t farthest = 1;
      for (std::size_t k = 2; k <= kRays; ++k) {
        if (distance_from_chord_of(chord, nodes[k]) >
            distance_from_chord_of(chord, nodes[farthest]))
          farthest = k;
      }
      const bool is_bent = distance_from_chord_of(chord, nodes[farthest]) > kStraight;
      chord.is_open = is_bent && sharp > kShareOfCorner * sum && is_corner(sharp);
      chord.is_found = is_bent && (chord.is_open || !chord.is_near);
      chord.corner = nodes[farthest];
      chord.turn = 0;
      if (!chord.is_open) return;
    }
    chord.turn = sharp;
    const bool has_arms = sharpest > 0 && sharpest + 2 < kNodes;
    const auto meeting = has_arms ? intersection(nodes[sharpest - 1], nodes[sharpest],
                                                 nodes[sharpest + 1], nodes[sharpest + 2])
                                  : std::nullopt;
    const double share = meeting ? share_of(chord, *meeting) : std::nan("");
    const double low = chord.shares[sharpest];
    const double high = chord.shares[sharpest + 1];
    const double corner = share >= low && share <= high ? share : 0.5 * (low + high);
    chord.corner =
        std::fabs(low - corner) < std::fabs(high - corner) ? nodes[sharpest] : nodes[sharpest + 1];
    // The bracket takes an arm on either side with it.
    set_bracket(sharpest > 0 ? sharpest - 1 : 0, std::min(sharpest + 2, kNodes - 1), corner, chord);
  }

  /// Narrows the bracket of a corner through which rays leave the sheet: it is where its arms meet.
  static void narrow_to_touch(SheetChord& chord) {
    const auto [first, last] = *chord.slipping;
    const auto& nodes = chord.nodes;
    chord.is_open = first >= 2 && last + 2 < kNodes;
    if (!chord.is_open) return;
    const auto meeting =
        intersection(nodes[first - 2], nodes[first - 1], nodes[last + 1], nodes[last + 2]);
    const double turn = std::fabs(
        turn_between(nodes[first - 1] - nodes[first - 2], nodes[last + 2] - nodes[last + 1]));
    // Arms that are nearly parallel meet far away.
    const double share = meeting && is_in_leaf(*meeting) ? share_of(chord, *meeting) : std::nan("");
    chord.is_open =
        share > chord.shares[first - 1] && share < chord.shares[last + 1] && is_bent(turn);
    if (!chord.is_open) return;
    chord.is_found = true;
    chord.touches = true;
    chord.corner = *meeting;
    chord.turn = turn;
    set_bracket(first - 2, last + 2, share, chord);
  }

  /// A place a little farther on the ray to a corner of the feature, in the leaf.
  static dvec2 beyond(const dvec2& from, const dvec2& corner) {
    if (glm::distance(from, corner) <= kNearly) return from;
    const dvec2 place = corner + kOvershoot * (corner - from);
    return is_in_leaf(place) ? place : border_of_square(from, corner - from);
  }

  /// A place on the ray to a corner of the feature, clearly before the corner.
  static dvec2 before(const dvec2& from, const dvec2& corner) {
    const double length = glm::distance(from, corner);
    return length > 2 * kNearly ? glm::mix(from, corner, 1 - 2 * kNearly / length) : from;
  }

  /// The parameters of a sheet's vertex at a corner of the feature, if the sheet reaches it.
  /// `last`: the sheet's last place on the ray beyond the corner; `inner`: on the ray that ends
  /// before().
  std::optional<dvec2> on_sheet(const SheetChord& chord, const dvec2& corner, const EdgePlace& last,
                                const EdgePlace& inner) {
    const bool starts_there = before(chord.from, corner) == chord.from;
    if (last.is_edge && glm::distance(last.place, corner) > kNearly) return std::nullopt;
    if (starts_there) return last.uv;
    if (inner.is_edge) return std::nullopt;
    // A sheet that touches the corner with its border goes on beyond, or another one does.
    if (!last.is_edge) {
      const bool touches = is_on_sheet_side(chord, corner) || chord.touches;
      return touches ? std::optional(inner.uv) : std::nullopt;
    }
    if (last.is_boundary) return last.uv;
    // Where several jumps meet, rounding may put the last place beyond one of them.
    tree_.effort().add_places(2);
    const auto points = evaluate(tree_.surface(), std::array{last.uv, inner.uv}, 1);
    const double apart = glm::distance(points[0].position, points[1].position);
    return apart <= delta_ ? last.uv : inner.uv;
  }

  /// All sheets whose edges meet in the corner of a leaf get a vertex there.
  std::vector<std::size_t> add_vertices() {
    std::vector<std::size_t> leaves;
    std::vector<Line> rays;
    std::vector<const SheetChord*> chords;
    std::vector<dvec2> corners;
    for_leaves_of(chords_, [&](std::span<const SheetChord> of_leaf) {
      const SheetChord* const main = main_chord(of_leaf);
      if (main == nullptr) return;
      for (const SheetChord& chord : of_leaf) {
        leaves.push_back(chord.leaf);
        rays.push_back({chord.from, beyond(chord.from, main->corner)});
        chords.push_back(&chord);
        corners.push_back(main->corner);
      }
    });
    const auto edges = edges_on(leaves, rays, kAllHalvings);
    for (std::size_t k = 0; k < chords.size(); ++k)
      rays[k][1] = before(chords[k]->from, corners[k]);
    const auto inner = edges_on(leaves, rays, kAllHalvings);
    std::vector<InnerPlace> places;
    std::vector<const SheetChord*> placed;
    for (std::size_t k = 0; k < chords.size(); ++k) {
      if (!edges[k] || !inner[k]) continue;
      const std::optional<dvec2> uv = on_sheet(*chords[k], corners[k], *edges[k], *inner[k]);
      if (!uv) continue;
      // Sheets that meet share the place.
      places.push_back({to_units(leaves[k], corners[k]), *uv});
      placed.push_back(chords[k]);
    }
    const std::uint32_t first = tree_.geometry().add_inside(places, limits_.threads);
    tree_.geometry().take_known_normals();
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < placed.size(); ++k) {
      const auto vertex = static_cast<std::uint32_t>(first + k);
      if (!tree_.geometry().is_defined(vertex)) continue;
      tree_.inner().add(mesh_.leaves[placed[k]->leaf], placed[k]->corners, vertex);
      if (result.empty() || result.back() != placed[k]->leaf) result.push_back(placed[k]->leaf);
    }
    return result;
  }

  const CellLimits& limits_;
  ValidatedMesh& mesh_;
  CellTree& tree_;
  double delta_ = std::numeric_limits<double>::infinity();
  std::vector<SheetChord> chords_;
};

}  // namespace

std::vector<std::size_t> solve_inner_vertices(std::span<const std::size_t> which,
                                              const CellLimits& limits, ValidatedMesh& mesh,
                                              CellTree& tree) {
  return which.empty() ? std::vector<std::size_t>() : Solver(which, limits, mesh, tree).run();
}

}  // namespace saddle
