#include "mesh/distance/crease_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "mesh/distance/descend.h"
#include "mesh/features/bisect_together.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// The surface is not upright if 12 halvings shorten a line's image to 1/512. The image of a root
/// shortens to 1/64, that of a crease with finite slopes to little more than kOfSecondOrder.
constexpr double kPlainShare = 1.0 / 512;

dvec3 area_of(const SurfacePoint& p) {
  return glm::cross(p.r_u, p.r_v);
}

std::vector<dvec2> ends_of(std::span<const Line> lines, std::size_t end) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) uv.push_back(line[end]);
  return uv;
}

/// A line across a crease during bisection.
struct CreaseSearch {
  std::size_t number;             ///< of the line
  Line left;                      ///< the part that holds the crease
  std::array<dvec3, 2> position;  ///< of its ends
  std::array<dvec3, 2> normal;    ///< at the ends of the line
  double cosine;                  ///< of the angle between these
  double first_way = 0;           ///< length of the whole line's image
  double way = 0;                 ///< length of the image of `left`
  int halvings = 0;

  /// Whether there is no cusp, and the surface is not upright. Across a cusp normals are nearly
  /// opposite; towards an upright surface they turn less.
  bool is_plain() const {
    if (halvings != kHalvingsOfSecondOrder || cosine < -kSteepCosine) return false;
    return !(cosine < kSteepCosine) || way <= kPlainShare * first_way;
  }
  /// An upright surface moves far while its parameters hardly change: bisection goes on until its
  /// image is short, too, or for kAllHalvings.
  bool is_done() const {
    const bool has_arrived =
        halvings >= kHalvingsOfSecondOrder && !(way > kOfSecondOrder * first_way);
    return has_arrived || has_no_middle(left);
  }
};

std::vector<CreaseSearch> searches_on(const Surface& surface, std::span<const Line> lines,
                                      unsigned threads) {
  const std::vector<SurfacePoint> first = evaluate(surface, ends_of(lines, 0), threads);
  const std::vector<SurfacePoint> last = evaluate(surface, ends_of(lines, 1), threads);
  const double least_turn = std::cos(kCreaseDegrees * std::numbers::pi / 180);
  std::vector<CreaseSearch> searches;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::array normal = {glm::normalize(area_of(first[k])), glm::normalize(area_of(last[k]))};
    const double cosine = glm::dot(normal[0], normal[1]);
    if (!(cosine < least_turn)) continue;
    const std::array position = {first[k].position, last[k].position};
    searches.push_back({k, lines[k], position, normal, cosine});
  }
  return searches;
}

/// Keeps the half that holds the crease.
void narrow(CreaseSearch& search, const dvec2& middle, const SurfacePoint& at_middle) {
  search.way = glm::distance(search.position[0], at_middle.position) +
               glm::distance(at_middle.position, search.position[1]);
  if (search.halvings == 0) search.first_way = search.way;
  const dvec3 area = area_of(at_middle);
  const double to_first = glm::dot(area, search.normal[0]);
  const double to_last = glm::dot(area, search.normal[1]);
  const std::size_t end = to_first >= to_last ? 0 : 1;
  search.left[end] = middle;
  search.position[end] = at_middle.position;
  ++search.halvings;
}

/// Distances from the surface by descents that start at these places.
std::vector<double> distances_from(std::span<const dvec2> places, const Surface& surface,
                                   std::span<const MiddleOfChord> chords, unsigned threads) {
  std::vector<Descending> points;
  for (std::size_t k = 0; k < chords.size(); ++k) {
    const MiddleOfChord& chord = chords[k];
    const dvec2 middle = middle_of(chord.ends);
    const ParameterBox within = {middle - chord.reach, middle + chord.reach};
    points.push_back({chord.middle(), places[k], within, chord.known});
  }
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const auto& [distance, uv] : descend(surface, points, kHalvingsOfSecondOrder, threads))
    distances.push_back(std::isfinite(distance) ? distance : 0);
  return distances;
}

/// Where, on the lines between the chords' ends, the surface is straight above their middles.
std::vector<dvec2> places_above(const Surface& surface, std::span<const MiddleOfChord> chords,
                                unsigned threads) {
  struct Search {
    const MiddleOfChord* chord;
    Line left;
    dvec2 place;  ///< the last middle
  };
  std::vector<Search> searches;
  for (const MiddleOfChord& chord : chords) {
    searches.push_back({&chord, chord.ends, middle_of(chord.ends)});
  }
  std::vector<std::size_t> open = all_open(searches.size());
  const auto next = [](const Search& search) { return middle_of(search.left); };
  const auto is_done = [](Search& search, const dvec2& middle, const dvec3& position) {
    const dvec3 along = search.chord->positions[1] - search.chord->positions[0];
    const double beyond = glm::dot(position - search.chord->middle(), along);
    search.place = middle;
    search.left[beyond < 0 ? 0 : 1] = middle;
    return std::fabs(beyond) <= kOfSecondOrder * glm::dot(along, along) ||
           has_no_middle(search.left);
  };
  bisect_together(surface, searches, open, {kHalvingsToLeast, threads}, next, is_done);
  std::vector<dvec2> places;
  places.reserve(searches.size());
  for (const Search& search : searches) places.push_back(search.place);
  return places;
}

}  // namespace

std::vector<std::optional<CreasePlace>> crease_places(const Surface& surface,
                                                      std::span<const Line> lines,
                                                      unsigned threads) {
  std::vector<std::optional<CreasePlace>> places(lines.size());
  std::vector<CreaseSearch> searches = searches_on(surface, lines, threads);
  std::vector<std::size_t> open = all_open(searches.size());
  const auto next = [](const CreaseSearch& search) { return middle_of(search.left); };
  const auto is_done = [](CreaseSearch& search, const dvec2& middle, const SurfacePoint& point) {
    narrow(search, middle, point);
    return search.is_plain() || search.is_done();
  };
  bisect_together(surface, searches, open, {kAllHalvings, threads}, next, is_done);
  for (const CreaseSearch& search : searches)
    places[search.number] = CreasePlace{search.left[0], search.is_plain()};
  return places;
}

std::vector<double> distances_from_surface(const Surface& surface,
                                           std::span<const MiddleOfChord> chords,
                                           unsigned threads) {
  std::vector<dvec2> middles(chords.size());
  std::ranges::transform(chords, middles.begin(), [](const auto& c) { return middle_of(c.ends); });
  std::vector<double> distances = distances_from(middles, surface, chords, threads);
  // Steps leap across a cusp that the surface approaches ever more steeply; bisection does not.
  std::vector<MiddleOfChord> rest;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < chords.size(); ++k) {
    if (distances[k] <= chords[k].allowed) continue;
    rest.push_back(chords[k]);
    numbers.push_back(k);
  }
  const std::vector<double> others =
      distances_from(places_above(surface, rest, threads), surface, rest, threads);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    distances[numbers[i]] = std::min(distances[numbers[i]], others[i]);
  }
  return distances;
}

}  // namespace saddle
