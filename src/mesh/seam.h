// How an edge of the domain meets the opposite one, or itself.
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

/// An edge that is folded meets itself like this, from end to end.
inline constexpr Seam kFold = {true, true, false};

/// How the edges u0 and u1 meet, and v0 and v1; those that do not may each be folded in the middle:
/// r(u0, v) = r(u0, v0 + v1 - v).
struct Seams {
  Seam u;
  Seam v;
  std::array<bool, 2> folded_u = {};  ///< u0, u1
  std::array<bool, 2> folded_v = {};  ///< v0, v1

  bool has_folds() const { return folded_u[0] || folded_u[1] || folded_v[0] || folded_v[1]; }
  bool any() const { return u.closed || v.closed || has_folds(); }
};

}  // namespace saddle
