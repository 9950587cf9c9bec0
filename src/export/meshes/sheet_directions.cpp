#include "export/meshes/sheet_directions.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/numbers.h"
#include "mesh/solid/fans.h"
#include "mesh/solid/joined_sides.h"

namespace saddle {
namespace {

/// Normals that differ by less are one: of a point that was computed twice, on both sides of a
/// seam.
constexpr double kSameNormal = 1e-9;

/// The points at which corners have several normals; empty: there are none.
std::vector<bool> creased_points(const Mesh& mesh) {
  std::vector<std::uint32_t> first(mesh.point_count, kNoIndex);
  std::vector<bool> is_creased;
  for (std::uint32_t corner = 0; corner < mesh.point.size(); ++corner) {
    std::uint32_t& known = first[mesh.point[corner]];
    if (known == kNoIndex) known = corner;
    const dvec3 difference = mesh.normal[corner] - mesh.normal[known];
    // Also where a normal is no number.
    if (glm::length(difference) <= kSameNormal) continue;
    is_creased.resize(mesh.point_count);
    is_creased[mesh.point[corner]] = true;
  }
  return is_creased;
}

/// The triangles around some points of a mesh, with numbers of their own.
struct Surroundings {
  Mesh mesh;                          ///< positions, normals, points and triangles alone
  std::vector<std::uint32_t> corner;  ///< those of the whole mesh

  Surroundings(const Mesh& whole, const std::vector<bool>& is_wanted) {
    std::unordered_map<std::uint32_t, std::uint32_t> corners;
    std::unordered_map<std::uint32_t, std::uint32_t> points;
    for (const Triangle& t : whole.triangles) {
      const std::array<std::uint32_t, 3> p = {whole.point[t[0]], whole.point[t[1]],
                                              whole.point[t[2]]};
      const bool is_flat = p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
      if (is_flat || !(is_wanted[p[0]] || is_wanted[p[1]] || is_wanted[p[2]])) continue;
      Triangle own{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto next = static_cast<std::uint32_t>(corner.size());
        const auto [known, is_new] = corners.try_emplace(t[k], next);
        own[k] = known->second;
        if (!is_new) continue;
        corner.push_back(t[k]);
        mesh.position.push_back(dvec3(whole.position[t[k]]));
        mesh.normal.push_back(dvec3(whole.normal[t[k]]));
        const auto number = static_cast<std::uint32_t>(points.size());
        mesh.point.push_back(std::uint32_t{points.try_emplace(p[k], number).first->second});
      }
      mesh.triangles.push_back(own);
    }
    mesh.point_count = static_cast<std::uint32_t>(points.size());
  }
};

}  // namespace

SheetDirections::SheetDirections(const Mesh& mesh) : normal_(mesh.normal) {
  const std::vector<bool> is_wanted = creased_points(mesh);
  if (is_wanted.empty()) return;
  is_creased_.resize(mesh.position.size());
  const Surroundings around(mesh, is_wanted);
  const Fans fans = fans_of(around.mesh, join_sides(around.mesh));
  for (std::size_t k = 0; k < fans.of.size(); ++k) {
    const std::uint32_t corner = around.corner[around.mesh.triangles[k / 3][k % 3]];
    if (!is_wanted[mesh.point[corner]] || is_creased_[corner]) continue;
    const dvec3& direction = fans.direction[fans.of[k]];
    is_creased_[corner] = true;
    at_creases_.emplace(corner, fans.turned[k] != 0 ? -direction : direction);
  }
}

}  // namespace saddle
