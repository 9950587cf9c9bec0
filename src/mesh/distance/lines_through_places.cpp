#include "mesh/distance/lines_through_places.h"

#include <algorithm>

#include <glm/common.hpp>

#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {
namespace {

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

}  // namespace

const std::size_t LinesThroughPlaces::kRounds = kBegun.size() + kHalvingsToEdge;

void LinesThroughPlaces::add_place(const dvec3& position, const dvec2& uv,
                                   const std::array<dvec2, 3>& corners, const dvec2& reach) {
  const dvec2 size = box_around(corners).size();
  for (int axis = 0; axis < 2; ++axis) {
    dvec2 way(0);
    way[axis] = reach[axis];
    own_.push_back(size[axis] / reach[axis]);
    lines_.emplace_back(position, uv, way);
  }
  for (const dvec2& corner : corners) lines_.emplace_back(position, uv, corner - uv);
  for (const dvec2& direction : kAslant) lines_.emplace_back(position, uv, reach * direction);
  own_.resize(lines_.size());
}

void LinesThroughPlaces::begin() {
  for (std::size_t first = 0; first < lines_.size(); first += kLines) begin(first);
}

void LinesThroughPlaces::begin(std::size_t k) {
  constexpr std::array<double, 9> kStarts = {-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1};
  lines_[k].reserve(2 * kStarts.size());
  for (const double t : kStarts) {
    tries_.emplace_back(k, t);
    if (own_[k] > 0 && own_[k] < 1) tries_.emplace_back(k, own_[k] * t);
  }
}

std::vector<dvec2> LinesThroughPlaces::places() const {
  std::vector<dvec2> uv;
  uv.reserve(tries_.size());
  for (const auto& [k, t] : tries_) uv.push_back(lines_[k].uv(t));
  return uv;
}

void LinesThroughPlaces::add_samples(std::span<const dvec3> points) {
  for (std::size_t i = 0; i < tries_.size(); ++i) {
    lines_[tries_[i].first].add(tries_[i].second, points[i]);
  }
  tries_.clear();
}

void LinesThroughPlaces::go_on(std::size_t round) {
  const std::size_t begun = round < kBegun.size() ? kBegun[round] : kLines;
  const std::size_t next = round + 1 < kBegun.size() ? kBegun[round + 1] : kLines;
  for (std::size_t first = 0; first < lines_.size(); first += kLines) {
    const auto is_near = [&](const NearestOnLine& line) { return line.distance() <= least_; };
    if (std::ranges::any_of(std::span(lines_).subspan(first, kLines), is_near)) continue;
    if (begun < kStraight || has_cliffs_) {
      for (std::size_t k = first + begun; k < first + next; ++k) begin(k);
    }
    if (round > 0) halve(first, first + begun);
  }
}

void LinesThroughPlaces::halve(std::size_t first, std::size_t end) {
  for (std::size_t k = first; k < end; ++k) {
    if (const auto t = lines_[k].next(shortest_)) tries_.emplace_back(k, *t);
  }
}

void LinesThroughPlaces::improve(std::size_t place, PlacedError& nearest) const {
  for (const NearestOnLine& line : std::span(lines_).subspan(place * kLines, kLines)) {
    if (line.distance() < nearest.distance) nearest = {line.distance(), line.nearest()};
  }
}

}  // namespace saddle
