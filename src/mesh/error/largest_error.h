// The largest error of a mesh, searched for against all of its triangles.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/distance/whole_mesh_error.h"
#include "mesh/model/placed_error.h"
#include "mesh/proof/feature_search.h"
#include "surface/surface.h"

namespace saddle {

/// A leaf that validation found to be off, or of which a corner has moved since.
struct SuspectLeaf {
  std::size_t leaf;        ///< its number
  double error = 0;        ///< by validation, scaled
  bool has_moved = false;  ///< a corner has
};

/// A search for the largest error against the whole mesh.
struct WholeMeshSearch {
  double tolerance;  ///< of the report
  const std::optional<Bounds>& clip;
  double share;  ///< of searches, as of one of many surfaces
  unsigned threads;
  std::function<SearchedPart(std::size_t leaf)> part;          ///< makes that of a leaf
  std::function<std::vector<dvec2>(std::size_t leaf)> places;  ///< where its error was sampled
  std::function<const WholeMeshError&()> whole;  ///< called once, if there is anything to measure
};

/// The largest error, scaled. The error of a suspect is replaced only after its places were
/// measured. `others`: leaves whose samples may miss a feature that sticks out.
PlacedError largest_error(const Surface& surface, std::span<SuspectLeaf> suspects,
                          std::span<const SearchedPart> others, KnownHulls& hulls,
                          const WholeMeshSearch& how);

}  // namespace saddle
