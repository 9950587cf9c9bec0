// Thin parts of lines: places where a surface is defined between undefined ends, or undefined
// between defined ends. Bounds find parts of any width.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// A line whose ends are both defined, or both undefined.
struct AlikeEnds {
  Line line;
  bool are_defined;
};

/// A place in a thin part of each line; nothing where bounds exclude one, or do not lead to one.
/// Adds to `work` the number of boxes and points.
std::vector<std::optional<dvec2>> find_thin_parts(const Surface& surface,
                                                  std::span<const AlikeEnds> lines,
                                                  unsigned threads, std::size_t& work);

}  // namespace saddle
