// Which numbers have the first and the last of the colours.
#pragma once

namespace saddle {

/// The numbers at the first and the last of the colours; those outside have the colours of the
/// ends.
struct ColorRange {
  double low = 0;
  double high = 0;
};

}  // namespace saddle
