#include "mesh/oscillation.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace saddle {

namespace {

/// A leaf that is off by so many tolerances although it is no wider than this share of a range,
/// half a pixel of a large picture, is hopeless; a narrower one is by as much less.
constexpr double kHopeless = 16;
constexpr double kNarrow = 1.0 / 2048;
/// Hopeless leaves are an oscillation if they cover this share of a root cell; in large cells, if
/// laid end to end they cross a block, which is about so many times as wide, so many times. Along a
/// line to which the surface is ever steeper, as sqrt and ln are, some ten leaves side by side are
/// still to be halved at any size, and a slanting line meets them twice.
constexpr double kOscillatingShare = 0.25;
constexpr double kBlock = 16;
constexpr double kMostLines = 16;

/// The side of a block in units: root cells, of which a range has so many, halved or doubled.
std::uint32_t block_size(std::size_t cells) {
  const double size = kBlock * kNarrow * static_cast<double>(cells);  // in root cells
  return std::bit_floor(static_cast<std::uint32_t>(std::max(size * kCellUnit, 1.0)));
}

}  // namespace

Oscillation::Oscillation(const Grid& grid)
    : grid_(grid), size_u_(block_size(grid.cells_u)), size_v_(block_size(grid.cells_v)) {}

void Oscillation::add(const Leaf& leaf, double distance, const Lattice& lattice) {
  if (!(distance > 1)) return;
  const double width = width_of(leaf, lattice);
  if (!(width <= kNarrow) || !(distance > kHopeless * width / kNarrow)) return;
  const double along_u = static_cast<double>(leaf.size_u()) / size_u_;
  const double along_v = static_cast<double>(leaf.size_v()) / size_v_;
  lengths_[block_of(leaf)] += std::min(1.0, std::max(along_u, along_v));
  if (!(distance > kHopeless)) return;
  const double area = static_cast<double>(leaf.size_u()) / kCellUnit * leaf.size_v() / kCellUnit;
  areas_[root_cell(leaf)] += area;
}

bool Oscillation::contains(const Leaf& leaf, const Lattice& lattice) const {
  if (lengths_.empty() || !is_narrow(leaf, lattice)) return false;
  const auto area = areas_.find(root_cell(leaf));
  if (area != areas_.end() && area->second > kOscillatingShare) return true;
  return is_crowded(leaf, lattice);
}

bool Oscillation::is_crowded(const Leaf& leaf, const Lattice& lattice) const {
  const auto length = lengths_.find(block_of(leaf));
  return length != lengths_.end() && length->second > kMostLines && is_narrow(leaf, lattice);
}

// A leaf that is narrow in one direction would be halved in the other as well, whenever its samples
// happen to be alike.
bool Oscillation::is_narrow(const Leaf& leaf, const Lattice& lattice) const {
  return width_of(leaf, lattice) <= kNarrow;
}

double Oscillation::width_of(const Leaf& leaf, const Lattice& lattice) const {
  const dvec2 size = lattice.parameters(leaf.high) - lattice.parameters(leaf.low);
  const dvec2 share = glm::abs(size) / grid_.range;
  return std::min(share.x, share.y);
}

std::size_t Oscillation::root_cell(const Leaf& leaf) const {
  return grid_.cell(leaf.low.u / kCellUnit, leaf.low.v / kCellUnit);
}

std::uint64_t Oscillation::block_of(const Leaf& leaf) const {
  return std::uint64_t{leaf.low.v / size_v_} << 32U | leaf.low.u / size_u_;
}

}  // namespace saddle
