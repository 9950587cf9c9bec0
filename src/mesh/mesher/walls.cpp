#include "mesh/mesher/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/features/bisect_together.h"
#include "mesh/mesher/halving_limits.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// The line between the lowest and the highest corner of a triangle, along an axis.
struct Leap {
  std::size_t leaf;
  Triangle triangle;
  int axis;
  double middle, height;  ///< of what is in the box
  Line line;
  Line left = line;  ///< of it, while it is halved
  /// Where the surface is in the middle half of the triangle's height in the box.
  std::optional<dvec2> through = {};

  /// The height above the middle, in heights.
  double place(const dvec3& position) const { return (position[axis] - middle) / height; }
  bool is_half_way(const dvec3& position) const { return std::fabs(place(position)) <= kClose; }
};

/// Along the axis on which a triangle that crosses faces of the box is highest in it; nothing if
/// that is not more than `least`.
std::optional<Leap> leap_of(const Bounds& box, const Triangle& t, const dvec3& least,
                            const Mesh& mesh) {
  std::optional<Leap> highest;
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = [&](std::uint32_t corner) { return mesh.position[corner][axis]; };
    const auto [low, high] = std::ranges::minmax(t, {}, place);
    if (box.low[axis] <= place(low) && place(high) <= box.high[axis]) continue;
    const double bottom = std::max(place(low), box.low[axis]);
    const double top = std::min(place(high), box.high[axis]);
    const double height = top - bottom;
    if (!(height > least[axis]) || (highest && height <= highest->height)) continue;
    const Line line = {mesh.uv[low], mesh.uv[high]};
    highest = Leap{0, t, axis, 0.5 * bottom + 0.5 * top, height, line};
  }
  return highest;
}

/// Triangles in the box that cross its faces, in leaves as small as those along boundaries. In the
/// smallest leaves they are higher there than a few tolerances, in others than half of the box.
std::vector<Leap> leaps_of(const Bounds& box, const Mesh& vertices, const ValidatedMesh& mesh) {
  std::vector<Leap> leaps;
  const auto& p = vertices.position;
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    if (halvings_of_root(leaf) < kBoundaryHalvings || leaf.state.oscillates()) continue;
    const bool is_among_smallest = halvings_of_root(leaf) >= kMostCutHalvings;
    const dvec3 least = is_among_smallest ? dvec3(kMostSafety * mesh.allowed[k]) : 0.5 * box.size();
    for (const Triangle& t : mesh.triangles.of(k)) {
      if (is_beyond(box, std::array{p[t[0]], p[t[1]], p[t[2]]})) continue;
      std::optional<Leap> leap = leap_of(box, t, least, vertices);
      if (!leap) continue;
      leap->leaf = k;
      leaps.push_back(*leap);
    }
  }
  return leaps;
}

/// Halves the lines of leaps until the surface is found to go through, or they have no middle.
void follow(const Surface& surface, unsigned threads, std::vector<Leap>& leaps) {
  std::vector<std::size_t> open = all_open(leaps.size());
  const auto next = [](const Leap& leap) { return middle_of(leap.left); };
  const auto is_done = [](Leap& leap, const dvec2& middle, const dvec3& position) {
    if (leap.is_half_way(position)) leap.through = middle;
    leap.left[leap.place(position) < 0 ? 0 : 1] = middle;
    return leap.through || has_no_middle(leap.left);
  };
  bisect_together(surface, leaps, open, {kAllHalvings, threads}, next, is_done);
}

/// Drops places where the surface has a value of its own, as sign(u) has at 0.
void drop_own_values(const Surface& surface, unsigned threads, std::vector<Leap>& leaps) {
  std::vector<dvec2> beside;
  for (const Leap& leap : leaps) {
    if (leap.through) beside.push_back(glm::mix(*leap.through, leap.line[0], kSame));
  }
  const std::vector<dvec3> positions = evaluate_positions(surface, beside, threads);
  std::size_t next = 0;
  for (Leap& leap : leaps) {
    if (leap.through && !leap.is_half_way(positions[next++])) leap.through.reset();
  }
}

}  // namespace

void remove_walls(const Surface& surface, const Bounds& clip, const Mesh& vertices,
                  unsigned threads, ValidatedMesh& mesh) {
  std::vector<Leap> leaps = leaps_of(clip, vertices, mesh);
  follow(surface, threads, leaps);
  drop_own_values(surface, threads, leaps);
  for (const Leap& leap : leaps) {
    if (!leap.through) mesh.triangles.remove(leap.leaf, leap.triangle);
  }
  mesh.tidy_triangles();
}

}  // namespace saddle
