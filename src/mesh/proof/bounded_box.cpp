#include "mesh/proof/bounded_box.h"

#include "mesh/model/sample_places.h"

namespace saddle {
namespace {

/// In tolerances: a box is measured if the surface is no farther from its points, or without such
/// bounds if the sphere around its box in space is no larger. That leaves one for their distances.
constexpr double kReach = kProofFactor - 1;

}  // namespace

std::size_t BoundedBox::count_points() const {
  if (centre) return may_jump ? 1 + kPlacesInBox.size() : 1;
  return std::size_t{cells[0] + 1} * (cells[1] + 1);
}

std::optional<BoundedBox> bounded_box(std::size_t patch, const ParameterBox& box,
                                      const BoxBounds& bounds, double tolerance) {
  // A box in which the surface may be undefined or jump is no longer than two tolerances. A hole
  // in it is at most one tolerance deep, and a mesh across a jump at most one off.
  const double allowed = bounds.broken ? tolerance : kReach * tolerance;
  const dvec2 size = box.size();
  const dvec2 bend(bounds.bend.x, bounds.bend.z);
  if (const auto cells = bounds.cells_within(size, allowed))
    return BoundedBox{patch, box, *cells, bounds.reach(size, *cells), bend};
  const double radius = 0.5 * bounds.extent();
  if (!(radius <= allowed)) return std::nullopt;
  const bool may_jump = bounds.broken == GapReason::Discontinuous;
  return BoundedBox{patch, box, {0, 0}, radius, bend, bounds.hull.centre(), may_jump};
}

}  // namespace saddle
