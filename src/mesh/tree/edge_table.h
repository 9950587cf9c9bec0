// Sides between neighbouring vertices of a cell tree, and the features found on them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/numbers.h"
#include "mesh/model/pair_table.h"
#include "mesh/proof/continuity.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/cell_marks.h"
#include "mesh/tree/dyadic_vertices.h"
#include "mesh/tree/revision_clock.h"

namespace saddle {

struct Mesh;

/// Two neighbouring vertices in use, the smaller number first.
using Side = std::array<std::uint32_t, 2>;

inline Side side_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The kind of discontinuity between two neighbours on a side of a leaf.
enum class FeatureKind : std::uint8_t {
  Boundary,   ///< one of them is not defined
  Jump,       ///< the surface jumps
  Pole,       ///< it goes to infinity
  Crease,     ///< its normal jumps
  Essential,  ///< one of them is a point without limit: PointSingularity::Kind::Essential
  Face,       ///< it leaves the clip box, on its way to infinity
  Cliff,      ///< it rises steeply along a few straight segments; it is continuous
};

/// Whether the mesh leaves out what is between such a feature and the corners of a leaf.
inline bool leaves_out(FeatureKind kind) {
  return kind == FeatureKind::Pole || kind == FeatureKind::Essential;
}

/// Where a side is cut: the last vertices on either side of the cut. At a boundary they are one
/// vertex. At a pole they are on the way to infinity, or where that leaves the clip box. At a
/// crease they are one point with two normals. At a cliff they are its foot and its head. Several
/// jumps of a side are one feature: between them are strips of other sheets.
struct EdgeFeature {
  FeatureKind kind;
  std::uint32_t first;  ///< the end of the side that vertices are counted from: either one
  std::uint32_t beside_first, beside_second;
  /// The numbers of the faces through which the surface leaves the clip box there, beside a pole.
  std::array<std::uint8_t, 2> exits = {};
  /// The first of two vertices for each strip between those beside the feature, in their order: of
  /// sheets between jumps, or of the segments of a cliff, each with normals of its own.
  std::uint32_t first_on_strips = kNoIndex;
  std::uint8_t strips = 0;

  /// Whether the surface goes on across it.
  bool is_continuous() const { return kind == FeatureKind::Crease || kind == FeatureKind::Cliff; }
  /// The two vertices of a strip, both counted from a neighbour.
  std::array<std::uint32_t, 2> on_strip(std::size_t strip, std::uint32_t neighbour) const {
    const auto from_first =
        static_cast<std::uint32_t>(neighbour == first ? strip : strips - 1 - strip);
    const std::uint32_t low = first_on_strips + 2 * from_first;
    return neighbour == first ? std::array{low, low + 1} : std::array{low + 1, low};
  }
  /// Calls f(before, after) with the vertices beside each jump, on the way from a neighbour.
  template <class F>
  void for_jumps(std::uint32_t neighbour, F f) const {
    std::uint32_t before = beside(neighbour);
    for (std::size_t k = 0; k < strips; ++k) {
      const auto [near, far] = on_strip(k, neighbour);
      f(before, near);
      before = far;
    }
    f(before, neighbour == first ? beside_second : beside_first);
  }
  std::uint32_t beside(std::uint32_t neighbour) const {
    return neighbour == first ? beside_first : beside_second;
  }
  int exit_beside(std::uint32_t neighbour) const { return exits[neighbour == first ? 0 : 1]; }
  /// Vertices of the mesh that the feature adds between the ends of its side.
  std::size_t count_new_vertices() const {
    if (leaves_out(kind)) return 0;
    return (beside_first == beside_second ? 1U : 2U) + 2U * strips;
  }
  /// Whether the surface ends here, with nothing beyond.
  bool is_boundary() const {
    return (kind == FeatureKind::Boundary || kind == FeatureKind::Face) &&
           beside_first == beside_second;
  }
};

/// The feature or the pole by which a side is cut.
struct EdgeCut {
  Side side;
  std::optional<EdgeFeature> feature;
  std::uint32_t pole = kNoIndex;               ///< number of the pole that the side leads to
  bool is_halved = false;                      ///< the vertices of `feature` do not count
  std::optional<dvec2> between_features = {};  ///< parameters; there are more than `feature`
};

/// The facts known of a side. Most sides have no cut, and there are millions of them.
struct EdgeFacts {
  std::uint32_t is_searched : 1 = 0;    ///< the cut's feature is what the search found
  std::uint32_t is_continuous : 1 = 0;  ///< positions are; normals need not be
  std::uint32_t is_proved : 1 = 0;      ///< no jump above the tolerance but in the cut's feature
  std::uint32_t cut : 29 = 0;           ///< its number, from 1; 0 for none
};

/// Searches for what most surfaces do not have, and waves all over.
struct SearchCount {
  std::size_t sought = 0;
  std::size_t found = 0;

  void count(std::size_t more_sought, std::size_t more_found) {
    sought += more_sought;
    found += more_found;
  }
  /// Whether enough was found: one in as many as `for_each`, after the first ones.
  bool may_be_found(std::size_t for_each) const;
};

/// The facts of all sides, in one hash table.
class EdgeTable {
 public:
  /// The last places before a pole, in parameters, the first nearer to the side's first end.
  using PoleEnds = std::array<dvec2, 2>;

  EdgeTable(const Grid& grid, DyadicVertices& vertices, RevisionClock& revisions, Effort& effort)
      : vertices_(vertices), revisions_(revisions), effort_(effort), crossed_cells_(grid) {}

  /// The feature of a side, if one has been found.
  std::optional<EdgeFeature> feature(std::uint32_t a, std::uint32_t b) const {
    return vertices_.is_beside_feature(a) && vertices_.is_beside_feature(b) ? find_feature(a, b)
                                                                            : std::nullopt;
  }
  /// The feature of a side, or the pole that it leads to, until a search files the next; null if
  /// there is neither.
  const EdgeCut* find_cut(std::uint32_t a, std::uint32_t b) const {
    const bool may_have_feature = vertices_.is_beside_feature(a) && vertices_.is_beside_feature(b);
    return may_have_feature || !poles_.empty() ? cut(a, b) : nullptr;
  }
  /// Whether a search for features has ended on a side.
  bool is_searched(std::uint32_t a, std::uint32_t b) const { return facts(a, b).is_searched != 0; }
  /// Files what a search found.
  void set_feature(std::uint32_t a, std::uint32_t b, std::optional<EdgeFeature> feature);

  /// Whether positions are known to be continuous along a side. Its normals need not be.
  bool is_continuous(std::uint32_t a, std::uint32_t b) const {
    return facts(a, b).is_continuous != 0;
  }
  void set_continuous(std::uint32_t a, std::uint32_t b) { facts_of(a, b).is_continuous = 1; }

  /// Files that bounds exclude jumps above the tolerance on a side but those of its feature.
  void set_proved(std::uint32_t a, std::uint32_t b) { facts_of(a, b).is_proved = 1; }
  /// Files for both parts of a side what is proved of the whole, so that they need no search. Its
  /// jumps go to the parts that they are in, unless one is at the vertex `middle`.
  void pass_on(std::uint32_t from, std::uint32_t middle, std::uint32_t to);

  /// Whether a side has more features than feature() tells.
  bool has_more(std::uint32_t a, std::uint32_t b) const {
    return between_features(a, b).has_value();
  }
  /// `between`: parameters between two of them.
  void set_has_more(std::uint32_t a, std::uint32_t b, const dvec2& between) {
    add_cut(a, b).between_features = between;
  }
  /// Parameters between two features of a side that has more than feature() tells.
  std::optional<dvec2> between_features(std::uint32_t a, std::uint32_t b) const {
    const EdgeCut* const found = cut(a, b);
    return found != nullptr ? found->between_features : std::nullopt;
  }

  /// Whether the surface is known to go to infinity across a side.
  bool leads_to_pole(std::uint32_t a, std::uint32_t b) const {
    const EdgeCut* const found = cut(a, b);
    return found != nullptr && found->pole != kNoIndex;
  }
  /// Keeps the first ends that are filed for a side.
  void set_leads_to_pole(std::uint32_t a, std::uint32_t b, const PoleEnds& ends);
  /// The ends of a side that leads to a pole.
  const PoleEnds& pole_between(std::uint32_t a, std::uint32_t b) const {
    return poles_[cut(a, b)->pole];
  }
  /// Files a pole beyond a FeatureKind::Face.
  void add_pole_beyond_face(const PoleEnds& ends) { poles_beyond_faces_.push_back(ends); }
  bool has_poles() const { return has_pole_features_ || !poles_.empty(); }
  bool has_jumps() const { return has_jumps_; }
  /// The ends of all poles, found or cut, in the order in which they were found.
  std::vector<PoleEnds> poles(const Mesh& mesh) const;

  /// Edges of the domain join: a cliff that crosses one would need the same ends on both.
  void set_has_seams() { has_seams_ = true; }
  bool has_seams() const { return has_seams_; }

  /// Counts sides on which cliffs were looked for, and cliffs found there.
  void count_cliffs(std::size_t sought, std::size_t found) { cliffs_.count(sought, found); }
  bool has_cliffs() const { return cliffs_.found > 0; }
  /// Whether so many were found that it is worth to look for more.
  bool may_have_cliffs() const { return cliffs_.may_be_found(kSoughtForCliff); }
  /// The same for sides on which all jumps were looked for, and those that have a few.
  void count_few_jumps(std::size_t sought, std::size_t found) { few_jumps_.count(sought, found); }
  bool may_have_few_jumps() const { return few_jumps_.may_be_found(kSoughtForFewJumps); }

  /// The patience of searches for creases with proofs that there is none.
  Patience& patience() { return patience_; }

  bool has_features() const { return has_features_; }
  /// Whether a feature may cut a leaf: one cuts its root cell.
  bool may_be_crossed(const Leaf& leaf) const {
    return has_features_ && crossed_cells_.contains(leaf);
  }
  /// The sides with a feature, in the order in which they were found.
  std::vector<Side> sides_with_features() const;

  /// Vertices that features add to sides which are not halved.
  std::size_t vertex_count() const { return vertex_count_; }
  /// A side is halved: features of its halves take the place of its own.
  void discount_feature(std::uint32_t a, std::uint32_t b);

 private:
  /// Searches for each that is not in vain. Searches for all jumps of a side take the longest.
  static constexpr std::size_t kSoughtForCliff = 64;
  static constexpr std::size_t kSoughtForFewJumps = 4;

  EdgeFacts facts(std::uint32_t a, std::uint32_t b) const {
    return facts_.find(pair_of(a, b)).value_or(EdgeFacts{});
  }
  EdgeFacts& facts_of(std::uint32_t a, std::uint32_t b) { return facts_[pair_of(a, b)]; }
  const EdgeCut* cut_of(const EdgeFacts& facts) const {
    return facts.cut == 0 ? nullptr : &cuts_[facts.cut - 1];
  }
  const EdgeCut* cut(std::uint32_t a, std::uint32_t b) const { return cut_of(facts(a, b)); }
  EdgeCut& add_cut(std::uint32_t a, std::uint32_t b);
  void pass_on_part(std::uint32_t a, std::uint32_t b, const std::optional<EdgeFeature>& jumps);
  std::optional<EdgeFeature> find_feature(std::uint32_t a, std::uint32_t b) const;

  DyadicVertices& vertices_;
  RevisionClock& revisions_;
  Effort& effort_;
  PairMap<EdgeFacts> facts_;
  std::vector<EdgeCut> cuts_;    // in the order in which they were found
  std::vector<PoleEnds> poles_;  // of sides that lead to poles
  std::vector<PoleEnds> poles_beyond_faces_;
  CellMarks crossed_cells_;
  std::size_t vertex_count_ = 0;
  SearchCount cliffs_;
  SearchCount few_jumps_;
  Patience patience_;
  bool has_features_ = false;
  bool has_seams_ = false;
  bool has_pole_features_ = false;
  bool has_jumps_ = false;
};

}  // namespace saddle
