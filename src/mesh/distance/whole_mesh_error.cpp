#include "mesh/distance/whole_mesh_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "base/numbers.h"
#include "base/parallel.h"
#include "mesh/distance/descend.h"
#include "mesh/distance/lines_through_places.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Places of the mesh that are searched at most: 250 evaluations each.
constexpr std::size_t kMostSearched = 192;
/// The search climbs from the farthest kFirstSearched places of the mesh, in 4 rounds, if they are
/// within kClimbedShare of the largest distance.
constexpr int kClimbsOnMesh = 4;
/// Rounds of the climb in each of many triangles.
constexpr int kClimbsOfTriangles = 2;

std::array<dvec2, 3> parameters_of(const Triangle& t, const Mesh& mesh) {
  return {mesh.uv[t[0]], mesh.uv[t[1]], mesh.uv[t[2]]};
}

/// As far as a triangle reaches along one of the parameters, in shares of their ranges: along both.
dvec2 reach_of(const std::array<dvec2, 3>& corners, const dvec2& range) {
  const dvec2 size = box_around(corners).size() / range;
  return std::max(size.x, size.y) * range;
}

}  // namespace

double thickness_of(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.position;
  const double longest = std::max({glm::distance(p[t[0]], p[t[1]]), glm::distance(p[t[1]], p[t[2]]),
                                   glm::distance(p[t[2]], p[t[0]])});
  const double area = glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
  return longest > 0 ? area / longest : 0;
}

double WholeMeshError::distance(const Place& place, const dvec3& position) const {
  const double from_own = place.triangles.empty()
                              ? kInfinity
                              : distance_from(grid_, place.triangles, place.uv, position);
  return from_own > place.known ? tree_.distance(position, from_own, place.known) : from_own;
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
  std::vector<double> steps(climbs.size(), kCompassStep);
  for (int round = 0; round < kHalvingsToEdge; ++round) {
    std::vector<Place> places;
    for (std::size_t k = 0; k < climbs.size(); ++k) {
      const ParameterBox& box = climbs[k].within;
      for (const dvec2& way : kFourWays) {
        const dvec2 uv = climbs[k].best.uv + steps[k] * way * (box.high - box.low);
        places.push_back({nearest_in(box, uv), climbs[k].triangles, climbs[k].best.distance});
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
  return nearest_in(box_of(surface_.domain), uv);
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

/// The surface at the same parameters bounds a place's distance, and so do the corners. In the
/// order of the places.
std::vector<WholeMeshError::Expected> WholeMeshError::expect_of_each(
    std::span<const MeshPlace> places, unsigned threads) const {
  std::vector<MeshPlace> seen;
  std::vector<dvec2> uv;
  for (const MeshPlace& place : places) {
    if (!is_seen(clip_, position_of(place))) continue;
    seen.push_back(place);
    uv.push_back(uv_of(place));
  }
  const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads);
  std::vector<Expected> result;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (!is_finite(points[k])) continue;
    const dvec3 p = position_of(seen[k]);
    double near = glm::distance(p, points[k]);
    for (const std::uint32_t corner : *seen[k].triangle)
      near = std::min(near, glm::distance(p, grid_.mesh.position[corner]));
    result.push_back({seen[k], near, near});
  }
  return result;
}

std::vector<WholeMeshError::Expected> WholeMeshError::expect(
    std::span<const MeshPlace> places) const {
  std::vector<Expected> result = expect_of_each(places, threads_);
  std::ranges::stable_sort(result, std::ranges::greater(), &Expected::distance);
  return result;
}

std::vector<WholeMeshError::Nearest> WholeMeshError::search(std::span<const Expected> places,
                                                            double least, double tolerance) const {
  const dvec2 range = box_of(surface_.domain).size();
  LinesThroughPlaces lines(least, kUnnoticed * tolerance, has_cliffs_);
  std::vector<Nearest> result;
  for (const Expected& expected : places) {
    const dvec2 uv = uv_of(expected.place);
    const std::array<dvec2, 3> corners = parameters_of(*expected.place.triangle, grid_.mesh);
    const dvec2 reach = reach_of(corners, range);
    lines.add_place(position_of(expected.place), uv, corners, reach);
    result.push_back({expected.place, {expected.near, uv}, kCompassStep * reach});
  }
  lines.begin();
  for (std::size_t round = 0; round < LinesThroughPlaces::kRounds && !lines.is_done(); ++round) {
    std::vector<dvec2> uv = lines.places();
    for (dvec2& at : uv) at = within_domain(at);
    lines.add_samples(evaluate_positions(surface_, uv, threads_));
    lines.go_on(round);
  }
  for (std::size_t k = 0; k < result.size(); ++k) lines.improve(k, result[k].error);
  return result;
}

/// Other waves may be nearer to a place than all of the surface around its parameters. Where the
/// mesh is not known, they are not looked for.
void WholeMeshError::begin_at_vertices(std::span<Nearest> nearest) const {
  if (all_.empty()) return;
  for (Nearest& n : nearest) {
    const auto [distance, corner] = tree_.nearest_corner(position_of(n.place), n.error.distance);
    if (corner) n.error = {distance, grid_.mesh.uv[*corner]};
  }
}

/// A compass search for places of the surface that are nearer.
void WholeMeshError::search_around(std::span<Nearest> nearest) const {
  for (int round = 0; round < kHalvingsToNearly; ++round) {
    std::vector<dvec2> uv;
    uv.reserve(kFourWays.size() * nearest.size());
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

/// The places that a few steps straight towards the surface leave farther than `least`, and how far
/// they leave them. Most places come within it so, for a fraction of what a search along lines
/// takes.
std::vector<WholeMeshError::Expected> WholeMeshError::descend_to_least(
    std::span<const Expected> places, double least) const {
  const ParameterBox domain = box_of(surface_.domain);
  std::vector<Descending> points;
  for (const Expected& expected : places) {
    const dvec2 uv = uv_of(expected.place);
    const dvec2 reach =
        reach_of(parameters_of(*expected.place.triangle, grid_.mesh), domain.size());
    const ParameterBox within = {nearest_in(domain, uv - reach), nearest_in(domain, uv + reach)};
    points.push_back({position_of(expected.place), uv, within, least});
  }
  const std::vector<PlacedError> nearest =
      descend(surface_, points, kHalvingsOfSecondOrder, threads_);
  std::vector<Expected> rest;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (nearest[k].distance <= least) continue;
    rest.push_back(places[k]);
    rest.back().distance = std::min(rest.back().distance, nearest[k].distance);
  }
  return rest;
}

std::vector<WholeMeshError::Nearest> WholeMeshError::search_all(std::span<const Expected> places,
                                                                double least,
                                                                double tolerance) const {
  std::vector<Nearest> found = search(places, least, tolerance);
  const auto is_near = [&](const Nearest& n) { return !(n.error.distance > least); };
  std::erase_if(found, is_near);
  begin_at_vertices(found);
  search_around(found);
  std::erase_if(found, is_near);
  return found;
}

std::vector<WholeMeshError::Nearest> WholeMeshError::search_above(std::span<const Expected> places,
                                                                  double least,
                                                                  double tolerance) const {
  return search_all(descend_to_least(places, least), least, tolerance);
}

std::vector<WholeMeshError::Nearest> WholeMeshError::all_above(std::span<const MeshPlace> places,
                                                               double least, double enough) const {
  const std::vector<Expected> expected = expect(places);
  std::vector<Nearest> result;
  for (std::size_t next = 0;
       next < expected.size() && expected[next].distance > least && surface_.may_go_on();
       next += kSearchedTogether) {
    const auto some =
        std::span(expected).subspan(next, std::min(kSearchedTogether, expected.size() - next));
    std::vector<Expected> far;
    for (const Expected& e : descend_to_least(some, least)) {
      if (e.distance > enough) {
        far.push_back(e);
      } else {
        result.push_back({e.place, {e.distance, uv_of(e.place)}, {}});
      }
    }
    const std::vector<Nearest> found = search_all(far, least, least);
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
  keep_farthest(all_above(places, least, enough));
  double step = kCompassStep;
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
    keep_farthest(all_above(beside, least, enough));
  }
  std::vector<FarTriangle> result;
  result.reserve(farthest.size());
  for (const Nearest& n : farthest) result.push_back({n.place.triangle, n.error.distance});
  return result;
}

/// Moves places of the mesh towards the corners of their triangles where they are farther off.
void WholeMeshError::climb_on_mesh(std::span<Nearest> places, double tolerance) const {
  double step = kCompassStep;
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

/// The places of triangles thicker than `thin` that are expected to be farther than `least`, the
/// farthest first. Along a steep wall places are far from what is known of the surface, but the
/// wall is near: triangles there are thin.
std::vector<WholeMeshError::Expected> WholeMeshError::expect_above(
    std::span<const Triangle* const> triangles, double thin, double least) const {
  std::vector<MeshPlace> places;
  for (const Triangle* const t : triangles) {
    if (!(thickness_of(grid_.mesh, *t) > std::max(thin, least))) continue;
    for (const dvec3& weights : kMiddlesOfTriangle) places.push_back({t, weights});
  }
  std::vector<Expected> above = expect_of_each(places, 1);
  for (Expected& expected : above) {
    expected.distance = std::min(expected.near, thickness_of(grid_.mesh, *expected.place.triangle));
  }
  std::erase_if(above, [least](const Expected& expected) { return !(expected.distance > least); });
  std::ranges::stable_sort(above, std::ranges::greater(), [](const Expected& expected) {
    return std::pair(expected.distance, expected.near);
  });
  return above;
}

/// The places that are expected to be farthest, 192 at most. Triangles are taken a part at a time:
/// there may be millions.
std::vector<WholeMeshError::Expected> WholeMeshError::expect_farthest(
    std::span<const Triangle* const> triangles, double known) const {
  std::vector<Expected> farthest;
  for (auto rest = triangles; !rest.empty();) {
    const auto some = rest.first(std::min(rest.size(), kKeptAtATime));
    rest = rest.subspan(some.size());
    const double least = farthest.size() < kMostSearched ? 0 : farthest.back().distance;
    const std::vector<std::vector<Expected>> found =
        results_of_chunks(some.size(), kInBatch, threads_, [&](std::size_t begin, std::size_t end) {
          return expect_above(some.subspan(begin, end - begin), known, least);
        });
    for (const std::vector<Expected>& more : found) {
      std::vector<Expected> both;
      std::ranges::merge(farthest, more, std::back_inserter(both), std::ranges::greater(),
                         &Expected::distance, &Expected::distance);
      if (both.size() > kMostSearched) both.resize(kMostSearched);
      farthest = std::move(both);
    }
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
