// Vertices of a cell tree by their dyadic points. Places are whole numbers, so that neighbouring
// cells share a vertex without comparing parameters.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "base/numbers.h"
#include "base/vec.h"
#include "mesh/tree/leaf.h"
#include "mesh/tree/place_map.h"
#include "mesh/tree/revision_clock.h"

namespace saddle {

/// Numbers vertices: those of the root grid first, then others in the order of their creation.
/// A vertex in use is a corner of leaves; others are samples, which can be forgotten: new vertices
/// take their numbers. Features of sides have vertices of their own, at places between two
/// neighbours that need not be dyadic.
class DyadicVertices {
 public:
  DyadicVertices(const Grid& grid, RevisionClock& revisions);

  std::size_t size() const { return used_.size(); }
  void reserve(std::size_t count);

  /// The parameters of a place; exact on the lines of the root grid.
  dvec2 parameters(DyadicPoint place) const;
  /// The sides of the box of parameters between two places, also where a range is reversed.
  dvec2 size(DyadicPoint low, DyadicPoint high) const {
    return glm::abs(parameters(high) - parameters(low));
  }

  /// The vertex at a place; creates it if there is none.
  std::uint32_t vertex(DyadicPoint place) {
    return is_on_grid(place) ? vertex_on_grid(place) : vertex_off_grid(place);
  }
  /// The vertex at a place, if it is in use.
  std::optional<std::uint32_t> used_vertex(DyadicPoint place) const {
    const std::optional<std::uint32_t> vertex = known_vertex(place);
    return vertex && is_used(*vertex) ? vertex : std::nullopt;
  }
  /// The vertices that vertex() created since the last call.
  std::vector<std::uint32_t> take_new() { return std::exchange(new_, {}); }
  /// Whether vertex() created any since.
  bool has_new() const { return !new_.empty(); }
  /// Whether a vertex is a sample that forget() takes: it is neither in use nor on a grid, and
  /// nothing is known of sides that end at it.
  bool can_forget(std::uint32_t vertex) const {
    return vertex >= first_forgettable_ && !is_used(vertex) && !is_on_feature(vertex) &&
           !is_beside_feature(vertex) && beside_middle_[vertex] == 0;
  }
  /// Forgets a vertex. No leaf has its number.
  void forget(std::uint32_t vertex);
  /// The vertex of the root grid at a place on it.
  std::uint32_t vertex_on_grid(DyadicPoint place) const {
    const SubGrid& grid =
        sub_grids_[(place.u & kHalfUnit) / kHalfUnit + (place.v & kHalfUnit) / kHalfUnit * 2];
    return grid.first + place.v / kCellUnit * grid.pitch + place.u / kCellUnit;
  }

  /// Parameters of a grid, v outer.
  struct Lines {
    std::vector<double> u, v;
  };
  static constexpr std::size_t kSubGrids = 4;
  /// Creates the vertices of a sub-grid, row by row: 1, the middles of the root cells' sides along
  /// u; 2, along v; 3, the middles of the cells. All three are created before any other vertex.
  Lines add_sub_grid(std::size_t kind);
  /// Creates a vertex between neighbours, at a place in units that need not be whole.
  std::uint32_t add_between(const dvec2& place);
  /// Moves a vertex between neighbours to the place of another.
  void share_place(std::uint32_t from, std::uint32_t to);

  /// Whether a corner of the mesh is a vertex on a feature, between neighbours or inside of a leaf.
  /// Corners that leaves have at singular vertices are none.
  bool is_on_feature(std::uint32_t corner) const {
    return corner < size() && place(corner).v == kNoIndex;
  }
  /// The place of a vertex that is not between neighbours.
  DyadicPoint place(std::uint32_t vertex) const;
  /// The place of any vertex, in units that need not be whole.
  dvec2 place_between(std::uint32_t vertex) const;

  bool is_used(std::uint32_t vertex) const { return used_[vertex] != 0; }
  std::size_t used_count() const { return used_count_; }
  void use(std::uint32_t vertex);
  /// Takes the middle of a side between corners into use. False if it was.
  bool use_middle(std::uint32_t from, std::uint32_t middle, std::uint32_t to);
  /// The vertices that went into use since the last call, ascending.
  std::vector<std::uint32_t> take_newly_used();

  /// Marks a vertex at which a side ends that has a feature.
  void mark_beside_feature(std::uint32_t vertex) { beside_feature_[vertex] = 1; }
  bool is_beside_feature(std::uint32_t vertex) const { return beside_feature_[vertex] != 0; }

  /// Calls f(vertex, place) for the vertices in use from `from` to `to`, without `to`. Both are on
  /// one line of the root grid and are neighbouring vertices of it.
  template <class F>
  void walk(DyadicPoint from, DyadicPoint to, F f) const {
    f(vertex_on_grid(from), from);
    walk_between(from, to, f);
  }
  /// The same on side k of a leaf whose samples are known, from its corner k.
  template <class F>
  void walk(const Leaf& leaf, std::size_t k, F f) const {
    const auto corners = leaf.corners();
    const DyadicPoint from = corners[k];
    const DyadicPoint to = corners[(k + 1) % 4];
    f(leaf.samples.corner[k], from);
    const std::uint32_t middle = hanging_middle(leaf, k);
    if (middle != kNoIndex) walk_by(middle, from, middle_of(from, to), to, f);
  }
  /// Whether side k of a leaf has hanging vertices.
  bool is_halved(const Leaf& leaf, std::size_t k) const {
    return hanging_middle(leaf, k) != kNoIndex;
  }

 private:
  static DyadicPoint middle_of(DyadicPoint from, DyadicPoint to) {
    return {static_cast<std::uint32_t>((std::uint64_t{from.u} + to.u) / 2),
            static_cast<std::uint32_t>((std::uint64_t{from.v} + to.v) / 2)};
  }
  /// The vertex in the middle of side k of a leaf, if it is in use; else kNoIndex.
  std::uint32_t hanging_middle(const Leaf& leaf, std::size_t k) const {
    const std::uint32_t middle = leaf.samples.side[k];
    if (middle == SampleVertices::kUnasked) return forgotten_middle(leaf, k);
    const bool hangs = is_used(middle) && middle != leaf.samples.corner[k] &&
                       middle != leaf.samples.corner[(k + 1) % 4];
    return hangs ? middle : kNoIndex;
  }
  std::uint32_t forgotten_middle(const Leaf& leaf, std::size_t k) const;
  std::optional<std::uint32_t> middle_between(DyadicPoint from, DyadicPoint to) const {
    const DyadicPoint middle = middle_of(from, to);
    return middle == from || middle == to ? std::nullopt : used_vertex(middle);
  }
  /// Invariant: a side with hanging vertices has one in its middle, since all come from halving.
  template <class F>
  void walk_between(DyadicPoint from, DyadicPoint to, F& f) const {
    const auto vertex = middle_between(from, to);
    if (vertex) walk_by(*vertex, from, middle_of(from, to), to, f);
  }
  template <class F>
  void walk_by(std::uint32_t vertex, DyadicPoint from, DyadicPoint middle, DyadicPoint to,
               F& f) const {
    const bool has_more = beside_middle_[vertex] != 0;
    if (has_more) walk_between(from, middle, f);
    f(vertex, middle);
    if (has_more) walk_between(middle, to, f);
  }

  /// Whether a place is on the root grid or, once these exist, on a sub-grid.
  bool is_on_grid(DyadicPoint place) const { return ((place.u | place.v) & grid_mask_) == 0; }
  std::uint32_t vertex_off_grid(DyadicPoint place);
  std::optional<std::uint32_t> known_vertex(DyadicPoint place) const {
    if (is_on_grid(place)) return vertex_on_grid(place);
    const std::uint32_t* const number = numbers_.find(place);
    return number != nullptr ? std::optional(*number) : std::nullopt;
  }
  std::uint32_t add(DyadicPoint place);
  void mark_ends_of_side(DyadicPoint middle);
  void put_into_use(std::uint32_t vertex);

  /// Vertices in rows: the root grid, and three of middles.
  struct SubGrid {
    std::uint32_t first;
    std::uint32_t pitch;
  };
  static constexpr std::uint32_t kHalfUnit = kCellUnit / 2;

  const Grid& grid_;
  RevisionClock& revisions_;
  std::array<SubGrid, kSubGrids> sub_grids_ = {};  // root, middles along u, along v, of cells
  std::uint32_t grid_mask_ = kCellUnit - 1;        // bits of a place that is not on a grid
  PlaceMap numbers_;
  std::vector<DyadicPoint> places_;  // of vertices past the root grid's
  // Vertices between neighbours have kNoIndex in place of v, and their index here in place of u.
  std::vector<dvec2> places_between_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint8_t> beside_middle_;  // ends of a side whose middle went into use
  std::vector<std::uint8_t> beside_feature_;
  std::vector<std::uint32_t> newly_used_;
  std::vector<std::uint32_t> new_;
  std::vector<std::uint32_t> forgotten_;  // whose numbers are free
  std::size_t first_forgettable_;         // number of vertices on grids
  std::size_t used_count_;
};

}  // namespace saddle
