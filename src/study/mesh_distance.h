// How far a mesh and the true surface are apart, both ways: the surface's points from the mesh, and
// the mesh's points from the surface.
#pragma once

#include <optional>
#include <vector>

#include "mesh/model/mesh.h"
#include "study/subject.h"

namespace saddle {

/// Points of the true surface that meshes are measured on: spread over the domain, along its edges,
/// and where it bends most.
class MeshDistance {
 public:
  explicit MeshDistance(const Subject& subject);

  /// The larger of both largest distances that were found, in units of length. It is a lower bound:
  /// a distance between the points that were looked at may be larger, by little for a smooth
  /// surface, because the worst points are moved to where they are worst.
  double operator()(const Mesh& mesh) const;

 private:
  double from_surface(const Mesh& mesh) const;
  double from_mesh(const Mesh& mesh, double known) const;

  const Subject& subject_;
  std::vector<dvec2> uv_;  ///< where there is a surface, inside of the clip box
  std::vector<dvec3> points_;
};

}  // namespace saddle
