// What there is around a place where a surface is not defined.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/proof/small_components.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// A curve through places, back to the first of them.
class ClosedCurve {
 public:
  ClosedCurve() = default;
  explicit ClosedCurve(std::vector<dvec3> places);

  bool empty() const { return places_.empty(); }
  /// Whether a place is no farther away than `reach`.
  bool is_within(const dvec3& place, double reach) const;
  /// How many of its chords are longer.
  std::size_t count_chords(double length) const;

 private:
  bool is_near_chord(std::size_t number, const dvec3& place, double reach) const;

  std::vector<dvec3> places_;
  std::vector<Bounds> boxes_;  // around chords, some of them at a time
};

struct PointSingularity {
  enum class Kind : std::uint8_t {
    Part,  ///< a part of the domain where it is not defined either, or the place is on its boundary
    Line,  ///< places on a line, beside which it is defined
    Pole,  ///< one point, and on some ways to it the surface goes to infinity
    NoLimit,  ///< one point, and different ways to it lead to different places
    Limit,    ///< one point, and all ways to it lead to one place
  };
  Kind kind = Kind::Part;
  Bounds near;  ///< where the surface is around one point, as near to it as digits allow
  /// The same, in the order of the ways there, of a point without a limit that is within the
  /// domain.
  ClosedCurve around = {};
};

/// Where bounds leave room for a break in a box of parameters, if that is one point: as near as
/// digits allow. Nothing if they leave none, or more. With the `diagonal` of a box around the
/// surface, of more the point at which it has no limit, if there is one: they leave room along all
/// of the line on which atan2 jumps, where sin(atan2(v, u)) does not.
std::vector<std::optional<dvec2>> find_point_singularities(
    const Surface& surface, std::span<const ParameterBox> where,
    std::optional<double> diagonal = std::nullopt);

/// Of each place, by what is in the domain around it. `diagonal`: of a box around the surface.
std::vector<PointSingularity> classify_points(const Surface& surface, std::span<const dvec2> places,
                                              double diagonal, unsigned threads);

}  // namespace saddle
