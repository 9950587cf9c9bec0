// Welding: a union-find of the corners that are the same point of the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

/// Unites points of a mesh that is being made. Until settle() mesh.point holds trees of corners;
/// afterwards it holds the number of each point's first corner. The mesh may grow in the meantime.
class PointUnion {
 public:
  explicit PointUnion(Mesh& mesh) : mesh_(mesh) {}

  void unite(std::size_t a, std::size_t b);

  /// Gives every corner the number and the position of its point's first corner.
  void settle();
  /// The corners, but for the first, of points that have grown since the last call. settle() must
  /// have been called.
  std::vector<std::uint32_t> take_changed();

 private:
  std::uint32_t find(std::uint32_t corner);

  Mesh& mesh_;
  std::vector<std::uint32_t> others_;  // corners below oldest_new_ that are not the first
  std::uint32_t oldest_new_ = 0;       // number of corners that settle() has seen
  std::vector<std::uint32_t> grown_;   // a corner of each point that has grown
  bool is_settled_ = true;
};

}  // namespace saddle
