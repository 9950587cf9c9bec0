// Bisection of many lines of parameters at a time: a round evaluates the surface at one place of
// each line that is still open, all in one batch.
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

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
