#include "study/check_surface.h"

#include <algorithm>
#include <span>
#include <utility>

#include "base/activity.h"
#include "mesh/sizing/effort.h"
#include "meshing/tolerance.h"

namespace saddle {
namespace {

/// Places of a short formula that one may take as long as before it is checked with less work.
constexpr double kLongPlace = 8;

/// The share of its checks' work that a surface may have: less if it is one of many surfaces, or of
/// a long formula.
double share_of_checks(const Scene& scene, const Surface& surface) {
  return share_of_searches(least_effort(scene)) *
         std::min(1.0, kLongPlace / Effort(surface).place());
}

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
  result.facts = gather_facts(surface, meshed.mesh.mesh, meshed.mesh.report, meshed.is_clipped,
                              threads, share_of_checks(scene, surface));
  result.tessellation = tessellation_of(spec, std::move(meshed));
  result.facts.where = spec.where;
  name_parameters(surface, spec, result.tessellation.domain, result.facts);
  return result;
}

}  // namespace saddle
