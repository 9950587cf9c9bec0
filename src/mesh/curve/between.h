// Doubles between two others, down to neighbours.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace saddle {

/// Halvings by which the middle is that of the numbers; from there on by that of their bits, which
/// comes to the neighbours of 0, too, in 64 more.
inline constexpr int kEvenHalvings = 40;

/// Doubles in their order as whole numbers.
inline std::int64_t ordinal(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

inline double from_ordinal(std::int64_t n) {
  return std::bit_cast<double>(n < 0 ? std::numeric_limits<std::int64_t>::min() - n : n);
}

/// A number between two others, in the middle for a share of 0.5; one of them if they are
/// neighbours.
inline double between(double a, double b, double share, int halvings) {
  if (halvings < kEvenHalvings) return a + (b - a) * share;
  const std::int64_t low = ordinal(a);
  const auto gap =
      static_cast<double>(static_cast<std::uint64_t>(ordinal(b)) - static_cast<std::uint64_t>(low));
  return from_ordinal(low + static_cast<std::int64_t>(gap * share));
}

}  // namespace saddle
