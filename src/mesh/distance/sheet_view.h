// The sheet of a cell on one side of a chord: how the sheet's own edge is seen from its corners.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/distance/sampled_error.h"
#include "mesh/grid/grid.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/continuity.h"

namespace saddle {

/// The part of a way across a leaf that is left after kHalvingsToEdge.
inline constexpr double kLastStep = 1.0 / (std::uint64_t{1} << kHalvingsToEdge);

/// Whether bisections of a line that is defined at its first end have led to its second.
inline bool is_at_end(const dvec2& last, const Line& line) {
  return glm::distance(last, line[1]) <= 2 * kLastStep * glm::distance(line[0], line[1]);
}

/// The triangles of a cell by their sides. A cell beside a feature may have thousands.
class CellTriangles {
 public:
  explicit CellTriangles(std::span<const Triangle> triangles);

  /// Whether a triangle runs from corner a to corner b.
  bool has_side(std::uint32_t a, std::uint32_t b) const { return !with_side(a, b).empty(); }
  /// The triangles that are connected to the one of some number by common sides.
  std::vector<Triangle> connected_to(std::uint32_t number) const;

 private:
  struct NumberedSide {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t triangle;
  };
  std::span<const NumberedSide> with_side(std::uint32_t a, std::uint32_t b) const;

  std::span<const Triangle> triangles_;
  std::vector<NumberedSide> sides_;  // sorted by their ends
};

/// A triangle with the places of its corners in its leaf, counter-clockwise.
struct PlacedTriangle {
  Triangle corners;
  std::array<dvec2, 3> places;
};

/// The corner of triangles from which `at`, a place on a chord, is seen within them: in space as
/// straight across the chord as possible. `opposite`: the corner of the chord's own triangle.
std::uint32_t corner_across(const Grid& grid, const Chord& chord, double share, const dvec2& at,
                            std::uint32_t opposite, std::span<const PlacedTriangle> triangles);

/// The distance of an edge from its chord, above a share of the chord.
struct Height {
  double share;
  double distance;
};

/// The distance from its chord of the corner between two straight edges, from the chord's ends
/// through a height each.
double height_of_roof(const Height& first, const Height& last);
/// The largest distance of an edge from its chord, predicted from three heights. Where a jump ends
/// at a corner, distances grow up to the corner.
double predicted_distance(std::array<Height, 3> heights);
/// A predicted distance of an edge from its chord as far as what was measured supports it.
/// `farthest`: at the places kAlongLine. An edge that goes straight from one end of the chord is
/// 4/3 as far at the other. An edge that turns may not go on as predicted: then no more than
/// `allowed` counts, for which a leaf with a jump is halved.
double supported_distance(double predicted, double farthest, double allowed);

}  // namespace saddle
