// From a probe's second derivatives to the lines of a tensor grid: the sizing field (lines per unit
// of parameter) for which most cells are within the tolerance, and the lines that follow it. Local
// peaks of the error are left to local refinement. Source: D. Filip, R. Magedson, R. Markot,
// "Surface algorithms using bounds on derivatives", 1986.
#pragma once

#include <vector>

#include "mesh/features/singular.h"
#include "mesh/model/counterexample.h"
#include "mesh/model/tolerance.h"
#include "mesh/sizing/place_lines.h"
#include "mesh/sizing/probe.h"
#include "mesh/sizing/second_form.h"

namespace saddle {

/// Lines that a grid takes each way besides those of its sizing: through singular points, which
/// become vertices, and over a small component between the probe's samples.
inline constexpr std::size_t kMostAddedLines = 16;

/// The lines that a tensor grid must have: the drawn ones, those through singular points if these
/// are few, and those that they meet across a seam.
FixedLines fixed_lines(const Probe& probe, const FixedLines& drawn, const SingularSet& singular);

/// The sizing field at each column and row of the probe, for a grid with the fixed lines. Cells
/// have the shape for which there are the fewest.
SizingField sizing_field(const Probe& probe, const FixedLines& fixed, const Tolerance& tolerance);

/// The fixed lines and those between them, at `times` the densities of a sizing field. Errors fall
/// with the square of `times`: half the densities are for four times the tolerance.
FixedLines place_lines(const Probe& probe, const FixedLines& fixed, const SizingField& sizing,
                       double times = 1);

/// The samples at which a cell of these lines misses by more than 4 tolerances; `cell` counts with
/// u inner.
std::vector<Counterexample> find_counterexamples(const Probe& probe, const FixedLines& lines,
                                                 const Tolerance& tolerance);

}  // namespace saddle
