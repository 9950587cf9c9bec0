// Vertices in thin parts of sides: defined between undefined neighbours, or undefined between
// defined ones.
#pragma once

#include <array>
#include <cstdint>
#include <set>

namespace saddle {

class ThinVertices {
 public:
  bool any() const { return !vertices_.empty(); }
  bool contains(std::uint32_t vertex) const { return any() && vertices_.contains(vertex); }
  void add(std::uint32_t vertex) { vertices_.insert(vertex); }

  /// Whether a side, the smaller number first, needs a search for thin parts. Notes that it has
  /// one.
  bool starts_search(const std::array<std::uint32_t, 2>& side) {
    return searched_.insert(side).second;
  }

 private:
  std::set<std::uint32_t> vertices_;
  std::set<std::array<std::uint32_t, 2>> searched_;
};

}  // namespace saddle
