// Whether a mesh is a solid for printers: closed, two-sided, its triangles facing outward.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/model/topology.h"

namespace saddle {

struct Shells {
  Topology topology;
  /// For each triangle, whether its winding is to be turned: closed two-sided parts then face
  /// outward, and neighbours of other two-sided parts run along their edge in opposite directions.
  /// Empty: none is.
  std::vector<std::uint8_t> turned;

  bool is_solid() const { return topology.is_closed() && topology.orientable; }
  bool is_turned(std::size_t triangle) const { return !turned.empty() && turned[triangle] != 0; }
};

Shells shells_of(const Mesh& mesh);

std::vector<Shells> shells_of(std::span<const Mesh> meshes);

}  // namespace saddle
