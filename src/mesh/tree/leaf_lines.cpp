#include "mesh/tree/leaf_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mesh/grid/grid.h"
#include "mesh/grid/lines.h"
#include "mesh/model/pair_table.h"
#include "mesh/tree/cell_polygon.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Collects chains of vertices along lines.
class Chains {
 public:
  Chains(const Grid& grid, const CellTree& tree, std::span<const Leaf> leaves)
      : tree_(tree), chains_(grid.mesh) {
    for (const Leaf& leaf : leaves) {
      if (!leaf.state.oscillates()) continue;
      for_sides(leaf, tree,
                [this](std::uint32_t a, std::uint32_t b) { oscillating_.insert(pair_of(a, b)); });
    }
  }

  /// Continues the line to its next vertex, defined or not.
  void go_to(std::uint32_t vertex) {
    if (before_) cross(*before_, vertex);
    if (before_ && oscillating_.contains(pair_of(*before_, vertex))) chains_.interrupt();
    if (tree_.geometry().is_defined(vertex)) {
      chains_.append(vertex);
    } else {
      chains_.interrupt();
    }
    before_ = vertex;
  }
  void end_line() {
    chains_.interrupt();
    before_.reset();
  }
  std::vector<std::vector<std::uint32_t>> take() { return chains_.take(); }

 private:
  /// Appends the vertices of the feature between neighbours.
  void cross(std::uint32_t from, std::uint32_t to) {
    const std::optional<EdgeFeature> feature = tree_.edges().feature(from, to);
    if (!feature) return;
    if (leaves_out(feature->kind)) return chains_.interrupt();
    chains_.append(feature->beside(from));
    if (feature->kind == FeatureKind::Jump) chains_.interrupt();
    chains_.append(feature->beside(to));
  }

  const CellTree& tree_;
  PairTable oscillating_;  ///< sides of leaves
  std::optional<std::uint32_t> before_;
  ChainBuilder chains_;
};

/// The indices of the lines nearest to `count` even lines, each once.
std::vector<std::size_t> indices(const std::vector<double>& lines, int count) {
  std::vector<std::size_t> result;
  if (count < 1) return result;
  const auto wanted =
      even_lines(lines.front(), lines.back(), static_cast<std::size_t>(std::max(count, 2) - 1));
  for (const double line : wanted) {
    const auto nearest = std::ranges::min_element(
        lines, {}, [line](double candidate) { return std::fabs(candidate - line); });
    const auto index = static_cast<std::size_t>(nearest - lines.begin());
    if (result.empty() || result.back() != index) result.push_back(index);
  }
  if (count == 1) result.resize(1);
  return result;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> leaf_lines(const Grid& grid, const CellTree& tree,
                                                   std::span<const Leaf> leaves, int lines_u,
                                                   int lines_v) {
  Chains chains(grid, tree, leaves);
  const auto follow = [&](std::size_t cells, auto place_of) {
    const auto go_to = [&](std::uint32_t vertex, DyadicPoint) { chains.go_to(vertex); };
    for (std::size_t k = 0; k < cells; ++k)
      tree.vertices().walk(place_of(k), place_of(k + 1), go_to);
    chains.go_to(tree.vertices().used_vertex(place_of(cells)).value());
    chains.end_line();
  };
  const auto unit = [](std::size_t line) { return static_cast<std::uint32_t>(line) * kCellUnit; };
  for (const std::size_t i : indices(grid.u, lines_u)) {
    follow(grid.cells_v, [&](std::size_t k) { return DyadicPoint{unit(i), unit(k)}; });
  }
  for (const std::size_t j : indices(grid.v, lines_v)) {
    follow(grid.cells_u, [&](std::size_t k) { return DyadicPoint{unit(k), unit(j)}; });
  }
  return chains.take();
}

}  // namespace saddle
