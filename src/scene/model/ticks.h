// Round numbers along an axis, and how they are written.
#pragma once

#include <string>
#include <vector>

namespace saddle {

struct Tick {
  double value = 0;
  std::string text;  ///< of (value - offset) / 10^exponent: see Ticks::note
};

struct Ticks {
  std::vector<Tick> ticks;
  std::string note;  ///< what all texts leave out, such as "×10⁻³ + 12000", or empty
};

/// Numbers in [low, high] that are 1, 2 or 5 times a power of ten apart, about `count` of them,
/// with no more digits than tell them apart. Where all of them are long because they are large,
/// small or close together, the note has what they have in common. One number where low == high.
/// Source: P. Heckbert, "Nice numbers for graph labels", Graphics Gems, 1990.
Ticks ticks(double low, double high, int count);

}  // namespace saddle
