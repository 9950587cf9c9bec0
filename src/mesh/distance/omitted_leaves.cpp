#include "mesh/distance/omitted_leaves.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/polygon.h"

namespace saddle {

void OmittedLeaves::add(const Leaf& leaf, std::size_t number, bool is_at_jump) {
  if (!is_at_jump) {
    for (const dvec2& place : kPlacesInBox) add_place(leaf, number, place);
    return;
  }
  for (const double u : {0.06, 0.28, 0.5, 0.72, 0.94}) {
    for (const double v : {0.06, 0.28, 0.5, 0.72, 0.94}) add_place(leaf, number, {u, v});
  }
}

void OmittedLeaves::add_place(const Leaf& leaf, std::size_t number, const dvec2& place) {
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  leaves_.push_back(number);
  places_.push_back(low + size * place);
  for (const dvec2& way : kFourWays) places_.push_back(low + size * border_of_square(place, way));
}

std::vector<LeafDistance> OmittedLeaves::measure() {
  std::vector<LeafDistance> found;
  const std::vector<dvec3> points = evaluate_positions(surface_, places_, threads_);
  const std::size_t group = 1 + kFourWays.size();  // a place and those beside it
  for (std::size_t k = 0; k < points.size(); k += group) {
    if (!is_seen(clip_, points[k])) continue;
    double nearest = kInfinity;
    for (std::size_t way = 1; way < group; ++way) {
      const dvec3& beside = points[k + way];
      if (is_finite(beside)) nearest = std::min(nearest, glm::distance(beside, points[k]));
    }
    found.push_back({leaves_[k / group], nearest});
  }
  return found;
}

}  // namespace saddle
