// Point singularities: finds the point in a box where a surface may break, and classifies places
// where it is undefined by its limits on ways around them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// A closed polygon of places.
class ClosedCurve {
 public:
  ClosedCurve() = default;
  explicit ClosedCurve(std::vector<dvec3> places);

  bool empty() const { return places_.empty(); }
  /// Whether a place is at most `reach` away.
  bool is_within(const dvec3& place, double reach) const;
  /// The number of chords longer than `length`.
  std::size_t count_chords(double length) const;

 private:
  bool is_near_chord(std::size_t number, const dvec3& place, double reach) const;

  std::vector<dvec3> places_;
  std::vector<Bounds> boxes_;  // around chords, some of them at a time
};

struct PointSingularity {
  enum class Kind : std::uint8_t {
    Region,     ///< the surface is undefined beside the place, too, or the place is on its boundary
    Line,       ///< the surface is undefined on a line and defined on both sides
    Pole,       ///< on some ways to the point the surface diverges
    Essential,  ///< limits on different ways to the point differ
    Removable,  ///< all ways to the point have one limit
  };
  Kind kind = Kind::Region;
  Bounds near;  ///< of positions 1e-12 ranges from the point
  /// Where positions go toward a pole, if they move on as near to it as doubles are beside 0. Even
  /// 0.04*ln(hypot(u,v)) goes far.
  Bounds beyond = {};
  /// Positions around an essential point within the domain, in the order of the ways to it.
  ClosedCurve around = {};
};

/// The point in each box where bounds do not prove the surface to be continuous, to about 1e-9 of
/// the box. Empty if there is no such point or more than one. With the `diagonal` of a box around
/// the surface, the essential point among several, if there is one: bounds may fail along the whole
/// line on which an operation jumps, although the surface does not.
std::vector<std::optional<dvec2>> find_point_singularities(
    const Surface& surface, std::span<const ParameterBox> where,
    std::optional<double> diagonal = std::nullopt);

/// Whether curves to a place have other limits than straight ways: those of u^2*v/(u^4+v^2) to
/// (0, 0) along v = c*u^2 are c/(1+c^2), and 0 along all lines.
bool has_limits_aside(const Surface& surface, const dvec2& place, double diagonal,
                      unsigned threads);

/// Up to 32 limits at a point are those of up to 16 lines of jumps through it.
inline constexpr std::size_t kLimitsOfLines = 32;

/// A point of the surface 1e-12 ranges from a place.
struct PointBeside {
  dvec2 uv;
  SurfacePoint point;
};
/// A point of one of the sheets that meet at a place without a value, where lines of jumps do, as
/// on (u-v)/abs(u-v). Nothing where other ways to the place have other limits. `diagonal`: of a box
/// around the surface. Adds to `count` the number of points evaluated.
std::vector<std::optional<PointBeside>> points_beside_jumps(const Surface& surface,
                                                            std::span<const dvec2> places,
                                                            double diagonal, unsigned threads,
                                                            std::size_t& count);

/// Classifies each place by the surface around it. `diagonal`: of a box around the surface.
std::vector<PointSingularity> classify_points(const Surface& surface, std::span<const dvec2> places,
                                              double diagonal, unsigned threads);

}  // namespace saddle
