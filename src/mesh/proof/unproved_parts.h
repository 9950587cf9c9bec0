// The parts of patches for which a proof found none: as gaps with a reason, and as boxes in which
// counterexamples are looked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers.h"
#include "base/vec.h"
#include "mesh/model/proof_gap.h"
#include "mesh/proof/root_cells.h"
#include "surface/parameter_box.h"

namespace saddle {

/// A box of parameters without a proof, a part of a patch.
struct UnprovedBox {
  std::size_t patch;
  dvec2 middle;
  dvec2 size;
  dvec2 bend;                 ///< bounds of |r_uu| and |r_vv|
  bool is_undefined = false;  ///< proved: the surface is defined nowhere in the box
  bool may_jump = false;      ///< bounds do not exclude that the surface jumps in the box
};

/// Takes boxes without a proof, some at a time.
using TakeUnproved = std::function<void(std::span<const UnprovedBox>)>;

class UnprovedParts {
 public:
  /// Keeps references to its arguments.
  UnprovedParts(const Patches& patches, const TakeUnproved& take)
      : patches_(patches), take_(take) {}

  /// A part without a proof. Most are whole patches, whose boxes are not stored.
  struct Gap {
    std::uint32_t patch;
    GapReason why;
    std::uint32_t part;  ///< number of its box; kNoIndex: the whole patch
  };
  /// `part`: nothing for the whole patch.
  void add_gap(GapReason why, std::uint32_t patch, const std::optional<ParameterBox>& part = {});
  const std::vector<Gap>& gaps() const { return gaps_; }
  ParameterBox box_of(const Gap& gap) const {
    return gap.part == kNoIndex ? patches_[gap.patch].box : parts_[gap.part];
  }

  /// Boxes are passed on some at a time, and the last ones by pass_on().
  void add_box(const UnprovedBox& box);
  void pass_on();

 private:
  const Patches& patches_;
  const TakeUnproved& take_;
  std::vector<Gap> gaps_;
  std::vector<ParameterBox> parts_;
  std::vector<UnprovedBox> boxes_;  // not passed on yet
};

}  // namespace saddle
