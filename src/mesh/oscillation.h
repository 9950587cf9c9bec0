// Where halving comes to no end.
#pragma once

#include <unordered_map>

#include "mesh/lattice.h"

namespace saddle {

/// Where the surface oscillates faster than any picture shows: where leaves that are narrow and
/// still far off fill an area, as no jump does, which is a line. They are halved no further.
class Oscillation {
 public:
  explicit Oscillation(const Grid& grid);

  void clear() {
    areas_.clear();
    lengths_.clear();
  }
  /// Counts a leaf that is off by so many tolerances.
  void add(const Leaf& leaf, double distance, const Lattice& lattice);
  /// Whether a leaf, narrow as well, is part of an oscillation, as far as leaves have been counted.
  bool contains(const Leaf& leaf, const Lattice& lattice) const;
  /// The same, where there is also no use in looking for what cuts it: jumps would be too many.
  bool is_crowded(const Leaf& leaf, const Lattice& lattice) const;
  /// Whether a leaf is as narrow as half a pixel of a large picture, in one direction.
  bool is_narrow(const Leaf& leaf, const Lattice& lattice) const;

 private:
  double width_of(const Leaf& leaf, const Lattice& lattice) const;  ///< in ranges
  std::size_t root_cell(const Leaf& leaf) const;
  std::uint64_t block_of(const Leaf& leaf) const;

  const Grid& grid_;
  std::uint32_t size_u_, size_v_;                      ///< of a block, in units
  std::unordered_map<std::size_t, double> areas_;      // of hopeless leaves, in root cells
  std::unordered_map<std::uint64_t, double> lengths_;  // of their longer sides, in blocks' sides
};

}  // namespace saddle
