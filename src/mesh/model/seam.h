// How an edge of the domain meets the opposite one, or itself.
#pragma once

#include <array>
#include <string>

namespace saddle {

/// A shift by `parts` / `of` of a loop. They are integers: on a grid that has a multiple of `of`
/// lines, a shift maps lines onto lines.
struct Shift {
  unsigned parts = 0;
  unsigned of = 1;

  bool any() const { return parts != 0; }
  /// Shifts place `k` of a loop from 0 to `length`, a multiple of `of` if it is an integer.
  template <class Number>
  Number operator()(Number k, Number length) const {
    if (!any()) return k;  // `length` stays `length`
    const Number on = k + length / static_cast<Number>(of) * static_cast<Number>(parts);
    return on < length ? on : on - length;
  }
  Shift back() const { return any() ? Shift{of - parts, of} : *this; }
};

struct Seam {
  bool closed = false;
  bool reversed = false;  ///< the edges run in opposite directions
  Shift shift = {};       ///< start of the first edge on the last, where both are loops

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

  /// "join", "reversed", "shifted"; "" for edges that do not meet. A reversed seam is "reversed"
  /// with a shift, too: it makes the surface one-sided.
  std::string name() const {
    if (!closed) return "";
    return reversed ? "reversed" : shift.any() ? "shifted" : "join";
  }
};

/// The seams that are looked for, in this order. The shifts are the turns of tubes whose sections
/// have up to six corners.
inline constexpr std::array kSeams = {
    Seam{true, false},         Seam{true, true},          Seam{true, false, {1, 2}},
    Seam{true, true, {1, 2}},  Seam{true, false, {1, 3}}, Seam{true, false, {2, 3}},
    Seam{true, false, {1, 4}}, Seam{true, false, {3, 4}}, Seam{true, false, {1, 5}},
    Seam{true, false, {2, 5}}, Seam{true, false, {3, 5}}, Seam{true, false, {4, 5}},
    Seam{true, false, {1, 6}}, Seam{true, false, {5, 6}}};

/// A folded edge as a seam with itself.
inline constexpr Seam kFold = {true, true};

/// The seams of the edges u0 and u1, and of v0 and v1. An edge without a seam may be folded in the
/// middle: r(u0, v) = r(u0, v0 + v1 - v).
struct Seams {
  Seam u;
  Seam v;
  std::array<bool, 2> folded_u = {};  ///< u0, u1
  std::array<bool, 2> folded_v = {};  ///< v0, v1

  bool has_folds() const { return folded_u[0] || folded_u[1] || folded_v[0] || folded_v[1]; }
  bool any() const { return u.closed || v.closed || has_folds(); }
};

}  // namespace saddle
