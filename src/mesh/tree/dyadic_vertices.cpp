#include "mesh/tree/dyadic_vertices.h"
#include "mesh/grid/grid.h"

#include <algorithm>
#include <utility>

namespace saddle {

DyadicVertices::DyadicVertices(const Grid& grid, RevisionClock& revisions)
    : grid_(grid),
      revisions_(revisions),
      numbers_(grid),
      used_(grid.vertex_count(), 1),
      beside_middle_(grid.vertex_count(), 0),
      beside_feature_(grid.vertex_count(), 0),
      first_forgettable_(grid.vertex_count()),
      used_count_(grid.vertex_count()) {
  sub_grids_[0] = {0, static_cast<std::uint32_t>(grid.u.size())};
}

void DyadicVertices::reserve(std::size_t count) {
  places_.reserve(count - grid_.vertex_count());
  for (auto* const marks : {&used_, &beside_middle_, &beside_feature_}) marks->reserve(count);
}

dvec2 DyadicVertices::parameters(DyadicPoint place) const {
  const auto at = [](const std::vector<double>& lines, std::uint32_t coordinate) {
    const std::uint32_t line = coordinate / kCellUnit;
    const std::uint32_t rest = coordinate % kCellUnit;
    if (rest == 0) return lines[line];
    return lines[line] + (lines[line + 1] - lines[line]) * (rest * (1.0 / kCellUnit));
  };
  return {at(grid_.u, place.u), at(grid_.v, place.v)};
}

std::uint32_t DyadicVertices::vertex_off_grid(DyadicPoint place) {
  const std::uint32_t next =
      forgotten_.empty() ? static_cast<std::uint32_t>(used_.size()) : forgotten_.back();
  const std::uint32_t vertex = numbers_.find_or_insert(place, next);
  if (vertex != next) return vertex;
  new_.push_back(vertex);
  if (forgotten_.empty()) return add(place);
  forgotten_.pop_back();
  places_[vertex - grid_.vertex_count()] = place;
  return vertex;
}

void DyadicVertices::forget(std::uint32_t vertex) {
  DyadicPoint& place = places_[vertex - grid_.vertex_count()];
  numbers_.erase(place);
  place.v = kNoIndex;  // it is not forgotten again
  forgotten_.push_back(vertex);
}

std::uint32_t DyadicVertices::add(DyadicPoint place) {
  places_.push_back(place);
  used_.push_back(0);
  beside_middle_.push_back(0);
  beside_feature_.push_back(0);
  return static_cast<std::uint32_t>(used_.size() - 1);
}

/// hanging_middle() of a leaf whose samples are forgotten.
std::uint32_t DyadicVertices::forgotten_middle(const Leaf& leaf, std::size_t k) const {
  const auto& corner = leaf.samples.corner;
  if (beside_middle_[corner[k]] == 0 || beside_middle_[corner[(k + 1) % 4]] == 0) return kNoIndex;
  const auto corners = leaf.corners();
  return middle_between(corners[k], corners[(k + 1) % 4]).value_or(kNoIndex);
}

DyadicVertices::Lines DyadicVertices::add_sub_grid(std::size_t kind) {
  struct Line {
    std::vector<double> parameters;
    std::vector<std::uint32_t> places;
  };
  const auto take = [](const std::vector<double>& lines, bool between) {
    Line line;
    for (std::uint32_t k = 0; k + (between ? 1 : 0) < lines.size(); ++k) {
      const double next = between ? lines[k + 1] : lines[k];
      line.parameters.push_back(lines[k] + (next - lines[k]) * 0.5);
      line.places.push_back(k * kCellUnit + (between ? kHalfUnit : 0));
    }
    return line;
  };
  Line u = take(grid_.u, kind % 2 != 0);
  Line v = take(grid_.v, kind / 2 != 0);
  sub_grids_[kind] = {static_cast<std::uint32_t>(used_.size()),
                      static_cast<std::uint32_t>(u.places.size())};
  for (const std::uint32_t at_v : v.places) {
    for (const std::uint32_t at_u : u.places) add({at_u, at_v});
  }
  first_forgettable_ = used_.size();
  if (kind + 1 == kSubGrids) grid_mask_ = kHalfUnit - 1;
  return {std::move(u.parameters), std::move(v.parameters)};
}

std::uint32_t DyadicVertices::add_between(const dvec2& place) {
  places_between_.push_back(place);
  return add({static_cast<std::uint32_t>(places_between_.size() - 1), kNoIndex});
}

void DyadicVertices::share_place(std::uint32_t from, std::uint32_t to) {
  places_between_.at(place(to).u) = place_between(from);
}

DyadicPoint DyadicVertices::place(std::uint32_t vertex) const {
  const std::size_t roots = grid_.vertex_count();
  if (vertex >= roots) return places_[vertex - roots];
  return {static_cast<std::uint32_t>(vertex % grid_.u.size()) * kCellUnit,
          static_cast<std::uint32_t>(vertex / grid_.u.size()) * kCellUnit};
}

dvec2 DyadicVertices::place_between(std::uint32_t vertex) const {
  const DyadicPoint p = place(vertex);
  return p.v == kNoIndex ? places_between_[p.u] : dvec2(p.u, p.v);
}

void DyadicVertices::use(std::uint32_t vertex) {
  if (is_used(vertex)) return;
  mark_ends_of_side(place(vertex));
  put_into_use(vertex);
}

bool DyadicVertices::use_middle(std::uint32_t from, std::uint32_t middle, std::uint32_t to) {
  beside_middle_[from] = beside_middle_[to] = 1;
  if (is_used(middle)) return false;
  put_into_use(middle);
  return true;
}

/// Marks the ends of the sides along u and along v of which a place may be the middle. Their
/// distance is the lowest bit that is set in its coordinate.
void DyadicVertices::mark_ends_of_side(DyadicPoint middle) {
  const auto mark = [this](DyadicPoint end) {
    const auto vertex = known_vertex(end);
    if (vertex) beside_middle_[*vertex] = 1;
  };
  const std::uint32_t step_u = middle.u & -middle.u;
  const std::uint32_t step_v = middle.v & -middle.v;
  if (step_u < kCellUnit && step_u > 0) {
    mark({middle.u - step_u, middle.v});
    mark({middle.u + step_u, middle.v});
  }
  if (step_v < kCellUnit && step_v > 0) {
    mark({middle.u, middle.v - step_v});
    mark({middle.u, middle.v + step_v});
  }
}

void DyadicVertices::put_into_use(std::uint32_t vertex) {
  used_[vertex] = 1;
  ++used_count_;
  newly_used_.push_back(vertex);
  const DyadicPoint p = place(vertex);
  revisions_.mark(dvec2(p.u, p.v));
}

std::vector<std::uint32_t> DyadicVertices::take_newly_used() {
  std::vector<std::uint32_t> vertices;
  vertices.swap(newly_used_);
  std::ranges::sort(vertices);
  return vertices;
}

}  // namespace saddle
