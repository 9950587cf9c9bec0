#include "meshing/clip_box.h"

#include <algorithm>
#include <vector>

#include <glm/common.hpp>

#include "mesh/features/robust_box.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// Samples that go so many times as far as nine tenths of them do are on their way to infinity. A
/// side that goes there is shown up to so many times the length of the surface's other
/// sides, if half of the surface is inside, and down to that part of the longest. Beside the spikes
/// of 1/(u v), its square would be too small to see; beside thin poles nine tenths of the samples
/// may lie in a plane, of which a thinner box would cut strips.
constexpr double kTall = 4;
/// A part nearly as narrow as the whole ends the search for one in proportion.
constexpr double kAsNarrow = 0.9;
/// A surface may go beyond its samples by this part of their extent without being clipped.
constexpr double kBeyondProbe = 0.1;

/// The box with at least this length along an axis.
Bounds lengthened(Bounds box, int axis, double length) {
  const double missing = 0.5 * (length - box.size()[axis]);
  if (missing > 0) {
    box.low[axis] -= missing;
    box.high[axis] += missing;
  }
  return box;
}

/// The larger of the other two sides.
double next_longest(const dvec3& size, int axis) {
  return std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
}

int longest_axis(const dvec3& size) {
  return size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
}

/// The points of the window of this length along an axis that holds most of them. `sorted` along
/// that axis.
std::span<const dvec3> fullest_window(std::span<const dvec3> sorted, int axis, double length) {
  std::size_t best = 0;
  std::size_t most = 0;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < sorted.size(); ++begin) {
    while (end < sorted.size() && sorted[end][axis] <= sorted[begin][axis] + length) ++end;
    if (end - begin <= most) continue;
    most = end - begin;
    best = begin;
  }
  return sorted.subspan(best, most);
}

/// The fullest window within the fullest one of twice the length, and so on: short ones may hold a
/// few points by chance, wherever they are. Source: D. R. Bickel, R. Fruhwirth, "On a fast, robust
/// estimator of the mode", 2006.
std::span<const dvec3> densest_window(std::span<const dvec3> sorted, int axis, double length) {
  while (!sorted.empty() && sorted.back()[axis] - sorted.front()[axis] > length) {
    const double half = 0.5 * (sorted.back()[axis] - sorted.front()[axis]);
    sorted = fullest_window(sorted, axis, std::max(half, length));
  }
  return sorted;
}

/// clip_box(). A side that goes to infinity is at least `low` times as long as the longest other.
Bounds proportionate_box(const Bounds& all, const Bounds& usual, std::span<const dvec3> points,
                         double low) {
  const Bounds most = robust_box(points);
  const auto is_far_out = [&](int k) {
    const double size = all.size()[k];
    return size > kTall * most.size()[k] || size > kTall * next_longest(all.size(), k);
  };
  double longest = 0;  // the largest side that needs no clipping
  for (int k = 0; k < 3; ++k) {
    if (!is_far_out(k)) longest = std::max(longest, all.size()[k]);
  }
  const Bounds shapely = longest > 0 ? robust_box(points, dvec3(kTall * longest)) : most;
  Bounds box;
  for (int k = 0; k < 3; ++k) {
    const Bounds kept = is_far_out(k) ? lengthened(shapely, k, low * longest) : usual;
    const double margin = is_far_out(k) ? 0 : kBeyondProbe * usual.size()[k];
    box.low[k] = kept.low[k] - margin;
    box.high[k] = kept.high[k] + margin;
  }
  return box;
}

/// clip_box(), open at the faces that the surface goes beyond by no more than the box is long.
Bounds box_without_far_edges(const Bounds& all, std::span<const dvec3> points) {
  Bounds box = proportionate_box(all, all, points, 0);
  const dvec3 near = box.size();
  for (int k = 0; k < 3; ++k) {
    if (box.low[k] - all.low[k] <= near[k]) box.low[k] = -kInfinity;
    if (all.high[k] - box.high[k] <= near[k]) box.high[k] = kInfinity;
  }
  return box;
}

/// Whether a box leaves some of each side of a surface that has any: of a peak that no sample has
/// met it leaves none.
bool shows_some(const Bounds& box, const Bounds& whole) {
  const dvec3 seen = glm::min(box.high, whole.high) - glm::max(box.low, whole.low);
  bool shows = true;
  for (int k = 0; k < 3; ++k) shows = shows && (seen[k] > 0 || !(whole.size()[k] > 0));
  return shows;
}

}  // namespace

Bounds clip_box(const Bounds& all, const Bounds& usual, std::span<const dvec3> points) {
  return proportionate_box(all, usual, points, 1 / kTall);
}

std::optional<Bounds> readable_box(const Bounds& whole, std::span<const dvec3> points) {
  if (points.empty()) return std::nullopt;
  const Bounds all = bounds_of(points);
  if (!is_finite(all.size())) return std::nullopt;  // from -1e308 to 1e308
  const dvec3 beyond = whole.size() - kNeedle * all.diagonal();
  if (std::max({beyond.x, beyond.y, beyond.z}) > 0) {
    const Bounds box = box_without_far_edges(whole, points);
    return shows_some(box, whole) ? std::optional(box) : std::nullopt;
  }
  const int axis = longest_axis(all.size());
  double usual = next_longest(all.size(), axis);
  if (!(all.size()[axis] > kNeedle * usual)) {
    // Along more than one axis, some may go far beyond the others.
    if (!(all.diagonal() > kNeedle * rough_box(points).diagonal())) return std::nullopt;
    const Bounds box = box_without_far_edges(whole, points);
    return shows_some(box, whole) ? std::optional(box) : std::nullopt;
  }
  std::vector<dvec3> sorted(points.begin(), points.end());
  std::ranges::sort(sorted, {}, [axis](const dvec3& p) { return p[axis]; });
  std::optional<Bounds> box;
  std::span<const dvec3> part = sorted;
  // A part is worth a picture if it has more samples than one of the columns of a probe.
  const auto is_worth = [&](std::span<const dvec3> some) {
    return some.size() > points.size() / kDomainParts;
  };
  // The part is narrower than the whole, and so again is what is in proportion to it.
  for (;;) {
    const double length = kTall * usual;
    const std::span<const dvec3> dense = densest_window(part, axis, length);
    part = is_worth(dense) ? dense : fullest_window(part, axis, length);
    if (!is_worth(part)) break;
    box = Bounds{dvec3(-kInfinity), dvec3(kInfinity)};
    const double first = part.front()[axis];
    if (part.data() != sorted.data()) box->low[axis] = first;
    if (first + length < all.high[axis]) box->high[axis] = first + length;
    const double narrower = next_longest(bounds_of(part).size(), axis);
    if (narrower >= kAsNarrow * usual) break;
    usual = narrower;
  }
  return box;
}

}  // namespace saddle
