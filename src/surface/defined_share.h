// How much of a surface's domain is proved to be defined, and how much is proved not to be.
#pragma once

#include <cstddef>
#include <optional>

#include "surface/surface.h"

namespace saddle {

/// Shares of the domain's area; what is left of 1 is undecided.
struct DefinedShare {
  double yes = 0;
  double no = 0;
  bool everywhere = false;  ///< no point is undefined or undecided
  bool continuous = false;  ///< everywhere, and no point may be one of a jump or pole
  /// The middle of the part around the largest box that is proved undefined, and that of the
  /// largest box that stayed undecided.
  std::optional<dvec2> undefined_at, undecided_at;
};

/// Halves boxes of parameters, the largest first, until each is decided or `boxes` were looked at.
/// For a surface of second order.
DefinedShare prove_defined(const Surface& surface, std::size_t boxes);

/// Whether the surface is not finite at some of the places that are spread over the domain, but
/// proved to be defined at all of those: its numbers are too large for doubles.
bool exceeds_doubles(const Surface& surface, unsigned threads);

}  // namespace saddle
