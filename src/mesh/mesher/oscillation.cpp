#include "mesh/mesher/oscillation.h"
#include "mesh/tree/cell_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <glm/vector_relational.hpp>

namespace saddle {

namespace {

/// Unresolvable leaves are an oscillation if they cover 0.4 of a block, which is 16 narrow leaves
/// wide, or if laid end to end they cross it 16 times. Along a line with a vertical tangent, as of
/// sqrt and ln, about ten leaves side by side fail at any size, twice as many along a slanting
/// line.
constexpr double kBlockWidths = 16;
/// Across its narrow direction a leaf counts for at most 1/4 of a block. Where root lines are
/// dense, blocks are as narrow as leaves, and a row of leaves along a pole would fill them.
constexpr double kMostOfOne = 0.25;
/// An error at its centre does not tell a leaf's direction. One longer than 4 blocks is halved
/// across before it is called unresolvable by that error: the error may be that of its length.
constexpr double kLong = 4 * kBlockWidths;

/// The side of a block in units: a root cell, halved or doubled. `cells`: of the range.
std::uint32_t block_size(std::size_t cells, double narrow) {
  const double size = kBlockWidths * narrow * static_cast<double>(cells);  // in root cells
  return std::bit_floor(static_cast<std::uint32_t>(std::clamp(size * kCellUnit, 1.0, 0x1p31)));
}

std::uint64_t block_number(std::uint32_t u, std::uint32_t v) {
  return std::uint64_t{v} << 32U | u;
}

}  // namespace

Oscillation::Oscillation(const Grid& grid, double tolerance)
    : grid_(grid),
      narrow_(kNarrow * tolerance),
      size_u_(block_size(grid.cells_u, narrow_)),
      size_v_(block_size(grid.cells_v, narrow_)) {}

void Oscillation::predict(LinearizationErrors linearization_errors) {
  forecast_ = AliasingForecast(std::move(linearization_errors));
}

glm::bvec2 Oscillation::predicted(const Leaf& leaf, const CellTree& tree) const {
  if (!forecast_.any()) return glm::bvec2(false);
  return forecast_.at(tree.vertices().parameters(leaf.middle()));
}

void Oscillation::add(const Leaf& leaf, const ErrorRatios& distance, const CellTree& tree) {
  if (!(distance.worst() > 1)) return;
  const dvec2 size = size_of(leaf, tree);
  // Halving reduces the error along a side that is not narrow.
  const bool is_long_in_u = size.x > 1 && distance.along_u > 1;
  const bool is_long_in_v = size.y > 1 && distance.along_v > 1;
  if (is_long_in_u || is_long_in_v) return;
  const auto is_unresolvable = [](double ratio, double width) {
    return width <= 1 && ratio > kUnresolvable * width * width;
  };
  const auto [narrower, wider] = std::minmax(size.x, size.y);
  if (is_unresolvable(distance.along_u, size.x) || is_unresolvable(distance.along_v, size.y) ||
      is_unresolvable(distance.centre, wider <= 1 || wider > kLong ? wider : narrower)) {
    add(leaf, tree);
  }
}

void Oscillation::add(const Leaf& leaf, const CellTree& tree) {
  double along_u = std::min(1.0, static_cast<double>(leaf.size_u()) / size_u_);
  double along_v = std::min(1.0, static_cast<double>(leaf.size_v()) / size_v_);
  const dvec2 size = size_of(leaf, tree);
  double& across = size.x < size.y ? along_u : along_v;
  across = std::min(across, kMostOfOne);
  Block& block = blocks_[block_number(leaf.low.u / size_u_, leaf.low.v / size_v_)];
  block.length += std::max(along_u, along_v);
  block.area += along_u * along_v;
}

bool Oscillation::contains(const Leaf& leaf, const CellTree& tree) const {
  if (glm::any(predicted(leaf, tree))) return !splits_predicted_u(leaf, tree);
  const dvec2 size = size_of(leaf, tree);
  // One narrow direction is enough: a leaf whose samples happen to be alike would be halved in the
  // other one as well.
  if (blocks_.empty() || std::min(size.x, size.y) > 1) return false;
  const std::uint32_t u = leaf.low.u / size_u_;
  const std::uint32_t v = leaf.low.v / size_v_;
  if (fills(u, v)) return true;
  // Waves beside a slanting line touch only the corners of some blocks: leaves of at most a
  // tolerance are part of an oscillation also beside a block that one fills.
  if (std::max(size.x, size.y) > 1 / kNarrow) return false;
  // Numbers below 0 wrap around to blocks that there are not.
  return fills(u - 1, v) || fills(u + 1, v) || fills(u, v - 1) || fills(u, v + 1);
}

bool Oscillation::fills(std::uint32_t u, std::uint32_t v) const {
  const auto block = blocks_.find(block_number(u, v));
  if (block == blocks_.end()) return false;
  const auto& [area, length] = block->second;
  return area > kOscillatingShare || length > kBlockWidths;
}

std::optional<bool> Oscillation::splits_predicted_u(const Leaf& leaf, const CellTree& tree) const {
  const glm::bvec2 is_predicted = predicted(leaf, tree);
  if (!glm::any(is_predicted)) return std::nullopt;
  const dvec2 size = size_of(leaf, tree);
  const bool is_wide_u = is_predicted.x && size.x > kPredictedWidth;
  const bool is_wide_v = is_predicted.y && size.y > kPredictedWidth;
  if (!is_wide_u && !is_wide_v) return std::nullopt;
  return is_wide_u && (!is_wide_v || size.x >= size.y);
}

dvec2 Oscillation::size_of(const Leaf& leaf, const CellTree& tree) const {
  const dvec2 size = tree.vertices().parameters(leaf.high()) - tree.vertices().parameters(leaf.low);
  return glm::abs(size) / grid_.range / narrow_;
}

}  // namespace saddle
