#include "mesh/distance/beyond_chords.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/distance/sampled_error.h"
#include "mesh/model/clip.h"

namespace saddle {

void BeyondChords::add(const ParameterBox& box, std::size_t leaf,
                       std::span<const Triangle> triangles, const Triangle& t, double allowed) {
  const auto& [a, b, c] = t;
  const auto& uv = grid_.mesh.uv;
  const auto& position = grid_.mesh.position;
  const dvec2 ab = uv[b] - uv[a];
  const dvec2 ac = uv[c] - uv[a];
  const double area = cross(ab, ac);
  for (const int axis : {0, 1}) {
    const int other = 1 - axis;
    // The triangle's point moves so far for a step along the axis.
    const dvec3 moved =
        (ac[other] * (position[b] - position[a]) - ab[other] * (position[c] - position[a])) / area;
    const double outward = (area > 0) == (axis == 0) ? ab[other] : -ab[other];
    double step = std::copysign(allowed / glm::length(moved), outward);
    const double from =
        step > 0 ? std::max(uv[a][axis], uv[b][axis]) : std::min(uv[a][axis], uv[b][axis]);
    // Beside a pole the triangle may be so long that the step is 0: then nothing is looked for.
    if (outward == 0 || !std::isnormal(step) || !std::isfinite(from)) continue;
    while (from + step == from) step *= 2;
    open_.push_back({box, leaf, triangles, allowed, axis, from, step});
  }
}

/// The next line beyond a chord, in its leaf.
std::optional<Line> BeyondChords::next_line(Beyond& beyond) {
  Line line = {beyond.box.low, beyond.box.high};
  const double at = beyond.from + beyond.step;
  beyond.step *= 2;
  const auto [low, high] = std::minmax(line[0][beyond.axis], line[1][beyond.axis]);
  if (!(low < at && at < high)) return std::nullopt;
  for (dvec2& end : line) end[beyond.axis] = at;
  return line;
}

std::vector<LeafDistance> BeyondChords::measure() {
  std::vector<LeafDistance> found;
  while (!open_.empty()) {
    std::vector<AlikeEnds> lines;
    std::vector<Beyond> next;
    for (Beyond& beyond : open_) {
      if (const auto line = next_line(beyond)) {
        lines.push_back({*line, false});
        next.push_back(beyond);
      }
    }
    const auto inside = find_thin_parts(surface_, lines, threads_, looks_);
    std::vector<dvec2> uv;
    open_.clear();
    for (std::size_t k = 0; k < inside.size(); ++k) {
      if (!inside[k]) continue;
      uv.push_back(*inside[k]);
      open_.push_back(next[k]);
    }
    const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
    looks_ += points.size();
    std::size_t number = 0;
    std::erase_if(open_, [&](const Beyond& beyond) {
      const std::size_t k = number++;
      if (!is_seen(clip_, points[k])) return false;
      const double distance = distance_from(grid_, beyond.triangles, uv[k], points[k]);
      if (!(distance > beyond.allowed)) return false;
      found.push_back({beyond.leaf, distance, false, uv[k]});
      return true;
    });
  }
  return found;
}

}  // namespace saddle
