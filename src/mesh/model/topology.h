// The topology of a mesh, from its point numbers alone: Euler number, components, boundary loops.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/model/mesh_report.h"

namespace saddle {

struct Topology {
  long euler_number = 0;           ///< points - edges + triangles
  std::size_t components = 0;      ///< parts that share no point
  std::size_t open_edges = 0;      ///< edges of one triangle
  std::size_t boundary_loops = 0;  ///< parts of the open edges that share no point
  std::size_t shared_edges = 0;    ///< edges of three triangles or more
  std::size_t pinched_points = 0;  ///< points at which sheets touch that share no edge there
  bool orientable = true;          ///< false: the surface is one-sided

  bool is_closed() const { return components > 0 && open_edges == 0 && shared_edges == 0; }
};

/// The parts of a mesh that share edges; one entry per triangle.
struct Parts {
  std::vector<std::uint32_t> first;   ///< the triangle that stands for the part
  std::vector<std::uint8_t> turned;   ///< its winding is opposite to that triangle's
  std::vector<std::uint8_t> is_open;  ///< of that triangle: an edge of the part has not two sides
  std::vector<std::uint8_t> is_one_sided;  ///< of that triangle: the part is

  /// Whether front and back change places within a part, as where a sphere's range of longitudes
  /// ends at pi and that of its latitudes goes all around.
  bool turn_over() const;
};

/// `parts`: filled in, if given.
Topology topology(const Mesh& mesh, Parts* parts = nullptr);

/// Topology::orientable, at less cost. All triangles have the same winding in (u, v), so that only
/// a reversed seam can make a surface one-sided.
bool is_orientable(const Mesh& mesh, const MeshReport& report);

}  // namespace saddle
