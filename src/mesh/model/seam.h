// How an edge of the domain meets the opposite one, or itself.
#pragma once

#include <array>
#include <string>

namespace saddle {

/// So many parts of `of` equal ones. As integers: places on a grid are counted, and to have as many
/// after a shift its lines must be shifted copies of each other.
struct Shift {
  unsigned parts = 0;
  unsigned of = 1;

  bool any() const { return parts != 0; }
  /// Shifts place `k` of a loop from 0 to `length`, a multiple of `of` if it is an integer.
  template <class Number>
  Number operator()(Number k, Number length) const {
    if (!any()) return k;  // its end stays its end
    const Number on = k + length / static_cast<Number>(of) * static_cast<Number>(parts);
    return on < length ? on : on - length;
  }
  Shift back() const { return any() ? Shift{of - parts, of} : *this; }
};

struct Seam {
  bool closed = false;
  bool reversed = false;  ///< the edges run in opposite directions
  Shift shift = {};       ///< the edges are loops, and the first one starts there on the last

  /// The place on the last edge that meets place `k` of 0 to `length` on the first.
  template <class Number>
  Number partner(Number k, Number length) const {
    return shift(reversed ? length - k : k, length);
  }
  /// The place on the first edge that meets place `k` on the last.
  template <class Number>
  Number partner_back(Number k, Number length) const {
    return reversed ? partner(k, length) : shift.back()(k, length);
  }

  /// "join", "reversed", "shifted"; "" for edges that do not meet. Reversed and shifted is
  /// reversed: that is what makes a surface one-sided.
  std::string name() const {
    if (!closed) return "";
    return reversed ? "reversed" : shift.any() ? "shifted" : "join";
  }
};

/// The ways to meet, in the order that they are looked for in. Shifted by what tubes are turned by
/// whose sections have up to six corners.
inline constexpr std::array kSeams = {
    Seam{true, false},         Seam{true, true},          Seam{true, false, {1, 2}},
    Seam{true, true, {1, 2}},  Seam{true, false, {1, 3}}, Seam{true, false, {2, 3}},
    Seam{true, false, {1, 4}}, Seam{true, false, {3, 4}}, Seam{true, false, {1, 5}},
    Seam{true, false, {2, 5}}, Seam{true, false, {3, 5}}, Seam{true, false, {4, 5}},
    Seam{true, false, {1, 6}}, Seam{true, false, {5, 6}}};

/// An edge that is folded meets itself like this, from end to end.
inline constexpr Seam kFold = {true, true};

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
