// The errors that the report of an adaptive mesh tells.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/whole_mesh_error.h"
#include "mesh/mesher/mesh_request.h"
#include "mesh/model/mesh_report.h"
#include "mesh/proof/feature_search.h"
#include "mesh/tree/leaf_mesh.h"
#include "surface/surface.h"

namespace saddle {

class AdaptiveMesher;

/// A leaf, or a block of a grid's cells, that is searched for the largest error.
struct SearchedLeaf {
  double error = 0;  ///< by validation, scaled
  SearchedPart part;
  std::vector<dvec2> places;  ///< where its error was sampled
};

/// Which distances are searched: of the surface from the mesh, or of the mesh from the surface,
/// too.
enum class SearchFrom : std::uint8_t { Surface, Both };

/// The largest error by a search against the whole mesh, scaled. `suspects`: leaves that validation
/// found to be off; each error is replaced only after its places were measured. `others`: leaves
/// whose samples may miss a feature that sticks out. `tolerance`: of the report. `whole` is called
/// only if there is anything to measure.
PlacedError largest_error(const Surface& surface, std::span<SearchedLeaf> suspects,
                          std::span<const SearchedPart> others, double tolerance,
                          const std::optional<Bounds>& clip, unsigned threads, KnownHulls& hulls,
                          const std::function<const WholeMeshError&()>& whole, SearchFrom from);

/// Sets max_error, worst_place and max_normal_error. `triangles`: of all leaves. Validation knows
/// distances of a leaf from its own triangles; if one exceeds the tolerance, the largest is
/// searched for anew, against the whole mesh.
void report_errors(const Surface& surface, const MeshRequest& request, const AdaptiveMesher& mesher,
                   const LeafTriangles& triangles, MeshReport& report);

}  // namespace saddle
