// Proves by interval arithmetic that no feature hides between the samples that a mesh was made
// from, or finds where one may.
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

/// The proof is of so many times the tolerance: bounds of derivatives are wider than derivatives,
/// and those along the surface count although they do no harm. What is finer is left to samples.
inline constexpr double kProofFactor = 8;

/// A box of parameters whose triangles are to be proved.
struct Patch {
  ParameterBox box;
  double allowed;                   ///< distance from the surface, in units of length
  std::size_t root_cell;            ///< number of the root cell that holds the box; u is inner
  std::optional<GapReason> cut_by;  ///< feature in the box: no proof is tried
};

/// A box of parameters without a proof, in a patch.
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
  std::vector<ProofGap> proof_gaps;  ///< empty: the proof holds everywhere
};

/// Boxes that may still be tried: fewer for long formulas.
struct ProofBudget {
  /// For a surface with these bounds.
  explicit ProofBudget(const Tape& bounds);
  std::size_t boxes;
};

/// Lines of the root grid, whose cells are numbered with u inner.
struct RootLines {
  std::span<const double> u, v;
};

/// Bounds the distance of r(u, v) from the triangles of each patch, of sides h and k, by
/// (h^2 |r_uu| + 2 h k |r_uv| + k^2 |r_vv|) / 8, over boxes in which r is proved to be defined and
/// its first derivatives continuous; large boxes first, parts of patches last. Boxes that have no
/// proof when the budget ends are unproved. Where derivatives are known well and too large for a
/// proof, there is a gap and no unproved box.
Certification certify(const Surface& surface, const RootLines& root, std::span<const Patch> patches,
                      ProofBudget& budget);

}  // namespace saddle
