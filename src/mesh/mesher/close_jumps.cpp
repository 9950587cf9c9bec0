#include "mesh/mesher/close_jumps.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "mesh/tree/cell_tree.h"

namespace saddle {

namespace {

/// Jumps within a quarter of a side are one feature: what is between them is a strip. Wider ones
/// are parted by halving.
constexpr double kClose = 0.25;

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
void add_close_jumps(std::span<const Side> sides, std::span<const std::vector<Line>> jumps,
                     const TraceOptions& options, CellTree& tree) {
  const auto& uv = tree.mesh().uv;
  std::vector<Between> places;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto add = [&](const dvec2& at) { places.push_back({sides[k][0], sides[k][1], at}); };
    for (std::size_t i = 0; i + 1 < jumps[k].size(); ++i) {
      add(jumps[k][i][1]);
      add(jumps[k][i + 1][0]);
    }
    if (jumps[k].front()[0] != uv[sides[k][0]]) add(jumps[k].front()[0]);
    if (jumps[k].back()[1] != uv[sides[k][1]]) add(jumps[k].back()[1]);
  }
  std::uint32_t next = tree.geometry().add_between(places, options.threads);
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

}  // namespace

std::vector<bool> add_strips(std::span<const Side> sides,
                             std::span<const LocatedDiscontinuity> found, double delta,
                             const TraceOptions& options, CellTree& tree) {
  std::vector<bool> is_done(sides.size(), false);
  std::vector<std::size_t> numbers;
  std::vector<Line> with_more;
  std::vector<LocatedDiscontinuity> known;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (found[k].kind != Discontinuity::Jump || !found[k].between) continue;
    const Line line = {tree.mesh().uv[sides[k][0]], tree.mesh().uv[sides[k][1]]};
    if (is_wide(found[k], line)) continue;
    numbers.push_back(k);
    with_more.push_back(line);
    known.push_back(found[k]);
  }
  if (numbers.empty()) return is_done;
  const auto jumps = find_all_jumps(tree.surface(), with_more, known, delta, options.threads,
                                    tree.effort().looks());
  std::vector<Side> close;
  std::vector<std::vector<Line>> jumps_of;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (jumps[i].size() < 2) continue;
    const double width = glm::distance(jumps[i].front()[0], jumps[i].back()[1]);
    if (width > kClose * glm::distance(with_more[i][0], with_more[i][1])) continue;
    is_done[numbers[i]] = true;
    close.push_back(sides[numbers[i]]);
    jumps_of.push_back(jumps[i]);
  }
  if (!close.empty()) add_close_jumps(close, jumps_of, options, tree);
  return is_done;
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
