#include "mesh/distance/edge_turns.h"

#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/distance/sampled_error.h"
#include "mesh/features/bisect_together.h"
#include "mesh/features/sheet_ends.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Whether a line of constant u or v is on the edge of a domain.
bool is_on_edge(const Line& line, const ParameterBox& domain) {
  for (int axis = 0; axis < 2; ++axis) {
    const double at = line[0][axis];
    if (at == line[1][axis] && (at == domain.low[axis] || at == domain.high[axis])) return true;
  }
  return false;
}

}  // namespace

void EdgeTurns::add_sides(std::size_t leaf, std::span<const Triangle> triangles, double allowed) {
  const ParameterBox domain = box_of(surface_.domain);
  const auto& uv = grid_.mesh.uv;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      if (!is_on_edge({uv[a], uv[b]}, domain)) continue;
      chords_.push_back({leaf, triangles, allowed, {a, b}, std::nullopt});
      chords_.push_back({leaf, triangles, allowed, {b, a}, std::nullopt});
    }
  }
}

void EdgeTurns::add_chords(std::size_t leaf, std::span<const Triangle> triangles,
                           std::span<const std::array<std::uint32_t, 3>> corners, double allowed) {
  if (corners.size() > 2) return;
  const auto& position = grid_.mesh.position;
  for (const auto& [a, b, opposite] : corners) {
    if (clip_ && is_along_face(*clip_, position[a], position[b])) continue;
    chords_.push_back({leaf, triangles, allowed, {a, b}, opposite});
    chords_.push_back({leaf, triangles, allowed, {b, a}, opposite});
  }
}

/// Whether the surface goes back at a point on the way along a chord.
bool EdgeTurns::goes_back(const Chord& chord, const SurfacePoint& point) const {
  const Line line = line_of(chord);
  const dvec2 way = line[1] - line[0];
  return glm::dot(way.x * point.r_u + way.y * point.r_v, along(chord)) < 0;
}

/// Keeps the chords beyond whose end the surface goes.
void EdgeTurns::keep_turning() {
  std::vector<dvec2> uv;
  for (const Chord& chord : chords_) uv.push_back(line_of(chord)[0]);
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += uv.size();
  std::erase_if(chords_, [&](const Chord& chord) {
    return !goes_back(chord, points[static_cast<std::size_t>(&chord - chords_.data())]);
  });
}

/// Bisects lines to where the surface goes neither back nor forth. At rims and jumps, lines lie a
/// little inside.
void EdgeTurns::find_turns() {
  struct Search {
    const Chord* chord;
    Line left;
  };
  std::vector<Search> searches;
  for (const Chord& chord : chords_) {
    Line line = line_of(chord);
    if (chord.opposite) {
      for (dvec2& end : line) end = glm::mix(end, grid_.mesh.uv[*chord.opposite], kNearly);
    }
    searches.push_back({&chord, line});
  }
  std::vector<std::size_t> open = all_open(searches.size());
  const auto next = [](const Search& search) { return middle_of(search.left); };
  const auto is_done = [this](Search& search, const dvec2& middle, const SurfacePoint& point) {
    ++evaluations_;
    search.left[goes_back(*search.chord, point) ? 0 : 1] = middle;
    return has_no_middle(search.left);
  };
  bisect_together(surface_, searches, open, {kHalvingsToSight, threads_}, next, is_done);
  for (std::size_t k = 0; k < chords_.size(); ++k) chords_[k].turn = searches[k].left[0];
}

/// Keeps the turns that are farther from their chords than allowed.
void EdgeTurns::keep_far() {
  const std::vector<dvec3> at = positions();
  std::erase_if(chords_, [&](const Chord& chord) {
    const dvec3& position = at[static_cast<std::size_t>(&chord - chords_.data())];
    return distance_from_chord(grid_, chord.ends, position) <= chord.allowed;
  });
}

std::vector<dvec3> EdgeTurns::positions() {
  std::vector<dvec2> turns;
  for (const Chord& chord : chords_) turns.push_back(chord.turn);
  evaluations_ += turns.size();
  return evaluate_positions(surface_, turns, threads_);
}

/// Moves the turns at rims and jumps to where their sheets end. Drops those whose sheet goes on.
void EdgeTurns::move_to_ends_of_sheets(double delta) {
  std::vector<Line> ways;
  for (const Chord& chord : chords_) {
    if (!chord.opposite) continue;
    const dvec2& opposite = grid_.mesh.uv[*chord.opposite];
    ways.push_back(
        {glm::mix(chord.turn, opposite, kClose), glm::mix(chord.turn, opposite, -kClose)});
  }
  const auto ends =
      sheet_ends(surface_, ways, {delta, kHalvingsToNearly, clip_}, threads_, evaluations_);
  std::size_t next = 0;
  std::vector<Chord> kept;
  for (Chord& chord : chords_) {
    if (chord.opposite) {
      const std::optional<SheetEnd>& end = ends[next++];
      if (!end || end->kind == SheetEnd::Kind::Open) continue;
      chord.turn = end->uv;
    }
    kept.push_back(chord);
  }
  chords_ = std::move(kept);
}

std::vector<LeafDistance> EdgeTurns::measure(double delta) {
  keep_turning();
  find_turns();
  keep_far();
  move_to_ends_of_sheets(delta);
  const std::vector<dvec3> at = positions();
  std::vector<LeafDistance> found;
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const Chord& chord = chords_[k];
    if (!is_seen(clip_, at[k])) continue;
    const double distance = distance_from(grid_, chord.triangles, chord.turn, at[k]);
    found.push_back({chord.leaf, distance, chord.opposite.has_value(), chord.turn});
  }
  return found;
}

}  // namespace saddle
