#include "mesh/mesher/pole_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/features/approach.h"
#include "mesh/features/discontinuities.h"
#include "mesh/features/way_out.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

namespace {

/// A line in the domain from a vertex to a pole.
struct PoleWay {
  std::uint32_t from;
  dvec2 last;    ///< the last place before the pole at which the surface was found to be finite
  dvec2 beyond;  ///< the pole, or a place beyond it
};

/// The pole between the two places at which bisection ended. A coordinate that changes its sign
/// there is 0.
dvec2 place_of_pole(const dvec2& a, const dvec2& b) {
  dvec2 place = 0.5 * a + 0.5 * b;
  for (int k = 0; k < 2; ++k) {
    if (std::signbit(a[k]) != std::signbit(b[k])) place[k] = 0;
  }
  return place;
}

/// Draws the last places of ways back to where the surface is finite: bisection may end on the
/// pole.
void draw_back_from_poles(std::span<PoleWay> ways, const TraceOptions& options,
                          const CellTree& tree) {
  std::vector<dvec2> last;
  for (const PoleWay& way : ways) last.push_back(way.last);
  const auto at_last = evaluate(tree.surface(), last, options.threads);
  std::vector<Line> lines;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (is_finite(at_last[k].position)) continue;
    lines.push_back({tree.mesh().uv[ways[k].from], ways[k].last});
    numbers.push_back(k);
  }
  const auto finite = last_defined(tree.surface(), lines, kHalvingsToLeast, options.threads);
  for (std::size_t i = 0; i < finite.size(); ++i) ways[numbers[i]].last = finite[i];
}

/// The places where ways leave the clip box last, before the pole. A way that begins outside of the
/// box leaves where it begins. A way from below the box to a pole above it crosses both faces: the
/// first end counts as within.
std::vector<dvec2> leave_box(std::span<const PoleWay> ways, const TraceOptions& options,
                             const CellTree& tree) {
  std::vector<dvec2> last;
  for (const PoleWay& way : ways) last.push_back(way.last);
  const auto at_last = evaluate(tree.surface(), last, options.threads);
  std::vector<WayOut> out;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const PoleWay& way = ways[k];
    Bounds box = *options.clip;
    box.add(tree.mesh().position[way.from]);
    const bool goes_on = box.contains(at_last[k].position);
    const Line line =
        goes_on ? Line{way.last, way.beyond} : Line{tree.mesh().uv[way.from], way.last};
    out.emplace_back(line, kHalvingsToLeast, box);
  }
  auto places = leave(tree.surface(), std::move(out), options.threads);
  const auto at_faces = evaluate(tree.surface(), places, options.threads);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (!options.clip->contains(at_faces[k].position)) places[k] = tree.mesh().uv[ways[k].from];
  }
  return places;
}

/// The face of a box beyond which a place is farthest, or which is nearest: its axis, or 3 more for
/// an upper face.
std::uint8_t exit_of(const Bounds& box, const dvec3& place) {
  const dvec3 below = box.low - place;
  const dvec3 above = place - box.high;
  const std::array beyond = {below.x, below.y, below.z, above.x, above.y, above.z};
  return static_cast<std::uint8_t>(std::ranges::max_element(beyond) - beyond.begin());
}

/// The places beside poles at which ways end on the finite sides of these, outside of the clip box,
/// too: chords to a place before them would cut off a part of the sheet. Nothing for other ways.
std::vector<std::optional<dvec2>> ends_on_finite_sides(std::span<const PoleWay> ways,
                                                       const TraceOptions& options,
                                                       const CellTree& tree) {
  const Bounds& box = *options.clip;
  std::vector<Line> lines;
  std::vector<dvec2> near;
  double delta = std::numeric_limits<double>::infinity();
  for (const PoleWay& way : ways) {
    lines.push_back({way.last, tree.mesh().uv[way.from]});
    const auto places = nearest_approaches(lines.back());
    near.insert(near.end(), places.begin(), places.end());
    const dvec3 in_box = glm::clamp(tree.mesh().position[way.from], box.low, box.high);
    delta = std::min(delta, options.tolerance(in_box));
  }
  const std::vector<bool> goes_far = diverge(tree.surface(), lines, delta, options.threads);
  const std::vector<dvec3> at = evaluate_positions(tree.surface(), near, options.threads);
  std::vector<std::optional<dvec2>> ends(ways.size());
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const bool stays = glm::distance(at[2 * k], at[2 * k + 1]) <= delta;
    if (stays && !goes_far[k]) ends[k] = near[2 * k + 1];
  }
  return ends;
}

/// Moves places beside poles to the faces of the clip box, but on the finite sides of poles.
void end_at_limits(std::span<const PoleWay> ways, std::span<Between> places,
                   const TraceOptions& options, const CellTree& tree) {
  const std::vector<std::optional<dvec2>> ends = ends_on_finite_sides(ways, options, tree);
  const std::vector<dvec2> faces = leave_box(ways, options, tree);
  for (std::size_t k = 0; k < ways.size(); ++k) places[k].uv = ends[k].value_or(faces[k]);
}

void cut_at_once(std::span<const Side> sides, const TraceOptions& options, CellTree& tree) {
  if (sides.empty()) return;
  std::vector<Between> places;
  std::vector<PoleWay> ways;
  for (const auto& [a, b] : sides) {
    const auto& [beside_a, beside_b] = tree.edges().pole_between(a, b);
    const dvec2 pole = place_of_pole(beside_a, beside_b);
    ways.push_back({a, beside_a, pole});
    ways.push_back({b, beside_b, pole});
  }
  draw_back_from_poles(ways, options, tree);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const auto& [a, b] = sides[k / 2];
    places.push_back({a, b, ways[k].last});
  }
  const bool to_faces = options.clip && tree.budget().has_room_for_faces(options.triangles);
  if (to_faces) end_at_limits(ways, places, options, tree);
  std::uint32_t next = tree.geometry().add_between(places, options.threads);
  tree.geometry().take_known_normals();
  const auto exit = [&](std::uint32_t vertex) {
    return to_faces ? exit_of(*options.clip, tree.mesh().position[vertex]) : std::uint8_t{0};
  };
  for (const auto& [a, b] : sides) {
    const FeatureKind kind = to_faces ? FeatureKind::Face : FeatureKind::Pole;
    tree.edges().set_feature(a, b,
                             EdgeFeature{kind, a, next, next + 1, {exit(next), exit(next + 1)}});
    next += 2;
  }
}

}  // namespace

void cut_poles(std::span<const Side> sides, const TraceOptions& options, CellTree& tree) {
  for (std::size_t begin = 0; begin < sides.size(); begin += kInBatch) {
    const std::size_t count = std::min(sides.size() - begin, kInBatch);
    cut_at_once(sides.subspan(begin, count), options, tree);
  }
}

void find_poles_beside_cuts(std::span<const Side> sides, const TraceOptions& options,
                            CellTree& tree) {
  const Mesh& mesh = tree.mesh();
  double delta = std::numeric_limits<double>::infinity();
  std::vector<Line> parts;
  std::vector<Side> whole;  // the side of each part; the part begins at its first end
  for (const Side& side : sides) {
    const std::optional<EdgeFeature> cut = tree.edges().feature(side[0], side[1]);
    for (std::size_t end = 0; end < 2; ++end) {
      const std::uint32_t from = side[end];
      const std::uint32_t to = cut->beside(from);
      if (!tree.geometry().is_defined(from) || mesh.uv[from] == mesh.uv[to]) continue;
      parts.push_back({mesh.uv[from], mesh.uv[to]});
      whole.push_back({from, side[1 - end]});
      delta = std::min(delta, options.tolerance(mesh.position[from]));
    }
  }
  const auto found =
      find_discontinuities(tree.surface(), parts, delta, options.threads, tree.effort().looks());
  std::vector<Side> poles;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto& [from, to] = whole[k];
    if (found[k].kind != Discontinuity::Pole || tree.edges().leads_to_pole(from, to)) continue;
    const auto& [near, far] = found[k].ends;
    tree.edges().set_leads_to_pole(from, to,
                                   from < to ? std::array{near, far} : std::array{far, near});
    poles.push_back(side_of(from, to));
  }
  cut_at_once(poles, options, tree);
}

std::vector<bool> diverge_at(std::span<const Between> boundaries, const TraceOptions& options,
                             const CellTree& tree) {
  std::vector<Line> ways;
  double delta = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, boundary] : boundaries) {
    const std::uint32_t defined = tree.geometry().is_defined(a) ? a : b;
    ways.push_back({boundary, tree.mesh().uv[defined]});
    delta = std::min(delta, options.tolerance(tree.mesh().position[defined]));
  }
  return diverge(tree.surface(), ways, delta, options.threads);
}

std::vector<bool> end_at_faces(const std::vector<bool>& goes_far, std::span<Between> boundaries,
                               const TraceOptions& options, CellTree& tree) {
  std::vector<bool> at_face(boundaries.size(), false);
  if (!options.clip) return at_face;
  std::vector<PoleWay> ways;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const Between& boundary = boundaries[k];
    const bool first = tree.geometry().is_defined(boundary.a);
    const auto [end, other] =
        first ? std::pair(boundary.a, boundary.b) : std::pair(boundary.b, boundary.a);
    if (!goes_far[k] || tree.geometry().singularity(other) == PointSingularity::Kind::Essential)
      continue;
    at_face[k] = true;
    tree.edges().add_pole_beyond_face({boundary.uv, boundary.uv});
    ways.push_back({end, boundary.uv, tree.mesh().uv[other]});
  }
  const std::vector<dvec2> faces = leave_box(ways, options, tree);
  std::size_t next = 0;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    if (at_face[k]) boundaries[k].uv = faces[next++];
  }
  return at_face;
}

Bounds box_beside_poles(const CellTree& tree, unsigned threads) {
  std::vector<dvec2> ends;
  for (const std::array<dvec2, 2>& pole : tree.edges().poles(tree.mesh()))
    ends.insert(ends.end(), pole.begin(), pole.end());
  Bounds box;
  const auto add = [&box](const dvec3& p) {
    if (is_finite(p)) box.add(p);
  };
  std::ranges::for_each(evaluate_positions(tree.surface(), ends, threads), add);
  // Through an open face the surface may go much farther: beside 0 lie many more doubles.
  for (const auto& [a, b] : tree.edges().sides_with_features()) {
    const auto cut = tree.edges().feature(a, b);
    if (!cut || cut->kind != FeatureKind::Face) continue;
    for (const std::uint32_t vertex : {cut->beside_first, cut->beside_second})
      add(tree.mesh().position[vertex]);
  }
  return box;
}

}  // namespace saddle
