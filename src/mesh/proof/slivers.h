// Sheets made of rounding, as that of floor(cos(u)), which is 1 as far as 1e-8 from u=0: kSliver.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// A line between two sheets, and the positions at its ends.
struct SheetStep {
  Line line;
  std::array<dvec3, 2> at_ends;
};

/// Whether the ends of steps are in slivers: a little farther from the other end the surface is on
/// another sheet.
std::vector<std::array<bool, 2>> are_in_slivers(const Surface& surface,
                                                std::span<const SheetStep> steps, unsigned threads);

}  // namespace saddle
