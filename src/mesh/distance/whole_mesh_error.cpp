#include "mesh/distance/whole_mesh_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/parallel.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/model/clip.h"
#include "mesh/model/nearest_on_line.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// The first step of a compass search, in sizes of the box; a round without success halves it.
constexpr double kFirstStep = 0.25;
/// Further directions, as parts of the way in u and in v: with those of the parameters one is
/// within 11 degrees of the direction straight across a steep wall, and too long by 2 % at most.
constexpr std::array kAslant = {dvec2(1, 1),      dvec2(1, -1),      dvec2(1, 0.4142),
                                dvec2(0.4142, 1), dvec2(1, -0.4142), dvec2(0.4142, -1)};
/// Lines through a place of the mesh: two of parameters, three to the corners, and those aslant, if
/// there are cliffs.
constexpr std::size_t kStraight = 5;
constexpr std::size_t kLines = kStraight + kAslant.size();
/// Lines that are sampled after each of the first rounds: the next ones begin where a place is
/// still too far off.
constexpr std::array<std::size_t, 4> kBegun = {1, 2, kStraight, kLines};
/// Places of the mesh that are searched at most: 250 evaluations each.
constexpr std::size_t kMostSearched = 192;
/// The search climbs from the farthest kFirstSearched places of the mesh, in 4 rounds, if they are
/// within 0.5 of the largest distance: a place of a side's middle may have half of the side's
/// error.
constexpr int kClimbsOnMesh = 4;
constexpr double kClimbedShare = 0.5;
/// Rounds of the climb in each of many triangles.
constexpr int kClimbsOfTriangles = 2;

}  // namespace

double thickness_of(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.position;
  const double longest = std::max({glm::distance(p[t[0]], p[t[1]]), glm::distance(p[t[1]], p[t[2]]),
                                   glm::distance(p[t[2]], p[t[0]])});
  const double area = glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
  return longest > 0 ? area / longest : 0;
}

const TriangleTree& WholeMeshError::tree() const {
  std::call_once(has_tree_,
                 [this] { tree_.emplace(grid_.mesh.position, all_, surface_.tangents.count); });
  return *tree_;
}

double WholeMeshError::distance(const Place& place, const dvec3& position) const {
  if (place.triangles.empty()) return tree().distance(position);
  const double from_own = distance_from(grid_, place.triangles, place.uv, position);
  return from_own > place.known ? tree().distance(position, from_own) : from_own;
}

std::vector<double> WholeMeshError::distances(std::span<const Place> places) const {
  std::vector<dvec2> uv(places.size());
  std::ranges::transform(places, uv.begin(), &Place::uv);
  const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
  std::vector<double> result(uv.size());
  parallel_chunks(uv.size(), kSearchedTogether, threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const dvec3& p = points[k];
      if (is_seen(clip_, p)) result[k] = distance(places[k], p);
    }
  });
  return result;
}

void WholeMeshError::climb(std::span<Climb> climbs) const {
  std::vector<double> steps(climbs.size(), kFirstStep);
  for (int round = 0; round < kHalvingsToEdge; ++round) {
    std::vector<Place> places;
    for (std::size_t k = 0; k < climbs.size(); ++k) {
      const ParameterBox& box = climbs[k].within;
      for (const dvec2& way : kFourWays) {
        const dvec2 uv = climbs[k].best.uv + steps[k] * way * (box.high - box.low);
        places.push_back({glm::clamp(uv, glm::min(box.low, box.high), glm::max(box.low, box.high)),
                          climbs[k].triangles, climbs[k].best.distance});
      }
    }
    const std::vector<double> found = distances(places);
    for (std::size_t k = 0; k < climbs.size(); ++k) {
      const double before = climbs[k].best.distance;
      for (std::size_t i = k * kFourWays.size(); i < (k + 1) * kFourWays.size(); ++i) {
        if (found[i] > climbs[k].best.distance) climbs[k].best = {found[i], places[i].uv};
      }
      if (!(climbs[k].best.distance > before)) steps[k] /= 2;
    }
  }
}

dvec2 WholeMeshError::within_domain(const dvec2& uv) const {
  const ParameterBox domain = box_of(surface_.domain);
  return glm::clamp(uv, glm::min(domain.low, domain.high), glm::max(domain.low, domain.high));
}

dvec2 WholeMeshError::uv_of(const MeshPlace& place) const {
  const auto& uv = grid_.mesh.uv;
  const Triangle& t = *place.triangle;
  const dvec3& w = place.weights;
  return w.x * uv[t[0]] + w.y * uv[t[1]] + w.z * uv[t[2]];
}

dvec3 WholeMeshError::position_of(const MeshPlace& place) const {
  const auto& p = grid_.mesh.position;
  const Triangle& t = *place.triangle;
  const dvec3& w = place.weights;
  return w.x * p[t[0]] + w.y * p[t[1]] + w.z * p[t[2]];
}

/// The surface at the same parameters bounds a place's distance, and so do the corners.
std::vector<WholeMeshError::Expected> WholeMeshError::expect(
    std::span<const MeshPlace> places) const {
  std::vector<MeshPlace> seen;
  std::vector<dvec2> uv;
  for (const MeshPlace& place : places) {
    if (!is_seen(clip_, position_of(place))) continue;
    seen.push_back(place);
    uv.push_back(uv_of(place));
  }
  const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
  std::vector<Expected> result;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (!is_finite(points[k])) continue;
    const dvec3 p = position_of(seen[k]);
    double near = glm::distance(p, points[k]);
    for (const std::uint32_t corner : *seen[k].triangle)
      near = std::min(near, glm::distance(p, grid_.mesh.position[corner]));
    result.push_back({seen[k], near, near});
  }
  std::ranges::stable_sort(result, std::ranges::greater(), &Expected::distance);
  return result;
}

/// Searches the surface along lines through each place: both lines of parameters, as far to both
/// sides as its triangle reaches along one of them, the lines to the corners, and others. Both
/// lines of parameters start from samples within the triangle's own extent, too: a triangle along a
/// ridge is much longer than the ridge is wide. A line is sampled only where the samples of those
/// before it are too far off.
std::vector<WholeMeshError::Nearest> WholeMeshError::search(std::span<const Expected> places,
                                                            double least, double tolerance) const {
  constexpr std::array<double, 9> kStarts = {-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1};
  const dvec2 range = box_of(surface_.domain).size();
  std::vector<Nearest> result;
  std::vector<NearestOnLine> lines;
  std::vector<double> own;  // the triangle's own extent, as a share of each line
  std::vector<std::pair<std::size_t, double>> tries;
  for (const Expected& expected : places) {
    dvec2 low = grid_.mesh.uv[(*expected.place.triangle)[0]];
    dvec2 high = low;
    for (const std::uint32_t corner : *expected.place.triangle) {
      low = glm::min(low, grid_.mesh.uv[corner]);
      high = glm::max(high, grid_.mesh.uv[corner]);
    }
    const dvec3 p = position_of(expected.place);
    const dvec2 uv = uv_of(expected.place);
    const dvec2 size = (high - low) / range;
    const dvec2 reach = std::max(size.x, size.y) * range;
    for (int axis = 0; axis < 2; ++axis) {
      dvec2 way(0);
      way[axis] = reach[axis];
      own.push_back((high[axis] - low[axis]) / reach[axis]);
      lines.emplace_back(p, uv, way);
    }
    for (const std::uint32_t corner : *expected.place.triangle)
      lines.emplace_back(p, uv, grid_.mesh.uv[corner] - uv);
    for (const dvec2& direction : kAslant) lines.emplace_back(p, uv, reach * direction);
    own.resize(lines.size());
    result.push_back({expected.place, {expected.near, uv}, kFirstStep * reach});
  }
  const auto begin = [&](std::size_t k) {
    lines[k].reserve(2 * kStarts.size());
    for (const double t : kStarts) {
      tries.emplace_back(k, t);
      if (own[k] > 0 && own[k] < 1) tries.emplace_back(k, own[k] * t);
    }
  };
  for (std::size_t first = 0; first < lines.size(); first += kLines) begin(first);
  for (std::size_t round = 0; round < kBegun.size() + kHalvingsToEdge && !tries.empty(); ++round) {
    std::vector<dvec2> uv;
    for (const auto& [k, t] : tries) uv.push_back(within_domain(lines[k].uv(t)));
    const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
    for (std::size_t i = 0; i < tries.size(); ++i)
      lines[tries[i].first].add(tries[i].second, points[i]);
    tries.clear();
    const std::size_t begun = round < kBegun.size() ? kBegun[round] : kLines;
    const std::size_t next = round + 1 < kBegun.size() ? kBegun[round + 1] : kLines;
    for (std::size_t first = 0; first < lines.size(); first += kLines) {
      const auto of_place = std::span(lines).subspan(first, kLines);
      const auto is_near = [&](const NearestOnLine& line) { return line.distance() <= least; };
      if (std::ranges::any_of(of_place, is_near)) continue;
      if (begun < kStraight || has_cliffs_) {
        for (std::size_t k = first + begun; k < first + next; ++k) begin(k);
      }
      for (std::size_t k = first; k < first + begun && round > 0; ++k) {
        if (const auto t = lines[k].next(kUnnoticed * tolerance)) tries.emplace_back(k, *t);
      }
    }
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    PlacedError& error = result[k / kLines].error;
    if (lines[k].distance() < error.distance) error = {lines[k].distance(), lines[k].nearest()};
  }
  return result;
}

/// A compass search for places of the surface that are nearer.
void WholeMeshError::descend(std::span<Nearest> nearest) const {
  for (int round = 0; round < kHalvingsToNearly; ++round) {
    std::vector<dvec2> uv;
    for (const Nearest& n : nearest) {
      for (const dvec2& way : kFourWays) uv.push_back(within_domain(n.error.uv + n.reach * way));
    }
    const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
    for (std::size_t k = 0; k < nearest.size(); ++k) {
      PlacedError& error = nearest[k].error;
      const dvec3 p = position_of(nearest[k].place);
      const double before = error.distance;
      for (std::size_t i = k * kFourWays.size(); i < (k + 1) * kFourWays.size(); ++i) {
        const double distance = glm::distance(p, points[i]);
        if (distance < error.distance) error = {distance, uv[i]};
      }
      if (!(error.distance < before)) nearest[k].reach *= 0.5;
    }
  }
}

std::vector<WholeMeshError::Nearest> WholeMeshError::search_above(std::span<const Expected> places,
                                                                  double least,
                                                                  double tolerance) const {
  std::vector<Nearest> found = search(places, least, tolerance);
  const auto is_near = [&](const Nearest& n) { return !(n.error.distance > least); };
  std::erase_if(found, is_near);
  descend(found);
  std::erase_if(found, is_near);
  return found;
}

/// search_above() for all places that may be farther.
std::vector<WholeMeshError::Nearest> WholeMeshError::all_above(std::span<const MeshPlace> places,
                                                               double least) const {
  const std::vector<Expected> expected = expect(places);
  std::vector<Nearest> result;
  for (std::size_t next = 0;
       next < expected.size() && expected[next].distance > least && surface_.may_go_on();
       next += kSearchedTogether) {
    const auto some =
        std::span(expected).subspan(next, std::min(kSearchedTogether, expected.size() - next));
    const std::vector<Nearest> found = search_above(some, least, least);
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

std::vector<WholeMeshError::FarTriangle> WholeMeshError::farther_than(
    double least, double enough, std::span<const MeshPlace> places) const {
  std::vector<Nearest> farthest;  // of each triangle
  const auto keep_farthest = [&](std::span<const Nearest> found) {
    farthest.insert(farthest.end(), found.begin(), found.end());
    std::ranges::stable_sort(farthest, [](const Nearest& a, const Nearest& b) {
      if (a.place.triangle != b.place.triangle) return a.place.triangle < b.place.triangle;
      return a.error.distance > b.error.distance;
    });
    const auto is_same = [](const Nearest& a, const Nearest& b) {
      return a.place.triangle == b.place.triangle;
    };
    farthest.erase(std::unique(farthest.begin(), farthest.end(), is_same), farthest.end());
  };
  keep_farthest(all_above(places, least));
  double step = kFirstStep;
  for (int round = 0; round < kClimbsOfTriangles; ++round, step /= 2) {
    std::vector<MeshPlace> beside;
    for (const Nearest& n : farthest) {
      if (n.error.distance > enough) continue;
      for (int corner = 0; corner < 3; ++corner) {
        dvec3 towards(0);
        towards[corner] = 1;
        beside.push_back({n.place.triangle, glm::mix(n.place.weights, towards, step)});
      }
    }
    keep_farthest(all_above(beside, least));
  }
  std::vector<FarTriangle> result;
  for (const Nearest& n : farthest) result.push_back({n.place.triangle, n.error.distance});
  return result;
}

/// Moves places of the mesh towards the corners of their triangles where they are farther off.
void WholeMeshError::climb_on_mesh(std::span<Nearest> places, double tolerance) const {
  double step = kFirstStep;
  for (int round = 0; round < kClimbsOnMesh; ++round, step /= 2) {
    for (Nearest& n : places) {
      std::vector<MeshPlace> beside;
      for (int corner = 0; corner < 3; ++corner) {
        dvec3 towards(0);
        towards[corner] = 1;
        beside.push_back({n.place.triangle, glm::mix(n.place.weights, towards, step)});
      }
      const std::vector<Expected> expected = expect(beside);
      for (const Nearest& other : search_above(expected, n.error.distance, tolerance)) {
        if (other.error.distance > n.error.distance) n = other;
      }
    }
  }
}

/// The places of triangles that are expected to be farthest, 192 at most. Along a steep wall places
/// are far from what is known of the surface, but the wall is near: triangles there are thin.
/// Triangles are taken a part at a time: there may be millions.
std::vector<WholeMeshError::Expected> WholeMeshError::expect_farthest(
    std::span<const Triangle* const> triangles, double known) const {
  std::vector<Expected> farthest;
  for (auto rest = triangles; !rest.empty();) {
    const auto some = rest.first(std::min(rest.size(), kInBatch));
    rest = rest.subspan(some.size());
    std::vector<MeshPlace> places;
    for (const Triangle* const t : some) {
      if (!(thickness_of(grid_.mesh, *t) > known)) continue;
      for (const dvec3& weights : kMiddlesOfTriangle) places.push_back({t, weights});
    }
    std::vector<Expected> more = expect(places);
    for (Expected& expected : more) {
      expected.distance =
          std::min(expected.near, thickness_of(grid_.mesh, *expected.place.triangle));
    }
    std::ranges::stable_sort(more, std::ranges::greater(), &Expected::distance);
    std::vector<Expected> both;
    std::ranges::merge(farthest, more, std::back_inserter(both), std::ranges::greater(),
                       &Expected::distance, &Expected::distance);
    if (both.size() > kMostSearched) both.resize(kMostSearched);
    farthest = std::move(both);
  }
  return farthest;
}

PlacedError WholeMeshError::from_mesh(std::span<const Triangle* const> triangles, double known,
                                      double tolerance) const {
  const std::vector<Expected> expected = expect_farthest(triangles, std::max(known, tolerance));
  std::vector<Nearest> farthest;
  double least = kClimbedShare * std::max(known, tolerance);
  for (std::size_t next = 0;
       next < expected.size() && expected[next].distance > least && surface_.may_go_on();
       next += kSearchedTogether) {
    const auto some =
        std::span(expected).subspan(next, std::min(kSearchedTogether, expected.size() - next));
    const std::vector<Nearest> found = search_above(some, least, tolerance);
    farthest.insert(farthest.end(), found.begin(), found.end());
    std::ranges::stable_sort(farthest, std::ranges::greater(),
                             [](const Nearest& n) { return n.error.distance; });
    if (farthest.size() > kFirstSearched) farthest.resize(kFirstSearched);
    if (!farthest.empty()) least = std::max(least, kClimbedShare * farthest.front().error.distance);
  }
  climb_on_mesh(farthest, tolerance);
  PlacedError worst{known, {}};
  for (const Nearest& n : farthest) {
    if (n.error.distance > worst.distance) worst = {n.error.distance, uv_of(n.place)};
  }
  return worst;
}

}  // namespace saddle
