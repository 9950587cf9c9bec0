// Bisection of many lines of parameters at a time: a round evaluates the surface at one place of
// each line that is still open, all in one batch.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

#include <glm/common.hpp>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

inline dvec2 middle_of(const Line& line) {
  return 0.5 * line[0] + 0.5 * line[1];
}

/// Whether there are no doubles between the ends of a line.
inline bool has_no_middle(const Line& line) {
  const dvec2 middle = middle_of(line);
  return middle == line[0] || middle == line[1];
}

/// Two doubles, as a share of a line: a place nearer to an end may be that end.
inline double least_share(const Line& line) {
  constexpr double kLeastStep = 2 * std::numeric_limits<double>::epsilon();
  const dvec2 way = glm::abs(line[1] - line[0]);
  const dvec2 place = glm::max(glm::abs(line[0]), glm::abs(line[1]));
  return kLeastStep * std::max(place.x, place.y) / std::max(way.x, way.y);
}

/// The share of a line at which to look for a zero between values of different signs at its ends:
/// that of their chord, moved a little toward the middle, so that both ends come close, and so near
/// to it that no more than `widest` is left. That and `width`, which is left of the line by now,
/// are in parts of the whole line. Source: I. F. D. Oliveira, R. H. C. Takahashi, "An enhancement
/// of the bisection method average performance preserving minmax optimality", 2020, with kappa_1 =
/// 0.2 and kappa_2 = 2.
inline double share_of_zero(double first, double last, double width, double widest) {
  constexpr double kAside = 0.2;
  const double on_chord = first / (first - last);
  const double side = on_chord < 0.5 ? 1 : -1;
  const double inward = std::max(std::fabs(0.5 - on_chord) - kAside * width, 0.0);
  const double farthest = std::max(widest / width - 0.5, 0.0);
  return 0.5 - side * std::min(inward, farthest);
}

/// Numbers of all of `count` searches.
inline std::vector<std::size_t> all_open(std::size_t count) {
  std::vector<std::size_t> open(count);
  std::iota(open.begin(), open.end(), std::size_t{0});
  return open;
}

/// How many rounds there are at most, and the threads for each.
struct Rounds {
  int most = 0;
  unsigned threads = 1;
};

/// Runs rounds on the searches whose numbers are in `open`. A round evaluates
/// the surface at place(search) of each. Then is_done(search, uv, point) narrows the search to one
/// of its parts, and tells whether it ends: its number leaves `open`. The point is a SurfacePoint,
/// or a position, if is_done() takes one.
template <class Search, class Place, class IsDone>
void bisect_together(const Surface& surface, std::vector<Search>& searches,
                     std::vector<std::size_t>& open, const Rounds& rounds, Place place,
                     IsDone is_done) {
  std::vector<dvec2> uv;
  for (int round = 0; round < rounds.most && !open.empty(); ++round) {
    uv.clear();
    for (const std::size_t k : open) uv.push_back(place(searches[k]));
    const auto points = [&] {
      if constexpr (std::is_invocable_v<IsDone, Search&, const dvec2&, const SurfacePoint&>) {
        return evaluate(surface, uv, rounds.threads);
      } else {
        return evaluate_positions(surface, uv, rounds.threads);
      }
    }();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const std::size_t k = open[i];
      if (!is_done(searches[k], uv[i], points[i])) open[kept++] = k;
    }
    open.resize(kept);
  }
}

}  // namespace saddle
