// Tells jumps and poles from steep slopes, along straight lines in the (u, v) plane.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/surface.h"

namespace saddle {

enum class Break : std::uint8_t { None, Jump, Pole };

/// What is found between two places, and where.
struct Found {
  Break kind = Break::None;
  dvec2 uv{0};
};

/// Follows the larger half of the gap between the ends of each line until both halves are below
/// `delta`, which shows that the surface is continuous there, or the parameters have run out of
/// digits: then it jumps, or goes to infinity if the gap has grown on the way.
std::vector<Found> find_breaks(const Surface& surface, std::span<const std::array<dvec2, 2>> lines,
                               double delta, unsigned threads);

}  // namespace saddle
