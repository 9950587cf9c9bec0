#include "study/facts.h"

#include "mesh/features/singular_in_space.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Boxes that a proof of where the surface is defined may look at: some hundredths of a second.
constexpr std::size_t kBoxes = 20'000;

std::vector<SingularPlace> singular_places(const Surface& surface, const Mesh& mesh,
                                           const MeshReport& report) {
  std::vector<dvec2> uv;
  for (const SingularPoint& point : report.singular_points) uv.push_back(point.uv);
  const std::vector<dvec3> positions = singular_positions(surface, mesh, uv);
  std::vector<SingularPlace> places;
  for (std::size_t k = 0; k < uv.size(); ++k) {
    places.push_back(
        {uv[k], positions[k], normals_around(surface, uv[k]), report.singular_points[k].is_alone});
  }
  return places;
}

/// A closed mesh may cover a hole or a jump that lies between its samples.
Closed closed_as_proved(const Facts& facts, const MeshReport& report) {
  if (!facts.topology.is_closed()) return Closed::No;
  const bool covers_hole = report.undefined_fraction == 0 && facts.defined.undefined_at;
  if (covers_hole) return Closed::No;
  return facts.defined.continuous ? Closed::Yes : Closed::Unknown;
}

}  // namespace

Facts gather_facts(const Surface& surface, const Mesh& mesh, const MeshReport& report,
                   bool is_clipped, unsigned threads, double share) {
  Facts facts;
  facts.domain = surface.domain;
  facts.defined = prove_defined(surface, static_cast<std::size_t>(share * kBoxes));
  Parts parts;
  facts.topology = topology(mesh, &parts);
  facts.turns_over = parts.turn_over();
  Covered covered = report.undefined_fraction == 0 ? Covered::Whole : Covered::Defined;
  if (is_clipped || report.pole_count > 0) covered = Covered::Part;
  facts.measures = measure_surface(surface, mesh, parts, covered, threads, share);
  facts.singular = singular_places(surface, mesh, report);
  facts.singular_u = report.singular_u;
  facts.singular_v = report.singular_v;
  facts.closed = closed_as_proved(facts, report);
  return facts;
}

}  // namespace saddle
