#include "mesh/proof/slivers.h"

#include <glm/geometric.hpp>

#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

std::vector<std::array<bool, 2>> are_in_slivers(const Surface& surface,
                                                std::span<const SheetStep> steps,
                                                unsigned threads) {
  const ParameterBox domain = box_of(surface.domain);
  std::vector<dvec2> beyond;
  for (const auto& [line, at_ends] : steps) {
    const dvec2 step = line[1] - line[0];
    const dvec2 way = kStays * kSliver / length_in_ranges(line, domain.size()) * step;
    beyond.push_back(nearest_in(domain, line[0] - way));
    beyond.push_back(nearest_in(domain, line[1] + way));
  }
  const std::vector<dvec3> found = evaluate_positions(surface, beyond, threads);
  std::vector<std::array<bool, 2>> result;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto& at_ends = steps[k].at_ends;
    const double height = glm::distance(at_ends[0], at_ends[1]) / kStays;
    result.push_back({glm::distance(at_ends[0], found[2 * k]) > height,
                      glm::distance(at_ends[1], found[2 * k + 1]) > height});
  }
  return result;
}

}  // namespace saddle
