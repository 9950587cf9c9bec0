#include "mesh/tree/vertex_geometry.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "eval/batch.h"
#include "mesh/features/singular.h"
#include "mesh/features/values_on_poles.h"
#include "mesh/grid/weld.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"
#include "surface/parameter_box.h"

namespace saddle {

VertexGeometry::VertexGeometry(const Surface& surface, Grid& grid, DyadicVertices& vertices,
                               RevisionClock& revisions, Effort& effort, unsigned threads)
    : surface_(surface),
      may_have_values_on_poles_(may_have_values_on_poles(surface)),
      grid_(grid),
      vertices_(vertices),
      revisions_(revisions),
      effort_(effort),
      size_(grid.mesh.bounds.diagonal()),
      regular_(grid.vertex_count(), 1),
      defined_(grid.vertex_count(), 1),
      singular_cells_(grid) {
  repair_root_grid(threads);
}

/// Gives vertices of the root grid whose positions are rounding the limits there.
void VertexGeometry::replace_rounding_of_root_grid(unsigned threads) {
  const auto farthest = [](const std::vector<double>& lines) {
    return std::max(std::fabs(lines.front()), std::fabs(lines.back()));
  };
  const double most =
      moved_by_last_digit(grid_.longest_tangents, {farthest(grid_.u), farthest(grid_.v)});
  const bool may_be_anywhere = !(most <= kLimitsAgree * size_);
  std::vector<std::size_t> steep = grid_.singular;
  if (may_be_anywhere) {
    steep.resize(grid_.vertex_count());
    std::iota(steep.begin(), steep.end(), std::size_t{0});
  }
  std::vector<dvec2> uv;
  uv.reserve(steep.size());
  for (const std::size_t vertex : steep) uv.push_back(grid_.uv(vertex));
  const std::vector<SurfacePoint> points = saddle::evaluate(surface_, uv, threads);
  if (may_be_anywhere) size_ = diagonal_without_rounding(points, uv, size_);
  note_rounding(steep, points);
  replace_rounding(threads);
}

void VertexGeometry::repair_root_grid(unsigned threads) {
  for (const std::size_t vertex : grid_.singular) make_singular(static_cast<std::uint32_t>(vertex));
  replace_rounding_of_root_grid(threads);
  std::vector<std::uint32_t> all(may_have_values_on_poles_ ? grid_.vertex_count() : 0);
  std::iota(all.begin(), all.end(), 0);
  if (drop_values_on_poles(all, threads).empty() && grid_.left_out_count == 0) return;
  std::vector<std::uint32_t> undefined;
  for (std::uint32_t vertex = 0; vertex < grid_.vertex_count(); ++vertex) {
    defined_[vertex] = is_finite(grid_.mesh.position[vertex]) ? 1 : 0;
    const bool has_normal = is_defined(vertex) && is_finite(grid_.mesh.normal[vertex]);
    if (!has_normal) grid_.mesh.normal[vertex] = dvec3(0);
    if (!has_normal) make_singular(vertex);
    if (!is_defined(vertex)) undefined.push_back(vertex);
  }
  fill_removable(undefined, threads);
}

void VertexGeometry::reserve(std::size_t count) {
  vertices_.reserve(count);
  for_arrays([count](auto& array) { array.reserve(count); });
}

void VertexGeometry::add_middles(unsigned threads) {
  reserve((2 * grid_.u.size() - 1) * (2 * grid_.v.size() - 1));
  std::vector<std::uint32_t> middles;
  for (std::size_t kind = 1; kind < DyadicVertices::kSubGrids; ++kind) {
    const std::vector<std::uint32_t> some = append_grid(vertices_.add_sub_grid(kind), threads);
    middles.insert(middles.end(), some.begin(), some.end());
  }
  finish_new(middles, threads);
}

/// Makes room for the vertices that have no positions yet.
void VertexGeometry::resize() {
  for_arrays([count = vertices_.size()](auto& array) { array.resize(count); });
}

template <class Vertex, class Uv>
void VertexGeometry::store(const NormalColumns& columns, std::size_t count, Vertex vertex, Uv uv) {
  Mesh& mesh = grid_.mesh;
  const double visible = kLimitsAgree * size_;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [position, normal, regular] = column_point(columns, i, surface_.flip);
    const std::uint32_t to = vertex(i);
    mesh.position[to] = position;
    mesh.normal[to] = regular ? normal : dvec3(0);
    mesh.uv[to] = uv(i);
    mesh.point[to] = to;
    regular_[to] = 1;
    defined_[to] = is_finite(position) ? 1 : 0;
    if (!regular) make_singular(to);
    const dvec2 lengths = glm::sqrt(dvec2(columns[kSquareUColumn][i], columns[kSquareVColumn][i]));
    const bool may_be_rounding = moved_by_last_digit(lengths, uv(i)) > visible;
    if ((!regular || may_be_rounding) && is_finite(position) && is_finite(normal))
      steep_.push_back(to);
  }
  evaluations_ += count;
  effort_.add_samples(count);
}

void VertexGeometry::evaluate_at(std::span<const std::uint32_t> vertices, std::span<const double> u,
                                 std::span<const double> v, unsigned threads) {
  store(
      evaluate_normals(surface_, u, v, threads), vertices.size(),
      [&](std::size_t i) { return vertices[i]; }, [&](std::size_t i) { return dvec2(u[i], v[i]); });
}

/// Evaluates the last vertices, which are a grid. Returns them.
std::vector<std::uint32_t> VertexGeometry::append_grid(const DyadicVertices::Lines& lines,
                                                       unsigned threads) {
  const std::vector<double>& u = lines.u;
  const std::vector<double>& v = lines.v;
  std::vector<std::uint32_t> vertices(u.size() * v.size());
  std::iota(vertices.begin(), vertices.end(),
            static_cast<std::uint32_t>(vertices_.size() - vertices.size()));
  resize();
  store(
      evaluate_normals_on_grid(surface_, u, v, threads), vertices.size(),
      [&](std::size_t i) { return vertices[i]; },
      [&](std::size_t i) { return dvec2(u[i % u.size()], v[i / u.size()]); });
  return vertices;
}

std::vector<std::uint32_t> VertexGeometry::evaluate(unsigned threads) {
  std::vector<std::uint32_t> vertices = vertices_.take_new();
  resize();
  std::vector<double> u;
  std::vector<double> v;
  for (std::span<const std::uint32_t> rest = vertices; !rest.empty();) {
    const auto some = rest.first(std::min(rest.size(), kKeptAtATime));
    rest = rest.subspan(some.size());
    u.clear();
    v.clear();
    for (const std::uint32_t vertex : some) {
      const dvec2 uv = vertices_.parameters(vertices_.place(vertex));
      u.push_back(uv.x);
      v.push_back(uv.y);
    }
    evaluate_at(some, u, v, threads);
  }
  finish_new(vertices, threads);
  return vertices;
}

void VertexGeometry::finish_new(std::span<const std::uint32_t> vertices, unsigned threads) {
  take_known_normals();
  std::vector<std::uint32_t> undefined;
  for (const std::uint32_t vertex : vertices) {
    join_pole(vertex);
    if (!is_defined(vertex)) undefined.push_back(vertex);
  }
  const std::vector<std::uint32_t> dropped = drop_values_on_poles(vertices, threads);
  undefined.insert(undefined.end(), dropped.begin(), dropped.end());
  fill_removable(undefined, threads);
  replace_rounding(threads);
}

/// Makes vertices with values on poles undefined. Returns them.
std::vector<std::uint32_t> VertexGeometry::drop_values_on_poles(
    std::span<const std::uint32_t> vertices, unsigned threads) {
  if (!may_have_values_on_poles_ || vertices.empty()) return {};
  Mesh& mesh = grid_.mesh;
  std::vector<dvec2> places;
  std::vector<dvec3> positions;
  for (const std::uint32_t vertex : vertices) {
    places.push_back(mesh.uv[vertex]);
    positions.push_back(mesh.position[vertex]);
  }
  std::size_t looks = 0;
  const double delta = kLimitsAgree * mesh.bounds.diagonal();
  const auto on_poles = are_on_poles(surface_, places, positions, delta, threads, looks);
  evaluations_ += looks;
  effort_.add_places(looks);
  std::vector<std::uint32_t> dropped;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!on_poles[k]) continue;
    const std::uint32_t vertex = vertices[k];
    dropped.push_back(vertex);
    mesh.position[vertex] = dvec3(std::numeric_limits<double>::quiet_NaN());
    mesh.normal[vertex] = dvec3(0);
    defined_[vertex] = 0;
    make_singular(vertex);
  }
  return dropped;
}

void VertexGeometry::fill_removable(std::span<const std::uint32_t> undefined, unsigned threads) {
  const std::vector<Beside> beside = look_beside(undefined, grid_.mesh.bounds.diagonal(), threads);
  const double diagonal = grid_.mesh.bounds.diagonal();
  std::vector<std::uint32_t> singularities;
  std::vector<std::uint32_t> within;  // the surface, but without a limit
  for (std::size_t k = 0; k < undefined.size(); ++k) {
    const dvec2& uv = grid_.mesh.uv[undefined[k]];
    const bool has_limit = beside[k].limit && !(beside[k].is_alone &&
                                                has_limits_aside(surface_, uv, diagonal, threads));
    if (has_limit) {
      fill(undefined[k], *beside[k].limit);
    } else if (beside[k].is_within) {
      within.push_back(undefined[k]);
    } else if (beside[k].is_defined) {
      singularities.push_back(undefined[k]);
    }
  }
  fill_at_jumps(within, threads, singularities);
  classify(singularities, threads);
}

/// Moves vertices without a value on lines of jumps to one of the sheets there. Others go to
/// `rest`.
void VertexGeometry::fill_at_jumps(std::span<const std::uint32_t> vertices, unsigned threads,
                                   std::vector<std::uint32_t>& rest) {
  std::vector<dvec2> places;
  for (const std::uint32_t vertex : vertices) places.push_back(grid_.mesh.uv[vertex]);
  std::size_t looks = 0;
  const auto points =
      points_beside_jumps(surface_, places, grid_.mesh.bounds.diagonal(), threads, looks);
  evaluations_ += looks;
  effort_.add_places(looks);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!points[k]) {
      rest.push_back(vertices[k]);
      continue;
    }
    const auto& [uv, point] = *points[k];
    grid_.mesh.uv[vertices[k]] = uv;
    fill(vertices[k], point.position);
    if (const auto normal = known_normal(point, surface_.flip)) set_normal(vertices[k], *normal);
  }
}

/// Vertices whose positions are rounding keep these where nothing better is known.
void VertexGeometry::replace_rounding(unsigned threads) {
  std::vector<std::uint32_t> vertices;
  std::swap(vertices, rounded_);
  const std::vector<Beside> beside = look_beside(vertices, size_, threads);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (beside[k].limit) fill(vertices[k], *beside[k].limit);
  }
}

std::vector<Beside> VertexGeometry::look_beside(std::span<const std::uint32_t> vertices,
                                                double diagonal, unsigned threads) {
  if (vertices.empty()) return {};
  std::vector<dvec2> places;
  for (const std::uint32_t vertex : vertices) places.push_back(grid_.mesh.uv[vertex]);
  std::size_t looks = 0;
  auto beside = saddle::look_beside(surface_, places, diagonal, threads, looks);
  evaluations_ += looks;
  effort_.add_places(looks);
  return beside;
}

/// Gives a vertex the limit of the positions around it.
void VertexGeometry::fill(std::uint32_t vertex, const dvec3& limit) {
  grid_.mesh.position[vertex] = limit;
  defined_[vertex] = 1;
  make_singular(vertex);
  singular_cells_.add(vertices_.place_between(vertex));  // it may have been singular as undefined
}

void VertexGeometry::classify(std::span<const std::uint32_t> vertices, unsigned threads) {
  std::vector<dvec2> places;
  for (const std::uint32_t vertex : vertices) places.push_back(grid_.mesh.uv[vertex]);
  const std::vector<PointSingularity> singularities =
      classify_points(surface_, places, grid_.mesh.bounds.diagonal(), threads);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (singularities[k].kind != PointSingularity::Kind::Region)
      singularities_[vertices[k]] = singularities[k];
    has_poles_ = has_poles_ || singularities[k].kind == PointSingularity::Kind::Pole;
  }
}

void VertexGeometry::take_known_normals() {
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
  // Tangents may be made of rounding themselves: are_singular() then finds others around them.
  const std::vector<bool> are_zeros = are_singular(surface_, places, 1);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!are_zeros[k]) set_normal(vertices[k], normals[k]);
  }
  steep_.clear();
}

/// Files the vertices whose positions are rounding: is_rounding().
void VertexGeometry::note_rounding(std::span<const std::size_t> vertices,
                                   std::span<const SurfacePoint> points) {
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!is_rounding(points[k], grid_.mesh.uv[vertices[k]], size_)) continue;
    rounded_.push_back(static_cast<std::uint32_t>(vertices[k]));
  }
}

std::uint32_t VertexGeometry::add_between(std::span<const Between> places, unsigned threads) {
  const dvec2 range = box_of(surface_.domain).size();
  std::vector<InnerPlace> inner;
  for (const Between& between : places) {
    const dvec2 from = grid_.mesh.uv[between.a];
    const dvec2 whole = grid_.mesh.uv[between.b] - from;
    const dvec2 part = between.uv - from;
    const bool is_along_u = std::fabs(whole.x / range.x) > std::fabs(whole.y / range.y);
    double share = is_along_u ? part.x / whole.x : part.y / whole.y;
    if (share < kSame || share > 1 - kSame) share = std::round(share);
    inner.push_back(
        {glm::mix(vertices_.place_between(between.a), vertices_.place_between(between.b), share),
         between.uv});
  }
  const std::uint32_t first = add_inside(inner, threads);
  for (std::size_t k = 0; k < places.size(); ++k) fill_from_ends(places[k], first + k);
  return first;
}

/// Gives an undefined vertex the position of an end of its line that is at the same parameters: a
/// limit may have defined that.
void VertexGeometry::fill_from_ends(const Between& between, std::size_t vertex) {
  if (is_finite(grid_.mesh.position[vertex])) return;
  for (const std::uint32_t end : {between.a, between.b}) {
    if (is_defined(end) && grid_.mesh.uv[end] == between.uv)
      return fill(static_cast<std::uint32_t>(vertex), grid_.mesh.position[end]);
  }
}

std::uint32_t VertexGeometry::add_inside(std::span<const InnerPlace> places, unsigned threads) {
  assert(!vertices_.has_new());
  std::vector<std::uint32_t> vertices;
  std::vector<double> u;
  std::vector<double> v;
  for (const InnerPlace& inner : places) {
    vertices.push_back(vertices_.add_between(inner.place));
    u.push_back(inner.uv.x);
    v.push_back(inner.uv.y);
  }
  resize();
  evaluate_at(vertices, u, v, threads);
  return vertices.empty() ? static_cast<std::uint32_t>(vertices_.size()) : vertices.front();
}

void VertexGeometry::join(std::uint32_t from, std::uint32_t to) {
  grid_.mesh.position[to] = grid_.mesh.position[from];
  grid_.mesh.point[to] = grid_.mesh.point[from];
}

/// Joins a vertex between two vertices of the root grid that are one point, on the grid's line
/// through them, to that point. Its tangent along the line is rounding.
void VertexGeometry::join_pole(std::uint32_t vertex) {
  const DyadicPoint p = vertices_.place(vertex);
  const bool on_u = p.u % kCellUnit == 0;
  if (!on_u && p.v % kCellUnit != 0) return;
  const auto before = [](std::uint32_t c) { return c / kCellUnit * kCellUnit; };
  const DyadicPoint a = {before(p.u), before(p.v)};
  const DyadicPoint b =
      on_u ? DyadicPoint{a.u, a.v + kCellUnit} : DyadicPoint{a.u + kCellUnit, a.v};
  const std::uint32_t root = vertices_.vertex_on_grid(a);
  const bool ends_meet = grid_.mesh.point[root] == grid_.mesh.point[vertices_.vertex_on_grid(b)];
  if (!ends_meet || !is_one_point(surface_, grid_, root, vertex)) return;
  grid_.mesh.position[vertex] = grid_.mesh.position[root];
  grid_.mesh.point[vertex] = grid_.mesh.point[root];
  make_singular(root);
  make_singular(vertex);
}

}  // namespace saddle
