// Leaves without a proof, in which bounds leave room for features that samples miss: thin ridges,
// grooves and needles.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validated_mesh.h"
#include "mesh/grid/grid.h"
#include "mesh/model/counterexample.h"
#include "mesh/proof/feature_search.h"

namespace saddle {

class CellTree;

/// A leaf as a part that features stick out of.
SearchedPart part_of(const ValidatedMesh& mesh, std::size_t leaf,
                     std::span<const Triangle> triangles, const Grid& grid, const CellTree& tree);

class OpenLeaves {
 public:
  OpenLeaves(const Surface& surface, const Grid& grid, const CellTree& tree, KnownHulls& hulls,
             const std::optional<Bounds>& clip, unsigned threads);

  /// Looks for features in the leaves of a mesh for which `is_open`, once in each, and adds their
  /// distances to the sampled errors. Returns them as counterexamples, whose cells are indices of
  /// leaves; none from the time on that they ask for too many leaves. Several threads call
  /// is_open() at the same time.
  std::vector<Counterexample> refute(const std::function<bool(std::size_t leaf)>& is_open,
                                     ValidatedMesh& mesh);

 private:
  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  KnownHulls& hulls_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  std::size_t left_;       // leaves that may still be searched
  bool gives_up_ = false;  // features are told only
};

}  // namespace saddle
