// Loops as an expert writes them for one surface, compiled for the processor at hand: the measure
// for what a program for all surfaces can reach. u[i] and v[j] span the grid; six floats per
// vertex, position and unit normal, v outer.
#pragma once

#include <vector>

namespace saddle {

/// ((2 + cos v) cos u, (2 + cos v) sin u, sin v).
void torus_by_hand(const std::vector<double>& us, const std::vector<double>& vs, float* to);

/// (u - u^3/3 + u v^2, v - v^3/3 + u^2 v, u^2 - v^2).
void enneper_by_hand(const std::vector<double>& us, const std::vector<double>& vs, float* to);

}  // namespace saddle
