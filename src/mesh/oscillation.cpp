#include "mesh/oscillation.h"

#include <algorithm>

namespace saddle {

namespace {

/// A leaf that is off by so many tolerances although it is no wider than this share of a range,
/// half a pixel of a large picture, is hopeless; an oscillation, if such leaves cover this share of
/// a root cell.
constexpr double kHopeless = 16;
constexpr double kNarrow = 1.0 / 2048;
constexpr double kOscillatingShare = 0.25;

}  // namespace

void Oscillation::add(const Leaf& leaf, double distance, const Lattice& lattice) {
  if (!(distance > kHopeless) || !is_narrow(leaf, lattice)) return;
  const double area = static_cast<double>(leaf.size_u()) / kCellUnit * leaf.size_v() / kCellUnit;
  areas_[root_cell(leaf)] += area;
}

bool Oscillation::contains(const Leaf& leaf, const Lattice& lattice) const {
  if (areas_.empty()) return false;
  const auto found = areas_.find(root_cell(leaf));
  return found != areas_.end() && found->second > kOscillatingShare && is_narrow(leaf, lattice);
}

// A leaf that is narrow in one direction would be halved in the other as well, whenever its samples
// happen to be alike.
bool Oscillation::is_narrow(const Leaf& leaf, const Lattice& lattice) const {
  const dvec2 size = lattice.parameters(leaf.high) - lattice.parameters(leaf.low);
  const dvec2 share = glm::abs(size) / grid_.range;
  return std::min(share.x, share.y) <= kNarrow;
}

std::size_t Oscillation::root_cell(const Leaf& leaf) const {
  return grid_.cell(leaf.low.u / kCellUnit, leaf.low.v / kCellUnit);
}

}  // namespace saddle
