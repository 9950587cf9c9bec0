// Runs a tape over many points, in blocks, on several threads.
#pragma once

#include <span>

#include "eval/tape.h"

namespace saddle {

/// outputs[k][i] = output k at (u[i], v[i]). Each outputs[k] has room for u.size() numbers, and
/// u.size() == v.size(). NaN and infinities are values like any other. `threads` 0: all.
void evaluate_points(const Tape& tape, std::span<const double> u, std::span<const double> v,
                     std::span<double* const> outputs, unsigned threads = 0);

/// outputs[k][j * u.size() + i] = output k at (u[i], v[j]): what depends on u alone is computed
/// once per column, on v alone once per row. The same bits as evaluate_points, for any `threads`.
void evaluate_grid(const Tape& tape, std::span<const double> u, std::span<const double> v,
                   std::span<double* const> outputs, unsigned threads = 0);

}  // namespace saddle
