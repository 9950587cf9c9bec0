// Vertices in thin parts of sides: defined between undefined neighbours, or undefined between
// defined ones.
#pragma once

#include <cstdint>
#include <set>

#include "mesh/model/pair_table.h"

namespace saddle {

class ThinVertices {
 public:
  bool any() const { return !vertices_.empty(); }
  bool contains(std::uint32_t vertex) const { return any() && vertices_.contains(vertex); }
  void add(std::uint32_t vertex) { vertices_.insert(vertex); }

  /// Whether a side needs a search for thin parts. Notes that it has one.
  bool starts_search(std::uint32_t a, std::uint32_t b) {
    return searched_.insert(pair_of(a, b)).second;
  }

 private:
  std::set<std::uint32_t> vertices_;
  PairTable searched_;
};

}  // namespace saddle
