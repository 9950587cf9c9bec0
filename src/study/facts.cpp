#include "study/facts.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "surface/normal.h"

namespace saddle {

namespace {

/// Boxes that a proof of where the surface is defined may look at: some hundredths of a second.
constexpr std::size_t kBoxes = 20'000;

/// Limits are means of what is around them within some 1e-6 of the ranges: so many diagonals of the
/// surface they may be off.
constexpr double kKnown = 1e-5;

/// A limit to the decimals that are known of it: at the apex of a cone the mean is beside it.
dvec3 known_decimals(const dvec3& limit, double diagonal) {
  const double unit = std::pow(10, std::ceil(std::log10(kKnown * diagonal)));
  return std::isfinite(unit) && unit > 0 ? unit * glm::round(limit / unit) : limit;
}

/// Where the surface is at a place: where it is not defined, the limit that its mesh has there.
dvec3 position_at(const SurfacePoint& point, const dvec2& uv, const Mesh& mesh) {
  if (is_finite(point.position)) return point.position;
  const auto at = std::ranges::find(mesh.uv, uv);
  if (at == mesh.uv.end()) return point.position;
  return known_decimals(mesh.position[static_cast<std::size_t>(at - mesh.uv.begin())],
                        mesh.bounds.diagonal());
}

std::vector<SingularPlace> singular_places(const Surface& surface, const Mesh& mesh,
                                           const MeshReport& report) {
  std::vector<dvec2> uv;
  for (const SingularPoint& point : report.singular_points) uv.push_back(point.uv);
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  std::vector<SingularPlace> places;
  for (std::size_t k = 0; k < uv.size(); ++k) {
    places.push_back({uv[k], position_at(points[k], uv[k], mesh), normals_around(surface, uv[k]),
                      report.singular_points[k].is_alone});
  }
  return places;
}

}  // namespace

Facts gather_facts(const Surface& surface, const Mesh& mesh, const MeshReport& report,
                   bool is_clipped, unsigned threads) {
  Facts facts;
  facts.domain = surface.domain;
  facts.defined = prove_defined(surface, kBoxes);
  facts.topology = topology(mesh);
  Covered covered = report.undefined_fraction == 0 ? Covered::Whole : Covered::Defined;
  if (is_clipped || report.pole_count > 0) covered = Covered::Part;
  facts.measures = measure_surface(surface, mesh, covered, threads);
  facts.singular = singular_places(surface, mesh, report);
  facts.singular_u = report.singular_u;
  facts.singular_v = report.singular_v;
  return facts;
}

}  // namespace saddle
