#include "mesh/distance/edge_turns.h"

#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/distance/sampled_error.h"
#include "mesh/features/bisect_together.h"
#include "mesh/features/removable.h"
#include "mesh/features/sheet_ends.h"
#include "mesh/model/clip.h"
#include "mesh/model/segment.h"
#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

void EdgeTurns::add_sides(std::size_t leaf, std::span<const Triangle> triangles, double allowed) {
  const ParameterBox domain = box_of(surface_.domain);
  const auto& uv = grid_.mesh.uv;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      if (!is_on_edge({uv[a], uv[b]}, domain)) continue;
      sides_.push_back({leaf, triangles, allowed, {a, b}, std::nullopt});
      sides_.push_back({leaf, triangles, allowed, {b, a}, std::nullopt});
    }
  }
}

void EdgeTurns::add_chords(std::size_t leaf, std::span<const Triangle> triangles,
                           std::span<const std::array<std::uint32_t, 3>> corners, double allowed) {
  if (corners.size() > 2) return;
  const auto& position = grid_.mesh.position;
  for (const auto& [a, b, opposite] : corners) {
    if (clip_ && is_along_face(*clip_, position[a], position[b])) continue;
    sides_.push_back({leaf, triangles, allowed, {a, b}, opposite});
    sides_.push_back({leaf, triangles, allowed, {b, a}, opposite});
  }
}

/// Whether the surface goes against the direction of a chord at a point on the way along it.
bool EdgeTurns::goes_back(const Side& side, const SurfacePoint& point) const {
  const Line line = line_of(side);
  const dvec2 way = line[1] - line[0];
  return glm::dot(way.x * point.r_u + way.y * point.r_v, along(side)) < 0;
}

/// Keeps the chords beyond whose first end the surface goes.
void EdgeTurns::keep_turning() {
  std::vector<dvec2> uv;
  for (const Side& side : sides_) uv.push_back(line_of(side)[0]);
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += uv.size();
  std::erase_if(sides_, [&](const Side& side) {
    return !goes_back(side, points[static_cast<std::size_t>(&side - sides_.data())]);
  });
}

/// Bisects lines to where the surface goes neither back nor forth. At rims and jumps, lines lie a
/// little inside.
void EdgeTurns::find_turns() {
  struct Search {
    const Side* side;
    Line left;
  };
  std::vector<Search> searches;
  for (const Side& side : sides_) {
    Line line = line_of(side);
    if (side.opposite) {
      for (dvec2& end : line) end = glm::mix(end, grid_.mesh.uv[*side.opposite], kNearly);
    }
    searches.push_back({&side, line});
  }
  std::vector<std::size_t> open = all_open(searches.size());
  const auto next = [](const Search& search) { return middle_of(search.left); };
  const auto is_done = [this](Search& search, const dvec2& middle, const SurfacePoint& point) {
    ++evaluations_;
    search.left[goes_back(*search.side, point) ? 0 : 1] = middle;
    return has_no_middle(search.left);
  };
  bisect_together(surface_, searches, open, {kHalvingsToSight, threads_}, next, is_done);
  for (std::size_t k = 0; k < sides_.size(); ++k) sides_[k].turn = searches[k].left[0];
}

/// Keeps the turns that are farther from their chords than allowed.
void EdgeTurns::keep_far() {
  const std::vector<dvec3> at = positions();
  std::erase_if(sides_, [&](const Side& side) {
    const dvec3& turn = at[static_cast<std::size_t>(&side - sides_.data())];
    const auto& position = grid_.mesh.position;
    return distance_from_segment(position[side.ends[0]], position[side.ends[1]], turn) <=
           side.allowed;
  });
}

std::vector<dvec3> EdgeTurns::positions() {
  std::vector<dvec2> turns;
  for (const Side& side : sides_) turns.push_back(side.turn);
  evaluations_ += turns.size();
  return evaluate_positions(surface_, turns, threads_);
}

/// Moves the turns at rims and jumps to where their sheets end. Drops those whose sheet goes on.
void EdgeTurns::move_to_ends_of_sheets(double delta) {
  std::vector<Line> ways;
  for (const Side& side : sides_) {
    if (!side.opposite) continue;
    const dvec2& opposite = grid_.mesh.uv[*side.opposite];
    ways.push_back({glm::mix(side.turn, opposite, kClose), glm::mix(side.turn, opposite, -kClose)});
  }
  const auto ends =
      sheet_ends(surface_, ways, {delta, kHalvingsToNearly, clip_}, threads_, evaluations_);
  std::size_t next = 0;
  std::vector<Side> kept;
  for (Side& side : sides_) {
    if (side.opposite) {
      const std::optional<SheetEnd>& end = ends[next++];
      if (!end || end->kind == SheetEnd::Kind::Open) continue;
      side.turn = end->uv;
    }
    kept.push_back(side);
  }
  sides_ = std::move(kept);
}

std::vector<LeafDistance> EdgeTurns::measure(double delta) {
  keep_turning();
  find_turns();
  keep_far();
  move_to_ends_of_sheets(delta);
  const std::vector<dvec3> at = positions();
  std::vector<LeafDistance> found;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const Side& side = sides_[k];
    if (!is_seen(clip_, at[k])) continue;
    const double distance = distance_from(grid_, side.triangles, side.turn, at[k]);
    if (distance > side.allowed && moves_by_last_digit(surface_, side.turn, side.allowed)) continue;
    found.push_back({side.leaf, distance, side.opposite.has_value(), side.turn});
  }
  return found;
}

}  // namespace saddle
