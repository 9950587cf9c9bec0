// Vertices in thin parts of sides: defined between undefined neighbours, or undefined between
// defined ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/model/pair_table.h"

namespace saddle {

class ThinVertices {
 public:
  bool any() const { return !is_thin_.empty(); }
  bool contains(std::uint32_t vertex) const {
    return vertex < is_thin_.size() && is_thin_[vertex] != 0;
  }
  void add(std::uint32_t vertex) {
    if (vertex >= is_thin_.size()) is_thin_.resize(vertex + std::size_t{1});
    is_thin_[vertex] = 1;
  }

  /// Whether a side needs a search for thin parts. Notes that it has one.
  bool starts_search(std::uint32_t a, std::uint32_t b) {
    return searched_.insert(pair_of(a, b)).second;
  }

 private:
  std::vector<std::uint8_t> is_thin_;  // of vertices, up to the last such
  PairTable searched_;
};

}  // namespace saddle
