#include "mesh/tree/cell_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <span>

#include <glm/common.hpp>

#include "eval/batch.h"
#include "mesh/features/removable.h"
#include "mesh/features/singular.h"
#include "mesh/grid/weld.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {}  // namespace

CellTree::CellTree(const Surface& surface, Grid& grid, unsigned threads)
    : surface_(surface),
      grid_(grid),
      numbers_(grid),
      used_(grid.vertex_count(), 1),
      regular_(grid.vertex_count(), 1),
      defined_(grid.vertex_count(), 1),
      beside_cut_(grid.vertex_count(), 0),
      beside_middle_(grid.vertex_count(), 0),
      crossed_cells_(grid),
      singular_cells_(grid),
      changed_cells_(grid),
      used_count_(grid.vertex_count()),
      evaluated_(grid.vertex_count()),
      effort_(surface) {
  sub_grids_[0] = {0, static_cast<std::uint32_t>(grid.u.size())};
  for (const std::size_t vertex : grid.singular) make_singular(static_cast<std::uint32_t>(vertex));
  std::vector<dvec2> uv;
  for (const std::size_t vertex : grid.singular) uv.push_back(grid.uv(vertex));
  note_rounding(grid.singular, saddle::evaluate(surface, uv, threads));
  replace_rounding(threads);
  if (grid.left_out_count == 0) return;
  std::vector<std::uint32_t> undefined;
  for (std::uint32_t vertex = 0; vertex < grid.vertex_count(); ++vertex) {
    const bool has_normal = is_finite(grid.mesh.normal[vertex]);
    if (!has_normal) grid.mesh.normal[vertex] = dvec3(0);
    if (!has_normal) make_singular(vertex);
    defined_[vertex] = is_finite(grid.mesh.position[vertex]) ? 1 : 0;
    if (!is_defined(vertex)) undefined.push_back(vertex);
  }
  fill_removable(undefined, threads);
}

void CellTree::reserve(std::size_t count) {
  Mesh& mesh = grid_.mesh;
  mesh.position.reserve(count);
  mesh.normal.reserve(count);
  mesh.uv.reserve(count);
  mesh.point.reserve(count);
  places_.reserve(count - grid_.vertex_count());
  for (auto* const marks : {&used_, &regular_, &defined_, &beside_cut_, &beside_middle_}) {
    marks->reserve(count);
  }
}

void CellTree::add_middles(unsigned threads) {
  struct Line {
    std::vector<double> parameters;
    std::vector<std::uint32_t> places;
  };
  const auto take = [](const std::vector<double>& lines, bool between) {
    Line line;
    for (std::uint32_t k = 0; k + (between ? 1 : 0) < lines.size(); ++k) {
      const double next = between ? lines[k + 1] : lines[k];
      line.parameters.push_back(lines[k] + (next - lines[k]) * 0.5);
      line.places.push_back(k * kCellUnit + (between ? kCellUnit / 2 : 0));
    }
    return line;
  };
  reserve((2 * grid_.u.size() - 1) * (2 * grid_.v.size() - 1));
  for (std::size_t kind = 1; kind < sub_grids_.size(); ++kind) {
    const Line u = take(grid_.u, kind % 2 != 0);
    const Line v = take(grid_.v, kind / 2 != 0);
    sub_grids_[kind] = {static_cast<std::uint32_t>(used_.size()),
                        static_cast<std::uint32_t>(u.places.size())};
    for (const std::uint32_t at_v : v.places) {
      for (const std::uint32_t at_u : u.places) number({at_u, at_v});
    }
    append_grid(u.parameters, v.parameters, threads);
  }
  grid_mask_ = kCellUnit / 2 - 1;
  finish_new(threads);
}

dvec2 CellTree::parameters(DyadicPoint place) const {
  const auto at = [](const std::vector<double>& lines, std::uint32_t coordinate) {
    const std::uint32_t line = coordinate / kCellUnit;
    const std::uint32_t rest = coordinate % kCellUnit;
    if (rest == 0) return lines[line];
    return lines[line] + (lines[line + 1] - lines[line]) * (rest * (1.0 / kCellUnit));
  };
  return {at(grid_.u, place.u), at(grid_.v, place.v)};
}

std::uint32_t CellTree::vertex_off_grid(DyadicPoint place) {
  const auto next = static_cast<std::uint32_t>(used_.size());
  const std::uint32_t vertex = numbers_.find_or_insert(place, next);
  return vertex == next ? number(place) : vertex;
}

std::uint32_t CellTree::number(DyadicPoint place) {
  places_.push_back(place);
  used_.push_back(0);
  regular_.push_back(1);
  defined_.push_back(1);
  beside_cut_.push_back(0);
  beside_middle_.push_back(0);
  return static_cast<std::uint32_t>(used_.size() - 1);
}

void CellTree::use(std::uint32_t vertex) {
  if (is_used(vertex)) return;
  mark_ends_of_side(place(vertex));
  put_into_use(vertex);
}

void CellTree::use_middle(const Leaf& leaf, std::size_t k) {
  const auto& [corner, side, centre] = leaf.samples;
  beside_middle_[corner[k]] = beside_middle_[corner[(k + 1) % 4]] = 1;
  if (is_used(side[k])) return;
  const auto cut = feature(corner[k], corner[(k + 1) % 4]);
  if (cut) between_count_ -= cut->count_new_vertices();
  put_into_use(side[k]);
}

/// Marks the ends of the sides of which a place may be the middle, along u and along v: as far away
/// as its coordinate's last bit that is 1.
void CellTree::mark_ends_of_side(DyadicPoint middle) {
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

void CellTree::put_into_use(std::uint32_t vertex) {
  used_[vertex] = 1;
  ++used_count_;
  newly_used_.push_back(vertex);
  const DyadicPoint p = place(vertex);
  changed_cells_.add(dvec2(p.u, p.v), now_);
}

std::vector<std::uint32_t> CellTree::take_newly_used() {
  std::vector<std::uint32_t> vertices;
  vertices.swap(newly_used_);
  std::ranges::sort(vertices);
  return vertices;
}

DyadicPoint CellTree::place(std::uint32_t vertex) const {
  const std::size_t roots = grid_.vertex_count();
  if (vertex >= roots) return places_[vertex - roots];
  return {static_cast<std::uint32_t>(vertex % grid_.u.size()) * kCellUnit,
          static_cast<std::uint32_t>(vertex / grid_.u.size()) * kCellUnit};
}

template <class Function>
void CellTree::append(const NormalColumns& columns, std::size_t count, Function uv) {
  const double front = surface_.flip ? -1 : 1;
  Mesh& mesh = grid_.mesh;
  const std::size_t first = mesh.position.size();
  mesh.position.resize(first + count);
  mesh.normal.resize(first + count);
  mesh.uv.resize(first + count);
  mesh.point.resize(first + count);
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 position(columns[0][i], columns[1][i], columns[2][i]);
    const dvec3 normal = front * dvec3(columns[kNormalColumn][i], columns[kNormalColumn + 1][i],
                                       columns[kNormalColumn + 2][i]);
    // |r_u x r_v| beside |r_u| |r_v|, all of which may be infinite or 0.
    const double scale =
        std::sqrt(columns[kSquareUColumn][i]) * std::sqrt(columns[kSquareVColumn][i]);
    const bool regular = columns[kAreaColumn][i] > kDegenerateCross * scale && is_finite(normal);
    const std::size_t vertex = first + i;
    mesh.position[vertex] = position;
    mesh.normal[vertex] = regular ? normal : dvec3(0);
    mesh.uv[vertex] = uv(i);
    mesh.point[vertex] = static_cast<std::uint32_t>(vertex);
    if (!regular) make_singular(static_cast<std::uint32_t>(vertex));
    defined_[vertex] = is_finite(position) ? 1 : 0;
    if (!regular && is_finite(position) && is_finite(normal)) steep_.push_back(vertex);
  }
  evaluations_ += count;
  effort_.add_samples(count);
}

void CellTree::take_known_normals() {
  std::vector<dvec2> uv;
  for (const std::size_t vertex : steep_) uv.push_back(grid_.mesh.uv[vertex]);
  const std::vector<SurfacePoint> points = saddle::evaluate(surface_, uv, 1);
  note_rounding(steep_, points);
  std::vector<std::uint32_t> vertices;
  std::vector<dvec2> places;
  std::vector<dvec3> normals;
  for (std::size_t k = 0; k < steep_.size(); ++k) {
    const auto vertex = static_cast<std::uint32_t>(steep_[k]);
    if (is_regular(vertex)) continue;
    const auto normal = known_normal(points[k], surface_.flip);
    if (!normal) continue;
    vertices.push_back(vertex);
    places.push_back(uv[k]);
    normals.push_back(*normal);
  }
  // What tangents are made of may itself be rounding: there is more around that.
  const std::vector<bool> are_zeros = are_singular(surface_, places, 1);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!are_zeros[k]) set_normal(vertices[k], normals[k]);
  }
  steep_.clear();
}

void CellTree::note_rounding(std::span<const std::size_t> vertices,
                             std::span<const SurfacePoint> points) {
  const Mesh& mesh = grid_.mesh;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!is_rounding(points[k], mesh.uv[vertices[k]], mesh.bounds.diagonal())) continue;
    rounded_.push_back(static_cast<std::uint32_t>(vertices[k]));
  }
}

void CellTree::append(const std::vector<double>& u, const std::vector<double>& v,
                      unsigned threads) {
  append(evaluate_normals(surface_, u, v, threads), u.size(),
         [&](std::size_t i) { return dvec2(u[i], v[i]); });
}

void CellTree::append_grid(const std::vector<double>& u, const std::vector<double>& v,
                           unsigned threads) {
  append(evaluate_normals_on_grid(surface_, u, v, threads), u.size() * v.size(),
         [&](std::size_t i) { return dvec2(u[i % u.size()], v[i / u.size()]); });
}

void CellTree::evaluate(unsigned threads) {
  if (evaluated_ == used_.size()) return;
  std::vector<double> u;
  std::vector<double> v;
  for (std::size_t vertex = evaluated_; vertex < used_.size(); ++vertex) {
    const dvec2 uv = parameters(place(static_cast<std::uint32_t>(vertex)));
    u.push_back(uv.x);
    v.push_back(uv.y);
  }
  append(u, v, threads);
  finish_new(threads);
}

void CellTree::finish_new(unsigned threads) {
  take_known_normals();
  std::vector<std::uint32_t> undefined;
  for (auto vertex = static_cast<std::uint32_t>(evaluated_); vertex < used_.size(); ++vertex) {
    join_pole(vertex);
    if (!is_defined(vertex)) undefined.push_back(vertex);
  }
  evaluated_ = used_.size();
  fill_removable(undefined, threads);
  replace_rounding(threads);
}

void CellTree::fill_removable(std::span<const std::uint32_t> undefined, unsigned threads) {
  const std::vector<Beside> beside = look_beside(undefined, threads);
  std::vector<std::uint32_t> singularities;
  for (std::size_t k = 0; k < undefined.size(); ++k) {
    if (beside[k].limit) {
      fill(undefined[k], *beside[k].limit);
    } else if (beside[k].is_defined) {
      singularities.push_back(undefined[k]);
    }
  }
  find_point_singularities(singularities, threads);
}

/// Vertices whose positions are rounding keep these where nothing better is known.
void CellTree::replace_rounding(unsigned threads) {
  std::vector<std::uint32_t> vertices;
  std::swap(vertices, rounded_);
  const std::vector<Beside> beside = look_beside(vertices, threads);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (beside[k].limit) fill(vertices[k], *beside[k].limit);
  }
}

std::vector<Beside> CellTree::look_beside(std::span<const std::uint32_t> vertices,
                                          unsigned threads) {
  if (vertices.empty()) return {};
  std::vector<dvec2> places;
  for (const std::uint32_t vertex : vertices) places.push_back(grid_.mesh.uv[vertex]);
  std::size_t looks = 0;
  auto beside = saddle::look_beside(surface_, places, grid_.mesh.bounds.diagonal(), threads, looks);
  evaluations_ += looks;
  effort_.add_places(looks);
  return beside;
}

void CellTree::fill(std::uint32_t vertex, const dvec3& limit) {
  grid_.mesh.position[vertex] = limit;
  defined_[vertex] = 1;
  make_singular(vertex);
}

void CellTree::find_point_singularities(std::span<const std::uint32_t> vertices, unsigned threads) {
  std::vector<dvec2> places;
  for (const std::uint32_t vertex : vertices) places.push_back(grid_.mesh.uv[vertex]);
  const std::vector<PointSingularity> singularities =
      classify_points(surface_, places, grid_.mesh.bounds.diagonal(), threads);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (singularities[k].kind != PointSingularity::Kind::Part)
      singularities_[vertices[k]] = singularities[k];
    has_poles_ = has_poles_ || singularities[k].kind == PointSingularity::Kind::Pole;
  }
}

std::optional<EdgeFeature> CellTree::find_feature(std::uint32_t a, std::uint32_t b) const {
  const auto found = sides_.find(pair_of(a, b));
  return found ? searched_[*found].feature : std::nullopt;
}

void CellTree::set_feature(std::uint32_t a, std::uint32_t b, std::optional<EdgeFeature> feature) {
  if (feature) {
    has_features_ = true;
    beside_cut_[a] = beside_cut_[b] = 1;
    effort_.add_discontinuities(1);
    has_poles_ = has_poles_ || feature->kind == FeatureKind::Pole;
    const dvec2 middle = 0.5 * (place_between(a) + place_between(b));
    crossed_cells_.add(middle);
    changed_cells_.add(middle, now_);
  }
  const auto [at, is_new] =
      sides_.insert(pair_of(a, b), static_cast<std::uint32_t>(searched_.size()));
  if (is_new) searched_.push_back({{std::min(a, b), std::max(a, b)}, {}});
  std::optional<EdgeFeature>& filed = searched_[at].feature;
  if (filed) between_count_ -= filed->count_new_vertices();
  if (feature) between_count_ += feature->count_new_vertices();
  filed = feature;
}

std::vector<std::array<dvec2, 2>> CellTree::poles() const {
  std::vector<std::array<dvec2, 2>> poles = pole_ends_;
  poles.insert(poles.end(), poles_beyond_faces_.begin(), poles_beyond_faces_.end());
  for (const auto& [side, feature] : searched_) {
    if (!feature || feature->kind != FeatureKind::Pole) continue;
    poles.push_back({grid_.mesh.uv[feature->beside_first], grid_.mesh.uv[feature->beside_second]});
  }
  return poles;
}

std::vector<std::array<std::uint32_t, 2>> CellTree::sides_with_features() const {
  std::vector<std::array<std::uint32_t, 2>> result;
  for (const auto& [side, feature] : searched_) {
    if (feature) result.push_back(side);
  }
  return result;
}

std::uint32_t CellTree::add_between(std::span<const Between> places, unsigned threads) {
  assert(evaluated_ == used_.size());
  const auto first = static_cast<std::uint32_t>(used_.size());
  std::vector<double> u;
  std::vector<double> v;
  for (const Between& between : places) {
    const dvec2 from = grid_.mesh.uv[between.a];
    const dvec2 whole = grid_.mesh.uv[between.b] - from;
    const dvec2 part = between.uv - from;
    double share = whole.x != 0 ? part.x / whole.x : part.y / whole.y;
    if (share < kSameOnLine || share > 1 - kSameOnLine) share = std::round(share);
    number({static_cast<std::uint32_t>(places_between_.size()), kBetween});
    places_between_.push_back(glm::mix(place_between(between.a), place_between(between.b), share));
    u.push_back(between.uv.x);
    v.push_back(between.uv.y);
  }
  append(u, v, threads);
  evaluated_ = used_.size();
  return first;
}

void CellTree::join(std::uint32_t from, std::uint32_t to) {
  grid_.mesh.position[to] = grid_.mesh.position[from];
  grid_.mesh.point[to] = grid_.mesh.point[from];
}

void CellTree::share_place(std::uint32_t from, std::uint32_t to) {
  places_between_.at(place(to).u) = place_between(from);
}

dvec2 CellTree::place_between(std::uint32_t vertex) const {
  const DyadicPoint p = place(vertex);
  return p.v == kBetween ? places_between_[p.u] : dvec2(p.u, p.v);
}

void CellTree::join_pole(std::uint32_t vertex) {
  const DyadicPoint p = place(vertex);
  const bool on_u = p.u % kCellUnit == 0;
  if (!on_u && p.v % kCellUnit != 0) return;
  const auto before = [](std::uint32_t c) { return c / kCellUnit * kCellUnit; };
  const DyadicPoint a = {before(p.u), before(p.v)};
  const DyadicPoint b =
      on_u ? DyadicPoint{a.u, a.v + kCellUnit} : DyadicPoint{a.u + kCellUnit, a.v};
  const std::uint32_t root = vertex_on_grid(a);
  const bool ends_meet = grid_.mesh.point[root] == grid_.mesh.point[vertex_on_grid(b)];
  if (!ends_meet || !is_one_point(grid_, root, vertex)) return;
  grid_.mesh.position[vertex] = grid_.mesh.position[root];
  grid_.mesh.point[vertex] = grid_.mesh.point[root];
  make_singular(root);
  make_singular(vertex);
}

}  // namespace saddle
