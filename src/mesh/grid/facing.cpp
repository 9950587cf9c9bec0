#include "mesh/grid/facing.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/common.hpp>

#include "mesh/grid/corners.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// A corner of a triangle that its normal opposes.
struct Opposed {
  std::size_t triangle;
  std::size_t slot;
  std::uint32_t corner;
};

/// Not a unit vector.
dvec3 area_of(const Mesh& mesh, const Triangle& t) {
  const dvec3& first = mesh.position[t[0]];
  return glm::cross(mesh.position[t[1]] - first, mesh.position[t[2]] - first);
}

/// Whether the normals of a triangle's corners are alike. If they oppose the triangle then, it is a
/// sliver, whose own normal means nothing.
bool have_like_normals(const Mesh& mesh, const Triangle& t) {
  const dvec3& first = mesh.normal[t[0]];
  return glm::dot(first, mesh.normal[t[1]]) > kSteepCosine &&
         glm::dot(first, mesh.normal[t[2]]) > kSteepCosine;
}

std::vector<Opposed> opposed_corners(const std::function<bool(std::uint32_t)>& is_singular,
                                     const Mesh& mesh) {
  std::vector<Opposed> result;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const Triangle& t = mesh.triangles[k];
    if (std::ranges::none_of(t, is_singular) || have_like_normals(mesh, t)) continue;
    const dvec3 area = area_of(mesh, t);
    for (std::size_t slot = 0; slot < 3; ++slot) {
      if (is_singular(t[slot]) && glm::dot(area, mesh.normal[t[slot]]) < 0)
        result.push_back({k, slot, t[slot]});
    }
  }
  std::ranges::stable_sort(result, {}, &Opposed::corner);
  return result;
}

/// The first of these normals, from near to far, within 60 degrees of the triangle's; else the one
/// nearest to it; nothing if all oppose it.
std::optional<dvec3> first_facing(std::span<const std::optional<dvec3>> normals,
                                  const dvec3& front) {
  std::optional<dvec3> best;
  for (const std::optional<dvec3>& normal : normals) {
    if (!normal) continue;
    const double facing = glm::dot(*normal, front);
    if (facing > kSteepCosine) return normal;
    if (facing > (best ? glm::dot(*best, front) : 0)) best = normal;
  }
  return best;
}

std::vector<std::optional<dvec3>> normals_within(const Surface& surface, unsigned threads,
                                                 const Mesh& mesh,
                                                 std::span<const Opposed> opposed) {
  std::vector<dvec2> uv;
  uv.reserve(kAwayFromPlace.size() * opposed.size());
  for (const Opposed& o : opposed) {
    const Triangle& t = mesh.triangles[o.triangle];
    const dvec2 middle = (mesh.uv[t[0]] + mesh.uv[t[1]] + mesh.uv[t[2]]) / 3.0;
    for (const double share : kAwayFromPlace)
      uv.push_back(glm::mix(mesh.uv[o.corner], middle, share));
  }
  std::vector<std::optional<dvec3>> normals;
  normals.reserve(uv.size());
  for (const SurfacePoint& point : evaluate(surface, uv, threads)) {
    normals.push_back(
        unit_normal(point, safe_length(point.r_u), safe_length(point.r_v), surface.flip));
  }
  return normals;
}

}  // namespace

void face_own_triangles(const Surface& surface, unsigned threads,
                        const std::function<bool(std::uint32_t)>& is_singular, Mesh& mesh) {
  const std::vector<Opposed> opposed = opposed_corners(is_singular, mesh);
  const std::vector<std::optional<dvec3>> within = normals_within(surface, threads, mesh, opposed);
  std::uint32_t first_new = 0;  // of the corners that were added for the same one
  for (std::size_t k = 0; k < opposed.size(); ++k) {
    const auto& [number, slot, corner] = opposed[k];
    if (k == 0 || opposed[k - 1].corner != corner) {
      first_new = static_cast<std::uint32_t>(mesh.position.size());
    }
    Triangle& t = mesh.triangles[number];
    const dvec3 front = glm::normalize(area_of(mesh, t));
    const auto normal = first_facing(
        std::span(within).subspan(k * kAwayFromPlace.size(), kAwayFromPlace.size()), front);
    if (!normal) continue;
    std::uint32_t other = first_new;
    while (other < mesh.position.size() && !(glm::dot(mesh.normal[other], front) > kSteepCosine)) {
      ++other;
    }
    t[slot] = other < mesh.position.size() ? other : add_corner(mesh, corner, *normal);
  }
}

}  // namespace saddle
