// Descends from places in the domain to zeros of r_u x r_v, by Gauss and Newton's method with exact
// derivatives. Each step is tried once and doubled, and the one that comes nearer is taken: for a
// double zero, a single step is half the way.
// Source: C. F. Gauss, "Theoria motus corporum coelestium", 1809; E. Schroeder, "Ueber unendlich
// viele Algorithmen zur Aufloesung der Gleichungen", 1870 (multiple zeros).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "surface/surface.h"

namespace saddle {

/// In ranges: the distance at which a zero is compared with its surroundings.
inline constexpr double kBesideZero = 1e-3;
/// Number of ways around a place.
inline constexpr std::size_t kWaysAround = 8;

/// UnitPlaces in the domain, in parts of the ranges.
using UnitPlaces = std::vector<dvec2>;

/// Directions that a descent may take.
enum class Along : std::uint8_t { U, V, Both };

class ZeroFinder {
 public:
  /// For a surface of second order with these bounds. A zero within rounding of one of `even_u` or
  /// `even_v` is moved there.
  ZeroFinder(const Surface& surface, const Bounds& bounds, unsigned threads,
             std::span<const double> even_u, std::span<const double> even_v);

  dvec2 part(const dvec2& uv) const { return (uv - low_) / range_; }
  dvec2 parameters(const dvec2& part) const { return low_ + part * range_; }
  UnitPlaces parts(std::span<const dvec2> uv) const;

  /// The ends of descents from some places; these need not be zeros.
  UnitPlaces descend(UnitPlaces places, Along along) const;

  /// |r_u x r_v|; infinite where it is not defined.
  std::vector<double> sizes_at(const UnitPlaces& places) const;

  /// Whether |r_u x r_v| is 0 at places, compared with its size around them.
  std::vector<bool> are_zeros(const UnitPlaces& places) const;

  /// The zeros among some places; moved to even coordinates that are zeros as well.
  UnitPlaces zeros(const UnitPlaces& places) const;

  /// Whether derivatives of r_u x r_v exclude that there are zeros beside a place.
  std::vector<bool> stand_alone(const UnitPlaces& places) const;

  /// Unit vectors all around, aslant to the axes.
  static std::array<dvec2, kWaysAround> ways();

 private:
  /// r_u x r_v and its derivatives by the parts of the ranges.
  struct Area {
    dvec3 cross;
    dvec3 by_u, by_v;
    /// The sum of the derivatives' squares.
    double square() const;
  };

  static dvec2 clamped(const dvec2& place);
  static dvec2 way_down(const Area& area);
  std::vector<Area> areas_at(const UnitPlaces& places) const;
  UnitPlaces ways_down(const UnitPlaces& places, Along along) const;

  const Surface& surface_;
  unsigned threads_;
  dvec3 scale_;  // of the axes: a zero is one in any units
  dvec2 low_, range_;
  std::array<std::vector<double>, 2> even_;  // parts of each range
};

}  // namespace saddle
