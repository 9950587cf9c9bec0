// Where halving comes to no end.
#pragma once

#include <unordered_map>

#include "mesh/lattice.h"

namespace saddle {

/// Where the surface oscillates faster than any picture shows: where a large part of a cell of the
/// root grid is still far off although its leaves are narrow. They are halved no further.
class Oscillation {
 public:
  explicit Oscillation(const Grid& grid) : grid_(grid) {}

  void clear() { areas_.clear(); }
  /// Counts a leaf that is off by so many tolerances.
  void add(const Leaf& leaf, double distance, const Lattice& lattice);
  /// Whether a leaf, narrow as well, is part of an oscillation, as far as leaves have been counted.
  bool contains(const Leaf& leaf, const Lattice& lattice) const;
  /// Whether a leaf is as narrow as half a pixel of a large picture, in one direction.
  bool is_narrow(const Leaf& leaf, const Lattice& lattice) const;

 private:
  std::size_t root_cell(const Leaf& leaf) const;

  const Grid& grid_;
  std::unordered_map<std::size_t, double> areas_;  // of hopeless leaves, in root cells
};

}  // namespace saddle
