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

/// A leaf that is searched for the largest error.
struct SearchedLeaf {
  double error = 0;        ///< by validation, scaled
  bool has_moved = false;  ///< a corner has, since validation
  SearchedPart part;
  std::vector<dvec2> places;  ///< where its error was sampled
};

/// A search for the largest error against the whole mesh.
struct WholeMeshSearch {
  double tolerance;  ///< of the report
  const std::optional<Bounds>& clip;
  double share;  ///< of searches, as of one of many surfaces
  unsigned threads;
  std::function<const WholeMeshError&()> whole;  ///< called only if there is anything to measure
};

/// The largest error, scaled. `suspects`: leaves that validation found to be off, or whose corners
/// have moved since; each error is replaced only after its places were measured. `others`: leaves
/// whose samples may miss a feature that sticks out.
PlacedError largest_error(const Surface& surface, std::span<SearchedLeaf> suspects,
                          std::span<const SearchedPart> others, KnownHulls& hulls,
                          const WholeMeshSearch& how);

}  // namespace saddle
