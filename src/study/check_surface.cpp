#include "study/check_surface.h"

#include <span>
#include <utility>

#include "base/activity.h"

namespace saddle {
namespace {

/// Puts the user's (u, v) in place of the surface's parameters where v depends on u. `domain`: that
/// of the mesh in the user's.
void name_parameters(const Surface& surface, const SurfaceSpec& spec, const Domain& domain,
                     Facts& facts) {
  if (surface.v.outputs.empty()) return;
  facts.range_v = spec.v.min + ":" + spec.v.max;
  facts.domain = domain;
  facts.singular_v.clear();  // lines of constant s have no constant v
  for (SingularPlace& place : facts.singular) {
    take_user_parameters(surface, std::span(&place.uv, 1));
  }
  for (auto* const place : {&facts.defined.undefined_at, &facts.defined.undecided_at,
                            &facts.measures.gauss.falls_toward, &facts.measures.gauss.grows_toward,
                            &facts.measures.mean.falls_toward, &facts.measures.mean.grows_toward}) {
    if (*place) take_user_parameters(surface, std::span(&**place, 1));
  }
}

}  // namespace

CheckedSurface check_surface(const Scene& scene, const SurfaceSpec& spec, unsigned threads) {
  Activity stages("checking", 2);
  MeshedSurface meshed = [&] {
    const Activity meshing("meshing");
    return mesh_surface(scene, spec, {.mesh = true}, threads);
  }();
  stages.advance();
  const Activity gathering("integrals and extremes");
  const Surface surface = meshed.prepared.surface;
  CheckedSurface result;
  result.facts =
      gather_facts(surface, meshed.mesh.mesh, meshed.mesh.report, meshed.is_clipped, threads);
  result.tessellation = tessellation_of(spec, std::move(meshed));
  result.facts.where = spec.where;
  name_parameters(surface, spec, result.tessellation.domain, result.facts);
  return result;
}

}  // namespace saddle
