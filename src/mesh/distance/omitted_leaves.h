// Distances of the surface from the mesh in leaves on a boundary that have no triangles.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "mesh/distance/strip_distance.h"
#include "mesh/tree/leaf.h"
#include "surface/surface.h"

namespace saddle {

class CellTree;

class OmittedLeaves {
 public:
  /// Places outside of `clip`, which must outlive this, have no distance.
  OmittedLeaves(const Surface& surface, const CellTree& tree, const std::optional<Bounds>& clip,
                unsigned threads)
      : surface_(surface), tree_(tree), clip_(clip), threads_(threads) {}

  /// `is_at_jump`: a line may end in the leaf, which is then larger than a leaf at a boundary, and
  /// is looked at in more places.
  void add(const Leaf& leaf, std::size_t number, bool is_at_jump);

  /// Leaves may be defined in places but not at their corners, as beside the point where a boundary
  /// touches the edge of the domain. The missing part is measured from the leaf's border, where
  /// neighbours are.
  std::vector<LeafDistance> measure();

  std::size_t evaluations() const { return places_.size(); }

 private:
  void add_place(const Leaf& leaf, std::size_t number, const dvec2& place);

  const Surface& surface_;
  const CellTree& tree_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  std::vector<std::size_t> leaves_;  ///< of each place
  std::vector<dvec2> places_;        ///< each with its projections on the leaf's border
};

}  // namespace saddle
