#include "study/facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "surface/normal.h"

namespace saddle {

namespace {

/// Boxes that a proof of where the surface is defined may look at: some hundredths of a second.
constexpr std::size_t kBoxes = 20'000;
/// How far from a singular point its sides are looked at, as a part of the ranges.
constexpr double kBeside = 1.0 / 128;
/// On so many ways, aslant to the axes: two of them are within the corner of a domain.
constexpr std::size_t kWays = 8;
/// Limits that differ by no more are one, degrees: those of regular surfaces agree to 1e-7.
constexpr double kSameDegrees = 1e-3;

bool is_inside(const Domain& d, const dvec2& uv) {
  return uv.x >= std::min(d.u0, d.u1) && uv.x <= std::max(d.u0, d.u1) &&
         uv.y >= std::min(d.v0, d.v1) && uv.y <= std::max(d.v0, d.v1);
}

/// Ways from within the domain to a point of it, as many through each quarter.
std::vector<Approach> ways_to(const Domain& d, const dvec2& uv) {
  const dvec2 step = kBeside * dvec2(d.u1 - d.u0, d.v1 - d.v0);
  std::vector<Approach> ways;
  for (std::size_t k = 0; k < kWays; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.3) / kWays;
    const dvec2 inside = uv + dvec2(std::cos(angle), std::sin(angle)) * step;
    if (is_inside(d, inside)) ways.push_back({uv, inside});
  }
  return ways;
}

std::vector<dvec3> distinct_limits(const Surface& surface, const dvec2& uv) {
  std::vector<dvec3> normals;
  for (const NormalLimit& limit : limit_normals(surface, ways_to(surface.domain, uv), 1)) {
    if (!limit.normal) continue;
    const auto is_same = [&](const dvec3& n) {
      return degrees_between(n, *limit.normal) <= kSameDegrees;
    };
    if (std::ranges::none_of(normals, is_same)) normals.push_back(*limit.normal);
  }
  return normals;
}

/// Where the surface is at a place: where it is not defined, the limit that its mesh has there.
dvec3 position_at(const SurfacePoint& point, const dvec2& uv, const Mesh& mesh) {
  if (is_finite(point.position)) return point.position;
  const auto at = std::ranges::find(mesh.uv, uv);
  return at == mesh.uv.end() ? point.position
                             : mesh.position[static_cast<std::size_t>(at - mesh.uv.begin())];
}

std::vector<SingularPlace> singular_places(const Surface& surface, const Mesh& mesh,
                                           const MeshReport& report) {
  std::vector<dvec2> uv;
  for (const SingularPoint& point : report.singular_points) uv.push_back(point.uv);
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  std::vector<SingularPlace> places;
  for (std::size_t k = 0; k < uv.size(); ++k) {
    places.push_back({uv[k], position_at(points[k], uv[k], mesh), distinct_limits(surface, uv[k]),
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
