#include "mesh/mesher/mesher.h"

#include <utility>

#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/mesher/sampled_mesh.h"

namespace saddle {

std::optional<MeshResult> try_mesh(const Surface& surface, const MeshRequest& request) {
  const std::size_t before = surface.evaluations();
  std::optional<MeshResult> mesh =
      request.samples ? mesh_of_samples(surface, request) : mesh_within_tolerance(surface, request);
  if (mesh) mesh->report.evaluations = surface.evaluations() - before;
  return mesh;
}

MeshResult make_mesh(const Surface& surface, const MeshRequest& request,
                     const UniformRequest& fallback) {
  std::optional<MeshResult> mesh = try_mesh(surface, request);
  return mesh ? std::move(*mesh) : mesh_uniformly(surface, fallback);
}

}  // namespace saddle
