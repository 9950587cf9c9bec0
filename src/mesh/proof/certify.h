// Proves by interval arithmetic that no feature hides between the samples that a mesh was made
// from, or finds where one may.
// Source: D. Filip, R. Magedson, R. Markot, "Surface algorithms using bounds on derivatives", 1986;
// J. Snyder, "Interval analysis for computer graphics", 1992.
#pragma once

#include <span>
#include <vector>

#include "mesh/model/proof_gap.h"
#include "mesh/sizing/probe.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

/// The proof is of so many times the tolerance: bounds of derivatives are wider than derivatives,
/// and those along the surface count although they do no harm. What is finer is left to samples.
inline constexpr double kProofFactor = 8;

/// A box of parameters for which there is no proof.
struct UnprovedBox {
  std::size_t leaf;
  dvec2 middle;
  dvec2 size;
  dvec2 bend;                 ///< bounds of |r_uu| and |r_vv|
  bool is_undefined = false;  ///< it is proved that the surface is not defined anywhere in it
  bool may_jump = false;      ///< bounds do not exclude that the surface jumps in it
};

struct Certification {
  std::vector<UnprovedBox> unproved_boxes;  ///< places to be looked at
  std::vector<ProofGap> proof_gaps;         ///< none: the proof holds everywhere
};

/// Boxes that may still be tried. There are fewer where each one is dear.
struct ProofBudget {
  /// For a surface with these bounds.
  explicit ProofBudget(const Tape& bounds);
  std::size_t boxes;
};

/// Bounds the distance of r(u, v) from the triangles of each leaf, of sides h and k, by
/// (h^2 |r_uu| + 2 h k |r_uv| + k^2 |r_vv|) / 8, over boxes in which r is proved to be defined and
/// its first derivatives continuous; large boxes first, parts of leaves last. `allowed`: of each
/// leaf, in units of length. Where the budget is used up, what has no proof by then is suspected;
/// where derivatives are known well and too large for a proof, there is none, and no suspicion.
Certification certify(const Surface& surface, const Grid& grid, const CellTree& tree,
                      std::span<const Leaf> leaves, std::span<const double> allowed,
                      ProofBudget& budget);

}  // namespace saddle
