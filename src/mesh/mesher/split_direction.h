// The direction in which a leaf that failed validation is halved: across its edge features, or the
// one with the larger error estimate, or the longer one.
#pragma once

#include <cstddef>

#include "mesh/error/error_indicator.h"
#include "mesh/error/validated_mesh.h"

namespace saddle {

class CellTree;
class Oscillation;

class SplitDirection {
 public:
  SplitDirection(const CellLimits& limits, const Grid& grid, const CellTree& tree,
                 const ValidatedMesh& mesh)
      : tree_(tree), mesh_(mesh), indicator_(limits, grid, tree) {}

  /// Whether to halve a leaf across u. `predicted`: where the surface oscillates.
  bool is_across_u(std::size_t leaf, const Oscillation& predicted) const;
  /// Whether the edge features of a leaf do not divide it into clear sub-polygons: more than one
  /// jump, or one that ends inside. A leaf with creases only is unclear if a sub-polygon is flat.
  bool is_cut_unclearly(std::size_t leaf) const;
  /// Whether triangles of a leaf lead from sheet to sheet: one is longer than a tolerance, and than
  /// all pieces of the surface around the leaf.
  bool joins_sheets(std::size_t leaf) const;
  /// ErrorIndicator::is_too_small_to_see().
  bool is_too_small_to_see(const Leaf& leaf) const { return indicator_.is_too_small_to_see(leaf); }

 private:
  bool is_halved_across_cuts(std::size_t leaf) const;
  bool has_singular_side(const SampleVertices& samples, std::size_t along) const;

  const CellTree& tree_;
  const ValidatedMesh& mesh_;
  ErrorIndicator indicator_;
};

}  // namespace saddle
