// One-sided limits: whether a surface diverges on the way to a place, and where its boundary is.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// The places that diverge() evaluates, in parts of the line.
inline constexpr std::array kApproach = {0x1p-12, 0x1p-16, 0x1p-20, 0x1p-24, 0x1p-28, 0x1p-32};

/// Other places that it evaluates if the line is as long, in parts of the range. Nearer to a pole
/// rounding may leave no digit of a formula: that of ln(1-sin(u+v)) ends 1e-8 before, with jumps.
inline constexpr std::array kBesidePole = {0x1p-16, 0x1p-18, 0x1p-20, 0x1p-22};

/// Whether the surface goes to infinity on the way from the second end of each line to the first.
/// It is evaluated at places 16 times as near each. If it converges, it moves by less each time,
/// like sqrt. If it diverges, it moves by as much or more in one direction: ln(x), which is no
/// less than -745 at the least double, moves by the same each time. A move below `delta` converges.
/// Beside a pole where rounding ends the surface, it diverges at the places of kBesidePole.
std::vector<bool> diverge(const Surface& surface, std::span<const Line> lines, double delta,
                          unsigned threads);

/// The two places nearest to the first end of a line that diverge() evaluates, the nearest last.
/// Doubles that are nearer to a pole may be rounding errors.
std::array<dvec2, 2> nearest_approaches(const Line& line);

/// Bisects each line from an end where the surface is defined, and within `box`, to one where it is
/// not. Returns the last places known to be inside.
std::vector<dvec2> last_defined(const Surface& surface, std::span<const Line> lines, int halvings,
                                unsigned threads, const std::optional<Bounds>& box = {});

/// Ends each line that leads across a gap, to another sheet, at a place in the first gap. Gaps are
/// looked for where bounds do not prove that the surface is continuous. Lines across waves, through
/// many gaps, stay as they are. Adds to `work` the number of points evaluated.
void end_in_gaps(const Surface& surface, std::span<Line> lines, unsigned threads,
                 const std::optional<Bounds>& box, std::size_t& work);

}  // namespace saddle
