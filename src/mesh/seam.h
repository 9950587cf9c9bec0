// How an edge of the domain meets the opposite one.
#pragma once

#include <array>
#include <string>

namespace saddle {

struct Seam {
  bool closed = false;
  bool reversed = false;  ///< the edges run in opposite directions
  bool shifted = false;   ///< the other edge, itself a loop, starts half way along this one

  /// The place on the other edge that meets place `k` of 0 to `length`.
  template <class Number>
  Number partner(Number k, Number length) const {
    const Number along = reversed ? length - k : k;
    if (!shifted) return along;
    return along < length / 2 ? along + length / 2 : along - length / 2;
  }

  /// "join", "reversed", "shifted"; "" for edges that do not meet. Reversed and shifted is
  /// reversed: that is what makes a surface one-sided.
  std::string name() const {
    if (!closed) return "";
    return reversed ? "reversed" : shifted ? "shifted" : "join";
  }
};

/// The ways to meet, in the order that they are looked for in.
inline constexpr std::array<Seam, 4> kSeams = {
    {{true, false, false}, {true, true, false}, {true, false, true}, {true, true, true}}};

}  // namespace saddle
