// Where a sheet of a surface ends: at its boundary, or where the surface jumps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// The last place on the sheet of a line's first end, on the way to its second end.
struct SheetEnd {
  enum class Kind : std::uint8_t {
    Open,      ///< the sheet goes on: the place is the line's second end
    Jump,      ///< the surface goes on elsewhere
    Boundary,  ///< it is undefined beyond, or outside of the box
  };
  dvec2 uv;
  Kind kind = Kind::Open;
};

/// How the ends of sheets are searched.
struct SheetEndSearch {
  double delta;  ///< a smaller gap is no jump
  int halvings;  ///< of a line
  const std::optional<Bounds>& box;
};

/// Bisects lines that start on a sheet, and within the box. A line that leads to a pole has no end.
/// Adds to `work` the number of points evaluated.
std::vector<std::optional<SheetEnd>> sheet_ends(const Surface& surface, std::span<const Line> lines,
                                                const SheetEndSearch& search, unsigned threads,
                                                std::size_t& work);

}  // namespace saddle
