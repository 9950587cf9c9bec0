// The vertices of a grid that is refined here and there: every place has whole coordinates, so that
// neighbours agree on what they share without comparing numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "mesh/features/point_singularities.h"
#include "mesh/features/removable.h"
#include "mesh/grid/grid.h"
#include "mesh/model/pair_table.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/cell_marks.h"
#include "mesh/tree/leaf.h"
#include "mesh/tree/place_map.h"

namespace saddle {

/// What is between two neighbours on a side of a leaf.
enum class FeatureKind : std::uint8_t {
  Boundary,   ///< one of them is not defined
  Jump,       ///< the surface jumps
  Pole,       ///< it goes to infinity
  Crease,     ///< its normal jumps
  Essential,  ///< one of them is a point that has no limit: PointSingularity::Kind::NoLimit
  Face,       ///< it leaves the clip box, on its way to infinity
};

/// Whether what is between such a cut and the corners of a leaf is left out with it.
inline bool leaves_out(FeatureKind kind) {
  return kind == FeatureKind::Pole || kind == FeatureKind::Essential;
}

/// Where a side is cut, and the last vertices on either side of the cut. At a boundary they are
/// one; at a pole they are on the way to infinity, or where that leaves the box; at a crease they
/// are one point, and differ in their normals.
struct EdgeFeature {
  FeatureKind kind;
  std::uint32_t first;  ///< the neighbour with the smaller number
  std::uint32_t beside_first, beside_second;

  std::uint32_t beside(std::uint32_t neighbour) const {
    return neighbour == first ? beside_first : beside_second;
  }
  /// Vertices of the mesh that a side has for it beside its ends.
  std::size_t count_new_vertices() const {
    if (leaves_out(kind)) return 0;
    return beside_first == beside_second ? 1 : 2;
  }
  /// Whether the surface ends here, with nothing beyond.
  bool is_boundary() const {
    return (kind == FeatureKind::Boundary || kind == FeatureKind::Face) &&
           beside_first == beside_second;
  }
};

/// A place between two vertices.
struct Between {
  std::uint32_t a, b;
  dvec2 uv;
};

/// Vertices of the root grid and between its lines. Their positions and normals are grid.mesh's.
class CellTree {
 public:
  CellTree(const Surface& surface, Grid& grid, unsigned threads);

  /// Numbers and computes the middles of the root grid's cells and of their sides, which are grids
  /// of their own: at a fraction of the cost of as many places one by one.
  void add_middles(unsigned threads);

  /// Parameters of a place; exact on the lines of the root grid.
  dvec2 parameters(DyadicPoint place) const;

  /// The vertex at a place; a new one has its position after the next evaluate().
  std::uint32_t vertex(DyadicPoint place) {
    return is_on_grid(place) ? vertex_on_grid(place) : vertex_off_grid(place);
  }
  /// The same in the midst of a leaf that asks for it for the first time: nobody else can have, nor
  /// will look for it there, since what the leaf is cut into is told its number.
  std::uint32_t vertex_inside(DyadicPoint place) {
    return is_on_grid(place) ? vertex_on_grid(place) : number(place);
  }
  /// The vertex at a place, if it is in use.
  std::optional<std::uint32_t> used_vertex(DyadicPoint place) const {
    const std::optional<std::uint32_t> vertex = known_vertex(place);
    return vertex && is_used(*vertex) ? vertex : std::nullopt;
  }

  /// Computes the new vertices. Where a position is not defined but all around it agree on what it
  /// should be, as sin(u)/u does at 0, it is that.
  void evaluate(unsigned threads);
  std::size_t evaluations() const { return evaluations_; }

  /// A vertex in use is a corner of leaves; others are samples.
  bool is_used(std::uint32_t vertex) const { return used_[vertex] != 0; }
  void use(std::uint32_t vertex);
  /// The same with the middle of the k-th side of a leaf.
  void use_middle(const Leaf& leaf, std::size_t k);
  /// Whether one more halving, which takes up to two vertices into use, could make more triangles
  /// than are allowed: a mesh has fewer than twice as many as vertices (Euler), and one for each of
  /// those along which it is cut.
  bool has_many(std::size_t triangles) const {
    return 2 * (used_count_ + 2) + between_count_ > triangles;
  }
  /// The same, or that all the effort was made that is worth so many.
  bool is_full(std::size_t max_triangles) const {
    return has_many(max_triangles) || budget_spent(max_triangles);
  }
  /// Only the latter.
  bool budget_spent(std::size_t max_triangles) const {
    return effort_.total() > most_effort(max_triangles);
  }
  /// What the mesh took so far. Who looks at the surface for it otherwise than through the cell
  /// tree adds to that.
  Effort& effort() { return effort_; }
  const Effort& effort() const { return effort_; }

  /// Whether the position is finite.
  bool is_defined(std::uint32_t vertex) const { return defined_[vertex] != 0; }

  /// What there is around a vertex at which the surface is not defined.
  PointSingularity::Kind singularity(std::uint32_t vertex) const {
    const auto found = singularities_.find(vertex);
    return found == singularities_.end() ? PointSingularity::Kind::Part : found->second.kind;
  }
  /// Those that are no parts of the domain, by their vertices.
  const std::map<std::uint32_t, PointSingularity>& singularities() const { return singularities_; }

  /// Where the side between two neighbours is cut, if that has been found.
  std::optional<EdgeFeature> feature(std::uint32_t a, std::uint32_t b) const {
    return beside_cut_[a] != 0 && beside_cut_[b] != 0 ? find_feature(a, b) : std::nullopt;
  }
  /// Whether it has been looked for.
  bool is_searched(std::uint32_t a, std::uint32_t b) const {
    return sides_.contains(pair_of(a, b));
  }
  /// Whether positions are known to be continuous on it. Its normals need not be.
  bool is_continuous(std::uint32_t a, std::uint32_t b) const {
    return continuous_sides_.contains(pair_of(a, b));
  }
  void set_continuous(std::uint32_t a, std::uint32_t b) { continuous_sides_.insert(pair_of(a, b)); }
  /// Files what was found, or that nothing was.
  void set_feature(std::uint32_t a, std::uint32_t b, std::optional<EdgeFeature> feature);
  /// A side across which the surface goes to infinity, and that is not cut yet.
  bool leads_to_pole(std::uint32_t a, std::uint32_t b) const {
    return pole_sides_.contains(pair_of(a, b));
  }
  /// `ends`: the neighbours of the pole in double precision, the first the one nearer to the side's
  /// end with the smaller number.
  void set_leads_to_pole(std::uint32_t a, std::uint32_t b, const std::array<dvec2, 2>& ends) {
    const auto [at, is_new] =
        pole_sides_.insert(pair_of(a, b), static_cast<std::uint32_t>(pole_ends_.size()));
    if (!is_new) return;
    pole_ends_.push_back(ends);
    effort_.add_discontinuities(1);
  }
  /// Those ends; for a side that leads to a pole.
  const std::array<dvec2, 2>& pole_between(std::uint32_t a, std::uint32_t b) const {
    return pole_ends_[*pole_sides_.find(pair_of(a, b))];
  }
  /// A side that is cut in more places than its crossing tells.
  bool has_more(std::uint32_t a, std::uint32_t b) const {
    return crowded_sides_.contains(pair_of(a, b));
  }
  void set_has_more(std::uint32_t a, std::uint32_t b) { crowded_sides_.insert(pair_of(a, b)); }
  /// Files a pole that is beyond a FeatureKind::Face.
  void add_pole_beyond_face(const std::array<dvec2, 2>& ends) {
    poles_beyond_faces_.push_back(ends);
  }
  /// Whether the surface is known to go to infinity somewhere.
  bool has_poles() const { return has_poles_ || !pole_ends_.empty(); }
  /// The ends, in parameters, of what is known to lead to poles or was cut there, in an order that
  /// is always the same.
  std::vector<std::array<dvec2, 2>> poles() const;
  bool has_features() const { return has_features_; }
  /// The sides that are cut, by their ends, in the order in which they were searched.
  std::vector<std::array<std::uint32_t, 2>> sides_with_features() const;
  /// New vertices between neighbours, with consecutive numbers; the number of the first. All others
  /// that are numbered have been evaluated.
  std::uint32_t add_between(std::span<const Between> places, unsigned threads);
  /// Gives new vertices at which tangents are as good as parallel, and that have no normal yet,
  /// those that are known. To be called after add_between() and what sets limits there.
  void take_known_normals();
  /// Makes the new vertex `to` one point with another, at its position.
  void join(std::uint32_t from, std::uint32_t to);
  /// Gives a vertex between neighbours, a few digits from another one, the same place.
  void share_place(std::uint32_t from, std::uint32_t to);

  /// Whether there is a direction of r_u x r_v.
  bool is_regular(std::uint32_t vertex) const { return regular_[vertex] != 0; }
  bool has_singular() const { return std::ranges::find(regular_, 0) != regular_.end(); }
  /// The root cells around vertices that are not regular, and some of those that were not.
  const CellMarks& singular_cells() const { return singular_cells_; }
  /// Gives a vertex of one side of the surface the limit of the normals there.
  void set_normal(std::uint32_t vertex, const dvec3& normal) {
    grid_.mesh.normal[vertex] = normal;
    regular_[vertex] = 1;
  }

  void make_singular(std::uint32_t vertex) {
    if (!is_regular(vertex)) return;
    regular_[vertex] = 0;
    const dvec2 place = place_between(vertex);
    singular_cells_.add(place);
    changed_cells_.add(place, now_);
  }

  /// The place of a vertex that is not between neighbours.
  DyadicPoint place(std::uint32_t vertex) const;
  /// The same of any vertex, in units that need not be whole.
  dvec2 place_between(std::uint32_t vertex) const;
  std::size_t size() const { return used_.size(); }

  const Surface& surface() const { return surface_; }
  const Mesh& mesh() const { return grid_.mesh; }

  /// The vertices that have gone into use since this was last asked, in the order of their numbers.
  std::vector<std::uint32_t> take_newly_used();
  /// Tells that a vertex has become one point with others.
  void mark_changed(std::uint32_t vertex) { changed_cells_.add(place_between(vertex), now_); }
  /// Whether vertices around a leaf may have gone into use, have become one point with others or
  /// singular, or its sides been cut, since a moment.
  bool has_changed(const Leaf& leaf, std::uint32_t since) const {
    return changed_cells_.of(leaf) >= since;
  }
  /// Counts on: changes from here on are later than those before.
  std::uint32_t next_revision() { return ++now_; }

  /// Whether something may cut a leaf: it cuts a side of the leaf's root cell, or within it.
  bool may_be_crossed(const Leaf& leaf) const {
    return has_features_ && crossed_cells_.contains(leaf);
  }

  /// Calls f(vertex, place) for the vertices in use on the straight way from line to line of the
  /// root grid, along a third one; `to` is not included.
  template <class F>
  void walk(DyadicPoint from, DyadicPoint to, F f) const {
    f(vertex_on_grid(from), from);
    walk_between(from, to, f);
  }
  /// The same on the k-th side of a leaf whose samples are known, from its corner k.
  template <class F>
  void walk(const Leaf& leaf, std::size_t k, F f) const {
    const auto corners = leaf.corners();
    const DyadicPoint from = corners[k];
    const DyadicPoint to = corners[(k + 1) % 4];
    f(leaf.samples.corner[k], from);
    if (!is_halved(leaf, k)) return;
    walk_by(leaf.samples.side[k], from, middle_of(from, to), to, f);
  }
  /// Whether there are vertices in use on the k-th side of a leaf, between its corners.
  bool is_halved(const Leaf& leaf, std::size_t k) const {
    const auto& [corner, side, centre] = leaf.samples;
    return is_used(side[k]) && side[k] != corner[k] && side[k] != corner[(k + 1) % 4];
  }

 private:
  static DyadicPoint middle_of(DyadicPoint from, DyadicPoint to) {
    return {static_cast<std::uint32_t>((std::uint64_t{from.u} + to.u) / 2),
            static_cast<std::uint32_t>((std::uint64_t{from.v} + to.v) / 2)};
  }
  /// A side that has vertices in use has one in its middle: all come from halving.
  template <class F>
  void walk_between(DyadicPoint from, DyadicPoint to, F& f) const {
    const DyadicPoint middle = middle_of(from, to);
    if (middle == from || middle == to) return;
    const auto vertex = used_vertex(middle);
    if (vertex) walk_by(*vertex, from, middle, to, f);
  }
  template <class F>
  void walk_by(std::uint32_t vertex, DyadicPoint from, DyadicPoint middle, DyadicPoint to,
               F& f) const {
    const bool has_more = beside_middle_[vertex] != 0;
    if (has_more) walk_between(from, middle, f);
    f(vertex, middle);
    if (has_more) walk_between(middle, to, f);
  }

  /// Whether it is on the root grid or, once those are numbered, one of its middles.
  bool is_on_grid(DyadicPoint place) const { return ((place.u | place.v) & grid_mask_) == 0; }
  std::uint32_t vertex_on_grid(DyadicPoint place) const {
    const SubGrid& grid =
        sub_grids_[(place.u & kHalfUnit) / kHalfUnit + (place.v & kHalfUnit) / kHalfUnit * 2];
    return grid.first + place.v / kCellUnit * grid.pitch + place.u / kCellUnit;
  }
  std::uint32_t vertex_off_grid(DyadicPoint place);
  /// The vertex at a place, if it has a number.
  std::optional<std::uint32_t> known_vertex(DyadicPoint place) const {
    if (is_on_grid(place)) return vertex_on_grid(place);
    const std::uint32_t* const number = numbers_.find(place);
    return number != nullptr ? std::optional(*number) : std::nullopt;
  }
  void put_into_use(std::uint32_t vertex);
  void mark_ends_of_side(DyadicPoint middle);
  std::optional<EdgeFeature> find_feature(std::uint32_t a, std::uint32_t b) const;
  /// Appends the surface at (u[i], v[i]) to the mesh.
  void append(const std::vector<double>& u, const std::vector<double>& v, unsigned threads);
  /// The same on a grid, v outer.
  void append_grid(const std::vector<double>& u, const std::vector<double>& v, unsigned threads);
  /// Appends what was computed at uv(i), whose vertices have their numbers.
  template <class Function>
  void append(const NormalColumns& columns, std::size_t count, Function uv);
  /// Makes room for so many vertices.
  void reserve(std::size_t count);
  /// The number of a new vertex that is no corner of leaves yet.
  std::uint32_t number(DyadicPoint place);
  /// Joins the vertices that are computed last to poles, and gives them limits.
  void finish_new(unsigned threads);
  void fill_removable(std::span<const std::uint32_t> undefined, unsigned threads);
  /// Files the vertices whose positions are rounding: is_rounding().
  void note_rounding(std::span<const std::size_t> vertices, std::span<const SurfacePoint> points);
  void replace_rounding(unsigned threads);
  std::vector<Beside> look_beside(std::span<const std::uint32_t> vertices, unsigned threads);
  /// Gives a vertex the limit of the positions around it.
  void fill(std::uint32_t vertex, const dvec3& limit);
  void find_point_singularities(std::span<const std::uint32_t> vertices, unsigned threads);
  /// A vertex between two root vertices that are one point, on the grid's line through them, is
  /// that point: its tangent along the line is rounding.
  void join_pole(std::uint32_t vertex);

  /// A side, by its ends, the smaller number first, and what was found on it.
  struct SearchedSide {
    std::array<std::uint32_t, 2> side;
    std::optional<EdgeFeature> feature;
  };

  /// Vertices in rows: the root grid, and three of middles.
  struct SubGrid {
    std::uint32_t first;
    std::uint32_t pitch;
  };
  static constexpr std::uint32_t kHalfUnit = kCellUnit / 2;
  /// In place of v of a vertex between neighbours; u is then its number among those.
  static constexpr std::uint32_t kBetween = ~std::uint32_t{0};

  const Surface& surface_;
  Grid& grid_;
  std::array<SubGrid, 4> sub_grids_ = {};    ///< root, middles along u, along v, of cells
  std::uint32_t grid_mask_ = kCellUnit - 1;  ///< bits of a place that is not on a grid
  PlaceMap numbers_;
  std::vector<DyadicPoint> places_;  // of vertices past the root grid's
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> newly_used_;
  std::vector<std::uint8_t> regular_;
  std::vector<std::uint8_t> defined_;
  std::vector<std::uint32_t> rounded_;  ///< whose positions are rounding, and not replaced yet
  PairTable sides_;  // that were searched: by their ends, their places in the next
  std::vector<SearchedSide> searched_;
  std::vector<std::uint8_t> beside_cut_;     ///< of vertices: whether a side that ends there is cut
  std::vector<std::uint8_t> beside_middle_;  ///< or was one whose middle is in use
  std::vector<dvec2> places_between_;
  std::map<std::uint32_t, PointSingularity> singularities_;
  PairTable pole_sides_;  // their places in the next
  std::vector<std::array<dvec2, 2>> pole_ends_;
  std::vector<std::array<dvec2, 2>> poles_beyond_faces_;
  PairTable crowded_sides_;
  PairTable continuous_sides_;
  bool has_features_ = false;
  bool has_poles_ = false;  // among crossings and holes
  CellMarks crossed_cells_;
  CellMarks singular_cells_;
  CellMarks changed_cells_;  // when
  std::uint32_t now_ = 1;
  std::size_t used_count_;
  std::size_t between_count_ = 0;   // vertices that cut sides which are not halved
  std::size_t evaluated_;           // vertices that have been computed
  std::vector<std::size_t> steep_;  // of those, new ones of which tangents tell no normal
  std::size_t evaluations_ = 0;
  Effort effort_;
};

}  // namespace saddle
