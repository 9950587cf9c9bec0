// Which corners of a mesh are the same point of the surface.
#pragma once

#include "mesh/mesh.h"

namespace saddle {

/// Unites points of a mesh that is being made. Until settle() mesh.point holds trees of corners;
/// then the name of a point is its first corner's number.
class Points {
 public:
  explicit Points(Mesh& mesh) : mesh_(mesh) {}

  void unite(std::size_t a, std::size_t b);

  /// Names every corner's point, and gives it the position of the point's first corner.
  void settle();

 private:
  std::uint32_t find(std::uint32_t corner);

  Mesh& mesh_;
  bool is_settled_ = true;
};

}  // namespace saddle
