#include "mesh/mesher/oscillation.h"

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
constexpr double kForeseenWidth = 1.5;
/// In ranges: about half a pixel.
constexpr double kSliver = 1.0 / 2048;
/// It is hopeless if errors that fall with the square of its width would have it narrower by this
/// factor, which is a quarter of a tolerance, to be within tolerance.
constexpr double kMostNarrowing = 16;
constexpr double kHopeless = kMostNarrowing * kMostNarrowing;
/// Before a mesh is made, so many times as much: the largest of a few samples stand for a whole
/// neighbourhood, of which a part may be within reach yet.
constexpr double kForeseenHopeless = 4 * kHopeless;
/// Hopeless leaves are an oscillation if they cover this share of a block, which is about so many
/// times as wide as a narrow leaf, or if laid end to end they cross it so many times. Along a line
/// to which the surface is ever steeper, as sqrt and ln are, some ten leaves side by side are still
/// to be halved at any size, and a slanting line meets them twice.
constexpr double kOscillatingShare = 0.4;
constexpr double kBlockWidths = 16;
constexpr double kMostCrossings = 16;
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

void Oscillation::foresee(Departures departures) {
  forecast_ = Forecast(std::move(departures), kForeseenHopeless);
}

glm::bvec2 Oscillation::foreseen(const Leaf& leaf, const Lattice& lattice) const {
  if (!forecast_.any()) return glm::bvec2(false);
  return forecast_.at(lattice.parameters(leaf.middle()));
}

void Oscillation::add(const Leaf& leaf, const Scores& distance, const Lattice& lattice) {
  if (!(distance.worst() > 1)) return;
  const dvec2 size = size_of(leaf, lattice);
  // What a leaf is off by along a side that is not narrow will be less of its halves.
  const bool is_long_in_u = size.x > 1 && distance.along_u > 1;
  const bool is_long_in_v = size.y > 1 && distance.along_v > 1;
  if (is_long_in_u || is_long_in_v) return;
  const auto is_hopeless = [](double off, double width) {
    return width <= 1 && off > kHopeless * width * width;
  };
  const auto [narrower, wider] = std::minmax(size.x, size.y);
  if (is_hopeless(distance.along_u, size.x) || is_hopeless(distance.along_v, size.y) ||
      is_hopeless(distance.centre, wider <= 1 ? wider : narrower)) {
    add(leaf, lattice);
  }
}

void Oscillation::add(const Leaf& leaf, const Lattice& lattice) {
  double along_u = std::min(1.0, static_cast<double>(leaf.size_u()) / size_u_);
  double along_v = std::min(1.0, static_cast<double>(leaf.size_v()) / size_v_);
  const dvec2 size = size_of(leaf, lattice);
  double& across = size.x < size.y ? along_u : along_v;
  across = std::min(across, kMostOfOne);
  Block& block = blocks_[block_of(leaf)];
  block.length += std::max(along_u, along_v);
  block.area += along_u * along_v;
}

bool Oscillation::contains(const Leaf& leaf, const Lattice& lattice) const {
  if (glm::any(foreseen(leaf, lattice))) return !splits_foreseen_u(leaf, lattice);
  const auto block = blocks_.find(block_of(leaf));
  if (block == blocks_.end()) return false;
  const auto& [area, length] = block->second;
  const dvec2 size = size_of(leaf, lattice);
  // A leaf that is narrow in one direction would be halved in the other as well, whenever its
  // samples happen to be alike.
  return (area > kOscillatingShare || length > kMostCrossings) && std::min(size.x, size.y) <= 1;
}

std::optional<bool> Oscillation::splits_foreseen_u(const Leaf& leaf, const Lattice& lattice) const {
  const glm::bvec2 is_foreseen = foreseen(leaf, lattice);
  if (!glm::any(is_foreseen)) return std::nullopt;
  const dvec2 size = size_of(leaf, lattice);
  const bool is_wide_u = is_foreseen.x && size.x > kForeseenWidth;
  const bool is_wide_v = is_foreseen.y && size.y > kForeseenWidth;
  if (!is_wide_u && !is_wide_v) return std::nullopt;
  return is_wide_u && (!is_wide_v || size.x >= size.y);
}

bool Oscillation::is_sliver(const Leaf& leaf, const Lattice& lattice) const {
  const dvec2 size = narrow_ * size_of(leaf, lattice);
  return std::min(size.x, size.y) <= kSliver;
}

dvec2 Oscillation::size_of(const Leaf& leaf, const Lattice& lattice) const {
  const dvec2 size = lattice.parameters(leaf.high) - lattice.parameters(leaf.low);
  return glm::abs(size) / grid_.range / narrow_;
}

std::uint64_t Oscillation::block_of(const Leaf& leaf) const {
  return std::uint64_t{leaf.low.v / size_v_} << 32U | leaf.low.u / size_u_;
}

}  // namespace saddle
