// Proves by interval bounds that the triangles of a mesh are near the surface between the samples,
// too: from boxes of parameters with the tolerance of their triangles (patches) to unproved boxes
// and proof gaps. It is a branch and bound: a box without a proof is halved until the budget ends.
// Source: D. Filip, R. Magedson, R. Markot, "Surface algorithms using bounds on derivatives", 1986;
// J. Snyder, "Interval analysis for computer graphics", 1992.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/model/proof_gap.h"
#include "mesh/proof/bounded_box.h"
#include "mesh/proof/proof_budget.h"
#include "mesh/proof/root_cells.h"
#include "mesh/proof/unproved_parts.h"
#include "surface/box_subdivision.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// Measures points of bounded boxes. Proved: the surface in the box is within kProofFactor
/// tolerances of the triangles of its patch. Refuted: a point is off by more than the tolerance.
using MeasureBoxes = std::function<std::vector<ProofOutcome>(std::span<const BoundedBox>)>;

/// How a proof goes on with boxes that its bounds alone do not decide.
struct BoxHandlers {
  MeasureBoxes measure;
  TakeUnproved take_unproved;
  unsigned threads = 0;  ///< that compute bounds
};

struct Certification {
  std::vector<GapBox> proof_gaps;    ///< disjoint; empty: all patches are proved
  std::vector<std::uint8_t> proved;  ///< 1 for each patch that is
  /// 1 for each patch with boxes that are measured without second derivatives: they may hold tips.
  std::vector<std::uint8_t> rough;
  double bound = 0;  ///< on the distance of what is proved, in units of length
};

/// Bounds the distance of r(u, v) from the triangles of each patch, of sides h and k, by
/// (h^2 |r_uu| + 2 h k |r_uv| + k^2 |r_vv|) / 8, over boxes in which r is proved to be defined and
/// its first derivatives continuous. Boxes of many root cells come first, then patches, then parts
/// of patches, for which `handlers.measure` adds the distance of their corners. Boxes without a
/// proof when the budget ends are unproved. The surface outside of `clip` needs none.
Certification certify(const Surface& surface, const RootLines& root, const Patches& patches,
                      const std::optional<Bounds>& clip, const BoxHandlers& handlers,
                      ProofBudget& budget);

}  // namespace saddle
