#include "mesh/features/singular_in_space.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Limits are means of what is around them within some 1e-6 of the ranges: so many diagonals of the
/// surface they may be off.
constexpr double kKnown = 1e-5;

/// Places at which a singular line is sampled.
constexpr std::size_t kLinePlaces = 9;

/// A limit to the decimals that are known of it: at the apex of a cone the mean is beside it.
dvec3 known_decimals(const dvec3& limit, double diagonal) {
  const double unit = std::pow(10, std::ceil(std::log10(kKnown * diagonal)));
  return std::isfinite(unit) && unit > 0 ? unit * glm::round(limit / unit) : limit;
}

class SingularGroups {
 public:
  SingularGroups(const Surface& surface, const Mesh& mesh, const MeshReport& report)
      : surface_(surface), mesh_(mesh), report_(report) {}

  std::vector<SingularInSpace> run() {
    std::vector<dvec2> uv;
    for (const SingularPoint& place : report_.singular_points) uv.push_back(place.uv);
    const std::vector<dvec3> positions = singular_positions(surface_, mesh_, uv);
    for (std::size_t k = 0; k < uv.size(); ++k) {
      SingularInSpace& point = point_at(uv[k], positions[k]);
      const bool is_first = point.places.empty();
      point.is_isolated = report_.singular_points[k].is_alone && (is_first || point.is_isolated);
      point.places.push_back(k);
    }
    for (SingularInSpace& point : points_) {
      if (point.places.size() >= kManyOfLine) point.is_isolated = true;
    }
    const Domain& d = surface_.domain;
    for (const double u : report_.singular_u) take_line({u, d.v0}, {u, d.v1});
    for (const double v : report_.singular_v) take_line({d.u0, v}, {d.u1, v});
    return points_;
  }

 private:
  SingularInSpace& point_at(const dvec2& uv, const dvec3& position) {
    const double near = kSame * mesh_.bounds.diagonal();
    const auto found = std::ranges::find_if(points_, [&](const SingularInSpace& point) {
      return glm::distance(point.position, position) <= near;
    });
    if (found != points_.end()) return *found;
    return points_.emplace_back(SingularInSpace{uv, position, {}, false});
  }

  /// A line whose places are one point of space is an isolated point.
  void take_line(const dvec2& first, const dvec2& last) {
    std::vector<dvec2> uv;
    for (std::size_t k = 0; k < kLinePlaces; ++k) {
      const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(kLinePlaces);
      uv.push_back(glm::mix(first, last, part));
    }
    const std::vector<dvec3> positions = singular_positions(surface_, mesh_, uv);
    const double near = kSame * mesh_.bounds.diagonal();
    const bool is_point = std::ranges::all_of(positions, [&](const dvec3& position) {
      return glm::distance(position, positions.front()) <= near;
    });
    if (is_point) point_at(uv.front(), positions.front()).is_isolated = true;
  }

  const Surface& surface_;
  const Mesh& mesh_;
  const MeshReport& report_;
  std::vector<SingularInSpace> points_;
};

}  // namespace

std::vector<dvec3> singular_positions(const Surface& surface, const Mesh& mesh,
                                      std::span<const dvec2> places) {
  const std::vector<SurfacePoint> points = evaluate(surface, places, 1);
  std::vector<dvec3> positions;
  for (std::size_t k = 0; k < places.size(); ++k) {
    dvec3& position = positions.emplace_back(points[k].position);
    if (is_finite(position)) continue;
    const auto at = std::ranges::find(mesh.uv, places[k]);
    if (at == mesh.uv.end()) continue;
    position = known_decimals(mesh.position[static_cast<std::size_t>(at - mesh.uv.begin())],
                              mesh.bounds.diagonal());
  }
  return positions;
}

std::vector<SingularInSpace> singular_in_space(const Surface& surface, const Mesh& mesh,
                                               const MeshReport& report) {
  return SingularGroups(surface, mesh, report).run();
}

}  // namespace saddle
