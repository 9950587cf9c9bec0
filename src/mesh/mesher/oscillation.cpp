#include "mesh/mesher/oscillation.h"
#include "mesh/tree/cell_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <glm/vector_relational.hpp>

namespace saddle {

namespace {

/// A leaf is narrow that is so many tolerances wide, or two pixels: no wave within it shows. Ranges
/// are taken for as long as the surface's diagonal.
constexpr double kNarrow = 4;
/// A leaf that is foreseen to be hopeless is narrow enough if it is so many times as wide: cells of
/// a root grid that are about as narrow as they may be need not be halved.
constexpr double kPredictedWidth = 1.5;
/// In ranges: about half a pixel.
constexpr double kSliver = 1.0 / 2048;
/// It is hopeless if errors that fall with the square of its width would have it narrower by this
/// factor, which is a quarter of a tolerance, to be within tolerance.
constexpr double kMostNarrowing = 16;
constexpr double kUnresolvable = kMostNarrowing * kMostNarrowing;
/// Before a mesh is made, so many times as much: the largest of a few samples stand for a whole
/// neighbourhood, of which a part may be within reach yet.
constexpr double kPredictedUnresolvable = 4 * kUnresolvable;
/// Hopeless leaves are an oscillation if they cover this share of a block, which is about so many
/// times as wide as a narrow leaf, or if laid end to end they cross it so many times. Along a line
/// to which the surface is ever steeper, as sqrt and ln are, some ten leaves side by side are still
/// to be halved at any size, and a slanting line meets them twice.
constexpr double kOscillatingShare = 0.4;
constexpr double kBlockWidths = 16;
constexpr double kMostFeatures = 16;
/// Lines of a mesh that are dense make blocks as narrow as leaves: across what is narrow, one leaf
/// counts for no more of a block than this, so that a row of them, along a pole, is no area.
constexpr double kMostOfOne = 0.25;

/// The side of a block in units: root cells, of which a range has so many, halved or doubled.
std::uint32_t block_size(std::size_t cells, double narrow) {
  const double size = kBlockWidths * narrow * static_cast<double>(cells);  // in root cells
  return std::bit_floor(static_cast<std::uint32_t>(std::clamp(size * kCellUnit, 1.0, 0x1p31)));
}

}  // namespace

Oscillation::Oscillation(const Grid& grid, double tolerance)
    : grid_(grid),
      narrow_(kNarrow * tolerance),
      size_u_(block_size(grid.cells_u, narrow_)),
      size_v_(block_size(grid.cells_v, narrow_)) {}

void Oscillation::predict(LinearizationErrors linearization_errors) {
  forecast_ = AliasingForecast(std::move(linearization_errors), kPredictedUnresolvable);
}

glm::bvec2 Oscillation::predicted(const Leaf& leaf, const CellTree& tree) const {
  if (!forecast_.any()) return glm::bvec2(false);
  return forecast_.at(tree.vertices().parameters(leaf.middle()));
}

void Oscillation::add(const Leaf& leaf, const ErrorRatios& distance, const CellTree& tree) {
  if (!(distance.worst() > 1)) return;
  const dvec2 size = size_of(leaf, tree);
  // What a leaf is off by along a side that is not narrow will be less of its halves.
  const bool is_long_in_u = size.x > 1 && distance.along_u > 1;
  const bool is_long_in_v = size.y > 1 && distance.along_v > 1;
  if (is_long_in_u || is_long_in_v) return;
  const auto is_unresolvable = [](double off, double width) {
    return width <= 1 && off > kUnresolvable * width * width;
  };
  const auto [narrower, wider] = std::minmax(size.x, size.y);
  if (is_unresolvable(distance.along_u, size.x) || is_unresolvable(distance.along_v, size.y) ||
      is_unresolvable(distance.centre, wider <= 1 ? wider : narrower)) {
    add(leaf, tree);
  }
}

void Oscillation::add(const Leaf& leaf, const CellTree& tree) {
  double along_u = std::min(1.0, static_cast<double>(leaf.size_u()) / size_u_);
  double along_v = std::min(1.0, static_cast<double>(leaf.size_v()) / size_v_);
  const dvec2 size = size_of(leaf, tree);
  double& across = size.x < size.y ? along_u : along_v;
  across = std::min(across, kMostOfOne);
  Block& block = blocks_[block_of(leaf)];
  block.length += std::max(along_u, along_v);
  block.area += along_u * along_v;
}

bool Oscillation::contains(const Leaf& leaf, const CellTree& tree) const {
  if (glm::any(predicted(leaf, tree))) return !splits_predicted_u(leaf, tree);
  const auto block = blocks_.find(block_of(leaf));
  if (block == blocks_.end()) return false;
  const auto& [area, length] = block->second;
  const dvec2 size = size_of(leaf, tree);
  // A leaf that is narrow in one direction would be halved in the other as well, whenever its
  // samples happen to be alike.
  return (area > kOscillatingShare || length > kMostFeatures) && std::min(size.x, size.y) <= 1;
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

bool Oscillation::is_sliver(const Leaf& leaf, const CellTree& tree) const {
  const dvec2 size = narrow_ * size_of(leaf, tree);
  return std::min(size.x, size.y) <= kSliver;
}

dvec2 Oscillation::size_of(const Leaf& leaf, const CellTree& tree) const {
  const dvec2 size = tree.vertices().parameters(leaf.high) - tree.vertices().parameters(leaf.low);
  return glm::abs(size) / grid_.range / narrow_;
}

std::uint64_t Oscillation::block_of(const Leaf& leaf) const {
  return std::uint64_t{leaf.low.v / size_v_} << 32U | leaf.low.u / size_u_;
}

}  // namespace saddle
