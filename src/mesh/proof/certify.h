// Proves by interval bounds that the triangles of a mesh are near the surface between the samples,
// too: from boxes of parameters with the tolerance of their triangles (patches) to unproved boxes
// and proof gaps. It is a branch and bound: a box without a proof is halved until the budget ends.
// Source: D. Filip, R. Magedson, R. Markot, "Surface algorithms using bounds on derivatives", 1986;
// J. Snyder, "Interval analysis for computer graphics", 1992.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/model/proof_gap.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// The proof is for 8 times the tolerance: bounds of derivatives are wider than the derivatives,
/// and count derivatives along the surface, which make no error. Samples check finer errors.
inline constexpr double kProofFactor = 8;

/// A box of parameters and what its triangles must keep.
struct Patch {
  ParameterBox box;
  double allowed;                   ///< distance from the surface, in units of length
  std::size_t root_cell;            ///< number of the root cell that holds the box; u is inner
  std::optional<GapReason> cut_by;  ///< feature in the box: no proof is tried
};

/// A box of parameters without a proof, a part of a patch.
struct UnprovedBox {
  std::size_t patch;
  dvec2 middle;
  dvec2 size;
  dvec2 bend;                 ///< bounds of |r_uu| and |r_vv|
  bool is_undefined = false;  ///< proved: the surface is defined nowhere in the box
  bool may_jump = false;      ///< bounds do not exclude that the surface jumps in the box
};

struct Certification {
  std::vector<UnprovedBox> unproved_boxes;
  std::vector<ProofGap> proof_gaps;  ///< disjoint; empty: all patches are proved
  double bound = 0;                  ///< on the distance of what is proved, in units of length
};

/// The number of boxes that may still be tested.
struct ProofBudget {
  /// For a surface with these bounds: up to 8,000 boxes, fewer for long formulas.
  explicit ProofBudget(const Tape& bounds);
  std::size_t boxes;
};

/// Lines of the root grid, whose cells are numbered with u inner.
struct RootLines {
  std::span<const double> u, v;
};

/// Bounds the distance of r(u, v) from the triangles of each patch, of sides h and k, by
/// (h^2 |r_uu| + 2 h k |r_uv| + k^2 |r_vv|) / 8, over boxes in which r is proved to be defined and
/// its first derivatives continuous. Boxes of many root cells come first, parts of patches last.
/// Boxes without a proof when the budget ends are unproved. Where bounds are narrow and derivatives
/// too large for a proof, there is a gap and no unproved box.
Certification certify(const Surface& surface, const RootLines& root, std::span<const Patch> patches,
                      ProofBudget& budget);

}  // namespace saddle
