// Distances between the edges of the mesh and of the surface's sheets, where the surface ends or
// jumps, and of the surface in leaves on the boundary that have no triangles.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/beyond_chords.h"
#include "mesh/distance/close_jump_distance.h"
#include "mesh/distance/edge_turns.h"
#include "mesh/distance/omitted_leaves.h"
#include "mesh/distance/strip_distance.h"
#include "mesh/features/sheet_ends.h"
#include "mesh/grid/grid.h"
#include "mesh/proof/continuity.h"
#include "mesh/tree/edge_table.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
class CellTriangles;

class BoundaryDistance {
 public:
  /// Errors outside of `clip` do not count.
  BoundaryDistance(const Surface& surface, const Grid& grid, const CellTree& tree,
                   const std::optional<Bounds>& clip, unsigned threads)
      : surface_(surface),
        grid_(grid),
        tree_(tree),
        clip_(clip),
        threads_(threads),
        strips_(surface, grid, tree, clip, threads),
        beyond_(surface, grid, clip, threads),
        close_jumps_(surface, grid, tree, threads),
        turns_(surface, grid, clip, threads),
        omitted_(surface, tree, clip, threads) {}

  /// Adds a leaf with its triangles, which must outlive this, and its tolerance. Skips leaves
  /// without a boundary or a jump, those that lead to a pole, and those with a boundary that cross
  /// the clip box elsewhere than beside a pole.
  void add(const Leaf& leaf, std::size_t number, std::span<const Triangle> triangles,
           double allowed);

  /// Distances at the leaves that were added; several for some.
  std::vector<LeafDistance> measure();

  std::size_t evaluations() const { return evaluations_; }
  /// Points and boxes in searches for the edges of sheets.
  std::size_t looks() const { return looks_; }

 private:
  /// A place on a chord of an edge, and where the edge is looked for.
  struct EdgeChord {
    std::size_t leaf;
    double allowed;                       ///< the leaf's tolerance
    std::span<const Triangle> triangles;  ///< of the leaf; none of a flat sheet
    Triangle own;                         ///< the one of the chord
    std::array<std::uint32_t, 2> ends;
    dvec2 middle;    ///< the place on the chord
    dvec2 opposite;  ///< a corner of the sheet's triangles across from the chord
    dvec2 across;    ///< on the leaf's border, straight from the place into the triangle
    dvec2 beyond;    ///< the same on the other side of the chord
    /// Where the way goes on in the next leaf, if no corner of the sheet is on the side between.
    std::optional<dvec2> outside;
    bool is_at_face;  ///< of a leaf that ends on the box beside a pole
    /// Whether only an edge beyond the chord counts, as the chord may leave the clip box. At a jump
    /// what is in the box counts.
    bool is_outward = false;
    bool is_at_cliff = false;
    bool is_at_slight_jump = false;
    /// The end of the chord above which the way across begins, if it is not straight.
    std::optional<std::uint32_t> aslant_from = {};
    bool is_beside_middle = false;  ///< looks for a corner: a rim that rounding moves has none
  };
  void add_across_face(const Leaf& leaf, std::size_t number, std::span<const Triangle> triangles,
                       double allowed);
  void add_chords(const Leaf& leaf, std::size_t number, std::span<const Triangle> triangles,
                  FeatureKind kind, double allowed);
  /// A side of a triangle, its corner across, and the way from that straight to the side.
  struct OuterSide {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t opposite;
    dvec2 outward;  ///< in sides of the leaf
  };
  std::vector<OuterSide> outer_chords(const Leaf& leaf, const Triangle& t,
                                      const CellTriangles& by_sides) const;
  dvec2 on_chord(const std::array<std::uint32_t, 2>& ends, double share) const;
  void add_omitted(const Leaf& leaf, std::size_t number, double allowed, bool is_at_jump);
  void add_bulges(const Leaf& leaf, std::size_t number, double allowed);
  void add_at_jump(const Leaf& leaf, std::size_t number, std::span<const Triangle> triangles,
                   double allowed);
  void add_flat_sheets(const Leaf& leaf, std::size_t number, double allowed);
  void add_edges_on_sides(const Leaf& leaf, std::size_t number, double allowed);
  std::optional<dvec2> outside_of(const Leaf& leaf, std::span<const Triangle> sheet,
                                  const dvec2& border, const dvec2& way) const;
  static bool is_beyond(const EdgeChord& chord, const dvec2& uv);
  double foot(std::uint32_t from, std::uint32_t to, const dvec3& above) const;
  std::vector<bool> are_seen(std::span<const dvec2> uv);
  std::vector<std::optional<dvec2>> first_seen(std::span<const std::array<dvec2, 2>> lines);
  double distance_aslant(const EdgeChord& chord, const dvec3& on_rim) const;
  std::vector<std::array<dvec2, 2>> ways_to_boundary(std::span<const SurfacePoint> at_middle);
  std::vector<dvec2> ends_of(std::span<const std::array<dvec2, 2>> ways) const;
  double distance_from_edge(const EdgeChord& chord, std::span<const Triangle> triangles,
                            const dvec2& uv, const SurfacePoint& point) const;
  void follow_outside(std::span<const std::array<dvec2, 2>> ways, std::vector<dvec2>& ends) const;
  std::vector<std::optional<SheetEnd>> ends_of_sheets();
  bool is_steep_end(const EdgeChord& chord, const SheetEnd& end, const dvec3& position) const;
  std::vector<SurfacePoint> evaluate_ends(std::vector<std::optional<SheetEnd>>& ends);
  bool has_slight_jump(const Leaf& leaf, double allowed) const;
  void check_at_faces(std::vector<std::optional<SheetEnd>>& ends);
  void end_at_jumps(std::span<const std::size_t> numbers, double least,
                    std::vector<std::optional<SheetEnd>>& ends);
  void end_at_cliffs(std::span<const std::size_t> numbers,
                     std::vector<std::optional<SheetEnd>>& ends);
  void measure_chords(std::vector<LeafDistance>& found);
  EdgeChord beside_middle(EdgeChord chord, double share) const;
  /// The distance of a rim from its chord.
  struct RimDistance {
    double distance = 0;
    bool is_rounded = false;  ///< the rim's last digits alone move it noticeably
  };
  std::vector<RimDistance> measure_places(std::vector<LeafDistance>& found);
  void measure_beyond_box(std::span<const SurfacePoint> at_middle,
                          std::vector<LeafDistance>& found);
  bool counts_before(const EdgeChord& chord, const dvec3& place) const;
  void measure_jumps(std::vector<LeafDistance>& found);

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  StripDistance strips_;
  BeyondChords beyond_;
  CloseJumpDistance close_jumps_;
  EdgeTurns turns_;
  OmittedLeaves omitted_;
  std::vector<EdgeChord> chords_;  ///< of boundaries
  std::vector<EdgeChord> jumps_;
  std::vector<LeafDistance> on_sides_;  ///< of edges on the sides of leaves with a jump
  double delta_ = std::numeric_limits<double>::infinity();  ///< a smaller gap is no jump
  std::size_t evaluations_ = 0;
  std::size_t looks_ = 0;
};

}  // namespace saddle
