// Distances of triangles beside creases and cusps from the surface, where the nearest point is not
// the one at the same parameters.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Where a line in the (u, v) plane is crossed by a crease.
struct CreasePlace {
  dvec2 uv;
  bool is_plain;  ///< no cusp, and the surface is not upright
};
std::vector<std::optional<CreasePlace>> crease_places(const Surface& surface,
                                                      std::span<const Line> lines,
                                                      unsigned threads);

/// The middle of a chord of the mesh.
struct MiddleOfChord {
  std::array<dvec3, 2> positions;  ///< of the chord's ends
  Line ends;                       ///< their parameters
  dvec2 reach;                     ///< how far from their middle the nearest point is searched
  double allowed;                  ///< skip the second start below this distance
  double known = 0;                ///< abandon any descent below this distance

  dvec3 middle() const { return 0.5 * (positions[0] + positions[1]); }
};
/// The distances of middles of chords from the surface near their parameters: upper bounds.
std::vector<double> distances_from_surface(const Surface& surface,
                                           std::span<const MiddleOfChord> chords, unsigned threads);

}  // namespace saddle
