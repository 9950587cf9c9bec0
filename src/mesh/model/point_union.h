// Which corners of a mesh are the same point of the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

/// Unites points of a mesh that is being made. Until settle() mesh.point holds trees of corners;
/// then the name of a point is its first corner's number. The mesh may grow in the meantime, by
/// corners that may be the points of others.
class PointUnion {
 public:
  explicit PointUnion(Mesh& mesh) : mesh_(mesh) {}

  void unite(std::size_t a, std::size_t b);

  /// Names every corner's point, and gives it the position of the point's first corner.
  void settle();
  /// The corners that are not the first of their points, of points that have grown since this was
  /// last asked; settled.
  std::vector<std::uint32_t> take_changed();

 private:
  std::uint32_t find(std::uint32_t corner);

  Mesh& mesh_;
  std::vector<std::uint32_t> others_;  // corners that are not the first, but of the newest ones
  std::uint32_t oldest_new_ = 0;       // from here on nobody has looked which are
  std::vector<std::uint32_t> grown_;   // corners of points that have grown
  bool is_settled_ = true;
};

}  // namespace saddle
