// Finds where the sides of leaves are cut: at the boundary of the surface, at jumps, poles and
// creases.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/bounds.h"
#include "mesh/model/seam.h"
#include "mesh/model/tolerance.h"
#include "mesh/tree/edge_table.h"

namespace saddle {

class CellTree;

struct TraceOptions {
  Tolerance tolerance;
  /// Whether poles are cut too. A leaf is cut away with its pole: only small ones may be.
  bool poles = false;
  unsigned threads = 0;
  /// What is outside of this box is not seen: where the surface goes to infinity at a boundary, it
  /// is followed to a face only.
  std::optional<Bounds> clip = {};
  /// The search ends where a mesh of so many has taken all the effort that it may; 0: it does not.
  std::size_t max_triangles = 0;
};

/// Looks at sides and files in the cell tree what is found. Those that are left where the search
/// ends count as not looked at.
void trace_features(std::span<const Side> sides, const TraceOptions& options, CellTree& tree);

/// The same but for creases. Sides that are continuous count as not looked at.
void find_jumps(std::span<const Side> sides, const TraceOptions& options, CellTree& tree);

/// Cuts sides that are known to lead to poles: EdgeTable::leads_to_pole().
void cut_poles(std::span<const Side> sides, const TraceOptions& options, CellTree& tree);

/// Looks for poles between the ends of sides and what cuts them there, a boundary, a jump or a
/// crease, and cuts the sides at those instead.
void find_poles_beside_cuts(std::span<const Side> sides, const TraceOptions& options,
                            CellTree& tree);

/// Appends the sides of a leaf that have not been looked at.
void append_unsearched(const Leaf& leaf, const CellTree& tree, std::vector<Side>& sides);
/// Puts sides in order, each once.
void sort_sides(std::vector<Side>& sides);

/// Looks at all sides of leaves that are on the boundary, or that a crossing leads into, so that
/// what is cut is cut through. Returns the numbers of the leaves that this has split.
std::vector<std::size_t> follow_features(const TraceOptions& options, std::span<Leaf> leaves,
                                         CellTree& tree);

/// Searches the sides on a seam whose partners across the seam carry a feature.
void trace_features_across_seams(const Seams& seams, const TraceOptions& options, const Grid& grid,
                                 CellTree& tree);

}  // namespace saddle
