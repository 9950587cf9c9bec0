#include "mesh/error/open_leaves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "base/parallel.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

namespace {

/// Features for which the mesh would need 16 times as many leaves are told, not mended, unless they
/// are in 4 leaves at most, as a needle is.
constexpr double kMostGrowth = 16;
constexpr std::size_t kFew = 4;

/// The distances from the top of a feature, along u and along v, at which its height is halved:
/// they are looked for at 1/2 to 1e-6 of the part's sides, each way.
dvec2 half_widths(const Surface& surface, const FeatureSearch::Distance& distance,
                  const SearchedPart& part, const PlacedError& top) {
  const dvec2 size = part.box.size();
  std::vector<dvec2> uv;
  for (int axis = 0; axis < 2; ++axis) {
    dvec2 step(0);
    for (step[axis] = 0.5 * size[axis]; uv.size() < 2UL * kHalvingsToNearly * (axis == 0 ? 1 : 2);
         step *= 0.5) {
      uv.push_back(top.uv - step);
      uv.push_back(top.uv + step);
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  dvec2 widths = size;
  for (std::size_t k = 0; k < uv.size(); ++k) {
    const int axis = k < 2UL * kHalvingsToNearly ? 0 : 1;
    const double height = part.scale * distance(part, uv[k], points[k].position, 0);
    if (height < 0.5 * top.distance)
      widths[axis] = std::min(widths[axis], std::fabs(uv[k][axis] - top.uv[axis]));
  }
  return widths;
}

}  // namespace

SearchedPart part_of(const ValidatedMesh& mesh, std::size_t leaf,
                     std::span<const Triangle> triangles, const Grid& grid, const CellTree& tree) {
  Bounds around;
  for (const Triangle& t : triangles) {
    for (const std::uint32_t corner : t) around.add(grid.mesh.position[corner]);
  }
  return {tree.box(mesh.leaves[leaf]), triangles, around};
}

OpenLeaves::OpenLeaves(const Surface& surface, const Grid& grid, const CellTree& tree,
                       KnownHulls& hulls, const std::optional<Bounds>& clip, unsigned threads)
    : surface_(surface),
      grid_(grid),
      tree_(tree),
      hulls_(hulls),
      clip_(clip),
      threads_(threads),
      left_(kInBatch) {}

std::vector<Counterexample> OpenLeaves::refute(const std::function<bool(std::size_t leaf)>& is_open,
                                               ValidatedMesh& mesh) {
  const std::vector<std::size_t> open = gather_in_chunks<std::size_t>(
      mesh.leaves.size(), kInBatch, threads_, [&](std::size_t k, std::vector<std::size_t>& some) {
        if (!mesh.triangles.of(k).empty() && !mesh.marks[k].is_searched && is_open(k))
          some.push_back(k);
      });
  for (const std::size_t k : open) mesh.marks[k].is_searched = true;
  if (open.empty()) return {};
  const auto part_of_open = [&](std::size_t number) {
    const std::size_t k = open[number];
    SearchedPart part = part_of(mesh, k, mesh.triangles.of(k), grid_, tree_);
    part.scale = 1 / mesh.allowed[k];
    part.number = k;
    return part;
  };
  const FeatureSearch::Distance distance = [this](const SearchedPart& part, const dvec2& uv,
                                                  const dvec3& position, double) {
    return distance_from(grid_, part.triangles, uv, position);
  };
  FeatureSearch search(surface_, hulls_, distance, 1, clip_, threads_);
  std::vector<SearchedPart> parts =
      search.widest(std::max(left_, kFirstSearched), 0, open.size(), part_of_open);
  // Bounds of a long formula are wide where nothing is: the search goes on while it finds.
  std::vector<PlacedError> found;
  for (std::size_t some = kFirstSearched; found.size() < parts.size(); some = kSearchedTogether) {
    const auto next = std::span(parts).subspan(found.size());
    const auto distances = search.dive(next.first(std::min(some, next.size())));
    found.insert(found.end(), distances.begin(), distances.end());
    if (std::ranges::none_of(distances, [](const PlacedError& at) { return at.distance > 1; }))
      break;
  }
  parts.resize(found.size());
  left_ -= std::min(left_, parts.size());
  std::vector<Counterexample> counterexamples;
  double leaves = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto& [distance_ratio, uv] = found[k];
    if (!(distance_ratio > 1)) continue;
    const std::size_t leaf = parts[k].number;
    mesh.add(leaf, distance_ratio * mesh.allowed[leaf], uv);
    // One leaf along a line of parameters; along another curve, as many as the feature is narrow.
    const dvec2 narrow = parts[k].box.size() / half_widths(surface_, distance, parts[k], found[k]);
    leaves += std::min(narrow.x, narrow.y);
    counterexamples.push_back({uv, evaluate(surface_, std::span(&uv, 1), 1)[0].position, dvec2(0),
                               narrow * narrow / (parts[k].box.size() * parts[k].box.size()),
                               leaf});
  }
  const double most = kMostGrowth * static_cast<double>(mesh.leaves.size());
  gives_up_ = gives_up_ || (counterexamples.size() > kFew && leaves > most);
  if (gives_up_) return {};
  return counterexamples;
}

}  // namespace saddle
