#include "mesh/mesher/envelope.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/random.h"
#include "mesh/model/tolerances.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/cell_polygon.h"

namespace saddle {

namespace {

/// Evaluations for all: 1/10 of the least budget of a mesh.
constexpr std::size_t kAllTries = kLeastEffort / 10;
/// Evaluations for a vertex: 4 to 16. The highest of 16 is nearly always in the last 1/20 of a
/// sine's range.
constexpr std::size_t kMostTries = 16;
constexpr std::size_t kLeastTries = 4;
/// A corner moves by at most 0.24 of a leaf's sides: below 1/4 the triangles of a leaf do not turn
/// over in (u, v).
constexpr double kMostShift = 0.24;

/// How far a vertex may move, and in which direction.
struct Reach {
  dvec2 size{std::numeric_limits<double>::infinity()};  ///< of the smallest leaf beside it
  bool is_upper = false;                                ///< which extreme it goes to
};

struct Movable {
  std::uint32_t vertex;
  Reach reach;
};

/// Whether the low corner of a leaf is on an even one of the lines along its longer sides.
bool is_even(const Leaf& leaf, const dvec2& size, const dvec2& range) {
  const bool is_narrow_u = size.x / range.x <= size.y / range.y;
  return (is_narrow_u ? leaf.low.u / leaf.size_u() : leaf.low.v / leaf.size_v()) % 2 == 0;
}

/// 1 for each parameter that may change: a vertex on an edge of the domain stays on it.
dvec2 free_ways(const Grid& grid, const dvec2& uv) {
  const auto is_inside = [](const std::vector<double>& lines, double parameter) {
    return parameter != lines.front() && parameter != lines.back() ? 1.0 : 0.0;
  };
  return {is_inside(grid.u, uv.x), is_inside(grid.v, uv.y)};
}

/// The regular vertices that are in oscillating leaves only and are points of their own.
std::vector<Movable> movable_vertices(std::span<const Leaf> leaves, const CellTree& tree,
                                      const Grid& grid) {
  const Mesh& mesh = grid.mesh;
  std::vector<Reach> reaches(mesh.position.size());
  std::vector<std::uint32_t> copies(mesh.position.size());
  for (const std::uint32_t point : mesh.point) ++copies[point];
  for (const Leaf& leaf : leaves) {
    const dvec2 size = tree.vertices().size(leaf.low, leaf.high());
    const bool is_free = may_reach_extremes(leaf);
    for_sides(leaf, tree, [&](std::uint32_t vertex, std::uint32_t) {
      Reach& reach = reaches[vertex];
      reach.size = is_free ? glm::min(reach.size, size) : dvec2(0);
    });
    const bool is_even_line = is_even(leaf, size, grid.range);
    reaches[leaf.samples.corner[0]].is_upper = is_even_line;
  }
  std::vector<Movable> movable;
  for (std::uint32_t vertex = 0; vertex < reaches.size(); ++vertex) {
    Reach reach = reaches[vertex];
    if (!std::isfinite(reach.size.x) || reach.size == dvec2(0)) continue;
    if (copies[mesh.point[vertex]] > 1 || !tree.geometry().is_regular(vertex)) continue;
    reach.size *= free_ways(grid, mesh.uv[vertex]);
    movable.push_back({vertex, reach});
  }
  return movable;
}

/// The axis along which points are spread most.
int main_axis(std::span<const SurfacePoint> points) {
  Bounds bounds;
  for (const SurfacePoint& point : points) {
    if (is_finite(point.position)) bounds.add(point.position);
  }
  if (bounds.empty()) return 0;
  const dvec3 size = bounds.size();
  return size.z >= std::max(size.x, size.y) ? 2 : (size.x >= size.y ? 0 : 1);
}

}  // namespace

std::size_t tries_in_waves(std::size_t count, std::size_t least) {
  return std::clamp(kAllTries / count, least, kMostTries);
}

bool may_reach_extremes(const Leaf& leaf) {
  return leaf.state.is_whole() && !leaf.state.is_left_out() && leaf.state.oscillates();
}

void reach_extremes(const Surface& surface, std::span<const Leaf> leaves, unsigned threads,
                    const CellTree& tree, Grid& grid) {
  Mesh& mesh = grid.mesh;
  const std::vector<Movable> movable = movable_vertices(leaves, tree, grid);
  if (movable.empty()) return;
  const std::size_t tries = tries_in_waves(movable.size(), kLeastTries);
  std::vector<dvec2> places;
  for (std::size_t first = 0; first < movable.size(); first += kInBatch) {
    const auto block =
        std::span(movable).subspan(first, std::min(kInBatch, movable.size() - first));
    places.clear();
    for (const auto& [vertex, reach] : block) {
      for (std::size_t k = 0; k < tries; ++k) {
        const std::uint64_t key = 2 * (std::uint64_t{vertex} * kMostTries + k);
        const dvec2 part(2 * random_unit(key) - 1, 2 * random_unit(key + 1) - 1);
        places.push_back(mesh.uv[vertex] + kMostShift * reach.size * part);
      }
    }
    const std::vector<SurfacePoint> points = evaluate(surface, places, threads);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto [vertex, reach] = block[i];
      const auto tried = std::span(points).subspan(i * tries, tries);
      const int axis = main_axis(tried);
      const double way = reach.is_upper ? 1 : -1;
      for (std::size_t k = 0; k < tries; ++k) {
        const dvec3 normal = glm::normalize(glm::cross(tried[k].r_u, tried[k].r_v));
        const double gain = way * (tried[k].position[axis] - mesh.position[vertex][axis]);
        if (!is_finite(tried[k].position) || !is_finite(normal) || !(gain > 0)) continue;
        mesh.position[vertex] = tried[k].position;
        mesh.normal[vertex] = grid.flipped ? -normal : normal;
        mesh.uv[vertex] = places[i * tries + k];
      }
    }
  }
}

}  // namespace saddle
