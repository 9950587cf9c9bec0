#include "mesh/tree/leaf_border.h"

#include <glm/geometric.hpp>

#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

std::optional<double> border_of_pieces(const Leaf& leaf, const CellTree& tree) {
  const auto& position = tree.mesh().position;
  dvec2 border(0);    // along u and along v
  dvec2 measured(0);  // in units of the cell tree
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    // Between its jumps, the side is on other sheets.
    if (tree.edges().has_more(a, b)) return;
    const auto feature = tree.edges().feature(a, b);
    // Without a defined end and a feature the length of a side is not known: it is not 0.
    const bool is_undefined = !tree.geometry().is_defined(a) && !tree.geometry().is_defined(b);
    if (is_undefined && !feature) return;
    const dvec2 first = tree.vertices().place_between(a);
    const dvec2 last = tree.vertices().place_between(b);
    const int axis = first.y == last.y ? 0 : 1;
    measured[axis] += glm::distance(first, last);
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
      // A vertex with a value of its own has no piece.
      if (tree.vertices().place_between(from) == tree.vertices().place_between(to)) return;
      if (tree.geometry().is_defined(from))
        border[axis] += glm::distance(position[from], position[to]);
    };
    if (!feature) return add(a, b);
    add(a, feature->beside(a));
    add(b, feature->beside(b));
  });
  const dvec2 size(leaf.size_u(), leaf.size_v());
  for (const int axis : {0, 1}) {
    // Sides that are not measured are as long as those opposite. The shortest have no length.
    if (measured[axis] > 0) border[axis] *= 2 * size[axis] / measured[axis];
    if (measured[axis] == 0 && size[axis] > 1) return std::nullopt;
  }
  return border.x + border.y;
}

}  // namespace saddle
