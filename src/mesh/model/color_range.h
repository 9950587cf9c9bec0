// The range of numbers that a colour map covers.
#pragma once

namespace saddle {

/// The numbers of the first and the last colour. Numbers outside have the colours of the ends.
struct ColorRange {
  double low = 0;
  double high = 0;
  bool below = false;  ///< some numbers are less than `low`
  bool above = false;  ///< some numbers are more than `high`
};

}  // namespace saddle
