#include "mesh/features/creases.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/features/search_chunks.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Halvings that end most searches for creases; the others go on with heights.
constexpr int kPlainHalvings = 8;

/// Where normals can only jump to their opposites, unit normals nearer to each other have no cusp
/// between them, unless the surface turns back by 166 degrees.
constexpr double kNearOpposites = 0.25;

}  // namespace

std::vector<LocatedDiscontinuity> find_creases(const Surface& surface, std::span<const Line> lines,
                                               std::span<const std::array<dvec3, 2>> normals,
                                               unsigned threads, Patience& patience,
                                               std::size_t& work) {
  const double chord = 2 * std::sin(0.5 * kCreaseDegrees * std::numbers::pi / 180);
  const auto [open, only_cusps] = unproved_normals(surface, lines, patience, work);
  std::vector<Bracket> gaps;
  gaps.reserve(open.size());
  for (const std::size_t k : open) gaps.push_back({lines[k], lines[k], normals[k]});
  const auto normal = [](const SurfacePoint& point) {
    return normal_direction(point).value_or(dvec3(kNan));
  };
  const auto height = [](const std::array<dvec3, 2>& at_ends, const SurfacePoint& point) {
    return glm::dot(glm::cross(point.r_u, point.r_v), at_ends[0] - at_ends[1]);
  };
  const BisectedVector turning = {.value = normal,
                                  .height = height,
                                  .delta = only_cusps ? kNearOpposites : chord,
                                  .beyond = chord,
                                  .are_positions = false,
                                  .plain = kPlainHalvings};
  const std::vector<LocatedDiscontinuity> found =
      search_chunks(std::span<const Bracket>(gaps), kInBatch / 2, threads, work,
                    [&](std::span<const Bracket> some, std::size_t& own) {
                      return bisect_discontinuities(surface, some, turning, 1, own);
                    });
  std::vector<LocatedDiscontinuity> result(lines.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    result[open[i]] = found[i];
    result[open[i]].is_cusp = only_cusps && found[i].kind != Discontinuity::None;
  }
  return result;
}

}  // namespace saddle
