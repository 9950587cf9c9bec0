#include "mesh/mesher/mesher.h"

#include <utility>

#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/mesher/choose.h"
#include "mesh/mesher/sampled_mesh.h"

namespace saddle {

namespace {

std::optional<MeshResult> mesh_by_method(const Surface& surface, const MeshRequest& request) {
  switch (request.method) {
    case MeshRequest::Method::FewestTriangles:
      break;
    case MeshRequest::Method::LeastCost:
      return mesh_at_least_cost(surface, request);
    case MeshRequest::Method::Samples:
      return mesh_of_samples(surface, request);
  }
  std::optional<MeshResult> mesh = mesh_within_tolerance(surface, request);
  if (mesh) mesh->report.choice = MeshChoice();
  return mesh;
}

}  // namespace

std::optional<MeshResult> try_mesh(const Surface& surface, const MeshRequest& request) {
  const std::size_t before = surface.evaluations();
  std::optional<MeshResult> mesh = mesh_by_method(surface, request);
  if (mesh) mesh->report.evaluations = surface.evaluations() - before;
  return mesh;
}

MeshResult make_mesh(const Surface& surface, const MeshRequest& request,
                     const UniformRequest& fallback) {
  std::optional<MeshResult> mesh = try_mesh(surface, request);
  return mesh ? std::move(*mesh) : mesh_uniformly(surface, fallback);
}

}  // namespace saddle
