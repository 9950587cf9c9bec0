#include "mesh/mesher/strip_features.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/vec.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_tree.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// How far from a cliff its sheets have normals of their own, in widths of the cliff: the rounded
/// foot of tanh is flat there.
constexpr double kBesideCliff = 4;
/// A segment of a cliff has the normals at kNearEnd from its ends, where the surface may have an
/// edge. If one is over 20 degrees from the segment's own normal, the surface turns there within a
/// quarter of the tolerance, which is not seen.
constexpr double kSmoothTurn = 20;

/// Whether two known jumps of a line are too far apart to be one feature, wherever others are.
bool is_wide(const LocatedDiscontinuity& found, const Line& line) {
  const double half = std::min(glm::distance(*found.between, found.ends[0]),
                               glm::distance(*found.between, found.ends[1]));
  return 2 * half > kClose * glm::distance(line[0], line[1]);
}

/// Gives the two vertices of a jump one place. The ends of a side keep theirs.
void share_place(const Side& side, const std::array<std::uint32_t, 2>& beside, CellTree& tree) {
  const std::uint32_t kept = place_to_keep(side, beside, tree);
  for (const std::uint32_t vertex : beside) {
    if (vertex == kept || vertex == side[0] || vertex == side[1]) continue;
    tree.vertices().share_place(kept, vertex);
  }
}

/// Records several jumps of each side as one feature. A strip between two of them has a vertex
/// beside each; the two vertices of a jump have one place.
void add_several_jumps(std::span<const Side> sides, std::span<const std::vector<Line>> jumps,
                       const TraceOptions& options, CellTree& tree) {
  const auto& uv = tree.mesh().uv;
  std::vector<Between> places;
  std::vector<dvec2> normals_at;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto add = [&](const dvec2& at, const dvec2& on_sheet) {
      places.push_back({sides[k][0], sides[k][1], at});
      normals_at.push_back(beside_jump(at, on_sheet));
    };
    for (std::size_t i = 0; i + 1 < jumps[k].size(); ++i) {
      add(jumps[k][i][1], jumps[k][i + 1][0]);
      add(jumps[k][i + 1][0], jumps[k][i][1]);
    }
    const dvec2 begin = uv[sides[k][0]];
    const dvec2 end = uv[sides[k][1]];
    if (jumps[k].front()[0] != begin) add(jumps[k].front()[0], begin);
    if (jumps[k].back()[1] != end) add(jumps[k].back()[1], end);
  }
  std::uint32_t next = tree.geometry().add_between(places, options.threads);
  std::vector<std::uint32_t> vertices(places.size());
  std::iota(vertices.begin(), vertices.end(), next);
  set_normals(vertices, normals_at, options.threads, tree);
  tree.geometry().take_known_normals();
  for (std::size_t k = 0; k < sides.size(); ++k) {
    EdgeFeature feature{FeatureKind::Jump, sides[k][0], sides[k][0], sides[k][1]};
    feature.strips = static_cast<std::uint8_t>(jumps[k].size() - 1);
    feature.first_on_strips = next;
    next += 2U * feature.strips;
    if (jumps[k].front()[0] != uv[sides[k][0]]) feature.beside_first = next++;
    if (jumps[k].back()[1] != uv[sides[k][1]]) feature.beside_second = next++;
    for (std::uint32_t i = 0; i <= feature.strips; ++i) {
      const std::uint32_t vertex = feature.first_on_strips + 2 * i;
      share_place(sides[k],
                  {i == 0 ? feature.beside_first : vertex - 1,
                   i == feature.strips ? feature.beside_second : vertex},
                  tree);
    }
    tree.edges().set_feature(sides[k][0], sides[k][1], feature);
  }
}

/// Sets the normals of segments of cliffs. Each is from one vertex, numbered from `first`, to the
/// next; `on_segments` are three places on each.
void set_normals_of_segments(std::span<const std::uint32_t> segments,
                             std::span<const dvec2> on_segments, std::uint32_t first,
                             unsigned threads, CellTree& tree) {
  const std::vector<SurfacePoint> points = evaluate(tree.surface(), on_segments, threads);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::uint32_t vertex = first + segments[i];
    const auto normal_at = [&](std::size_t k) {
      return known_normal(points[3 * i + k], tree.surface().flip);
    };
    const auto middle = normal_at(1);
    if (!middle) continue;
    const auto& position = tree.mesh().position;
    const dvec3 along = glm::normalize(position[vertex + 1] - position[vertex]);
    const dvec3 own = glm::normalize(*middle - glm::dot(*middle, along) * along);
    for (const std::size_t end : {0, 1}) {
      const auto normal = normal_at(2 * end);
      const bool is_smooth = normal && degrees_between(*normal, own) <= kSmoothTurn;
      tree.geometry().set_normal(static_cast<std::uint32_t>(vertex + end),
                                 is_smooth ? *normal : own);
    }
  }
}

/// Sides with known jumps, some of those that were asked for.
struct Candidates {
  std::vector<std::size_t> numbers = {};
  std::vector<Line> lines = {};
  std::vector<LocatedDiscontinuity> known = {};
};

bool are_all_known(const LocatedDiscontinuity& found) {
  return !found.jumps.empty();
}

/// Sides from `next` on, which goes to the first that is left.
Candidates next_candidates(std::span<const Side> sides, std::span<const LocatedDiscontinuity> found,
                           const CellTree& tree, std::size_t& next) {
  const bool has_many = !tree.edges().may_have_few_jumps();
  Candidates some;
  for (; next < sides.size() && some.numbers.size() < kSearchedTogether; ++next) {
    if (found[next].kind != Discontinuity::Jump || !found[next].between) continue;
    const Line line = {tree.mesh().uv[sides[next][0]], tree.mesh().uv[sides[next][1]]};
    if (!are_all_known(found[next]) && has_many && is_wide(found[next], line)) continue;
    some.numbers.push_back(next);
    some.lines.push_back(line);
    some.known.push_back(found[next]);
  }
  return some;
}

/// Whether the jumps of a candidate become one feature. Where sides have many jumps, those that are
/// not close are parted by halving.
bool are_one_feature(const Candidates& candidates, std::size_t i, std::span<const Line> jumps,
                     bool has_many) {
  if (jumps.size() < 2) return false;
  const double width = glm::distance(jumps.front()[0], jumps.back()[1]);
  const Line& line = candidates.lines[i];
  const bool is_close = width <= kClose * glm::distance(line[0], line[1]);
  return are_all_known(candidates.known[i]) || !has_many || is_close;
}

}  // namespace

std::vector<bool> add_strips(std::span<const Side> sides,
                             std::span<const LocatedDiscontinuity> found, double delta,
                             const TraceOptions& options, CellTree& tree) {
  std::vector<bool> is_done(sides.size(), false);
  for (std::size_t next = 0; next < sides.size();) {
    const bool has_many = !tree.edges().may_have_few_jumps();
    const Candidates some = next_candidates(sides, found, tree, next);
    const auto jumps = find_all_jumps(tree.surface(), some.lines, some.known, delta,
                                      options.threads, tree.effort().looks());
    std::vector<Side> few;
    std::vector<std::vector<Line>> jumps_of;
    for (std::size_t i = 0; i < some.numbers.size(); ++i) {
      if (!are_one_feature(some, i, jumps[i], has_many)) continue;
      is_done[some.numbers[i]] = true;
      few.push_back(sides[some.numbers[i]]);
      jumps_of.push_back(jumps[i]);
    }
    tree.edges().count_few_jumps(some.numbers.size(), few.size());
    if (!few.empty()) add_several_jumps(few, jumps_of, options, tree);
    for (std::size_t i = 0; i < some.numbers.size(); ++i) {
      const Side& side = sides[some.numbers[i]];
      if (is_done[some.numbers[i]] && some.known[i].is_proved)
        tree.edges().set_proved(side[0], side[1]);
    }
  }
  return is_done;
}

void add_cliffs(std::span<const Side> sides, std::span<const Cliff> cliffs, unsigned threads,
                CellTree& tree) {
  const auto& uv = tree.mesh().uv;
  std::vector<Between> places;
  std::vector<std::uint32_t> segments;  // the places that begin one, before the next
  std::vector<dvec2> on_segments;       // near its ends, and in its middle
  std::vector<std::uint32_t> besides;   // the places beside cliffs
  std::vector<dvec2> normals_at;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Cliff& cliff = cliffs[k];
    const auto add = [&](const dvec2& at, std::vector<std::uint32_t>& numbers) {
      numbers.push_back(static_cast<std::uint32_t>(places.size()));
      places.push_back({sides[k][0], sides[k][1], at});
    };
    for (std::size_t i = 1; i < cliff.size(); ++i) {
      add(cliff[i - 1], segments);
      places.push_back({sides[k][0], sides[k][1], cliff[i]});
      for (const double share : {kNearEnd, 0.5, 1 - kNearEnd})
        on_segments.push_back(glm::mix(cliff[i - 1], cliff[i], share));
    }
    const std::array ends = {cliff.front(), cliff.back()};
    for (std::size_t end = 0; end < 2; ++end) {
      const dvec2& from = ends[end];
      if (from == uv[sides[k][end]]) continue;
      const dvec2 way = kBesideCliff * (from - ends[1 - end]);
      const dvec2 rest = uv[sides[k][end]] - from;
      add(from, besides);
      normals_at.push_back(from + (glm::dot(way, way) < glm::dot(rest, rest) ? way : rest));
    }
  }
  const std::uint32_t first = tree.geometry().add_between(places, threads);
  set_normals_of_segments(segments, on_segments, first, threads, tree);
  for (std::uint32_t& beside : besides) beside += first;
  set_normals(besides, normals_at, threads, tree);
  tree.geometry().take_known_normals();
  std::uint32_t next = first;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    EdgeFeature cliff{FeatureKind::Cliff, sides[k][0], sides[k][0], sides[k][1]};
    cliff.first_on_strips = next;
    cliff.strips = static_cast<std::uint8_t>(cliffs[k].size() - 1);
    next += 2U * cliff.strips;
    const std::uint32_t last_on_strips = next - 1;
    if (cliffs[k].front() != uv[sides[k][0]]) cliff.beside_first = next++;
    if (cliffs[k].back() != uv[sides[k][1]]) cliff.beside_second = next++;
    tree.geometry().join(cliff.beside_first, cliff.first_on_strips);
    for (std::uint32_t i = cliff.first_on_strips + 1; i < last_on_strips; i += 2)
      tree.geometry().join(i, i + 1);
    tree.geometry().join(cliff.beside_second, last_on_strips);
    tree.edges().set_feature(sides[k][0], sides[k][1], cliff);
  }
}

void set_normals(std::span<const std::uint32_t> vertices, std::span<const dvec2> at,
                 unsigned threads, CellTree& tree) {
  const std::vector<SurfacePoint> points = evaluate(tree.surface(), at, threads);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto normal = known_normal(points[i], tree.surface().flip);
    if (normal) tree.geometry().set_normal(vertices[i], *normal);
  }
}

std::uint32_t place_to_keep(const Side& side, const std::array<std::uint32_t, 2>& beside,
                            const CellTree& tree) {
  for (std::size_t end = 0; end < 2; ++end) {
    if (tree.vertices().place_between(beside[end]) == tree.vertices().place_between(side[end]))
      return side[end];
  }
  return beside[0];
}

}  // namespace saddle
