#include "mesh/lattice.h"

#include <algorithm>
#include <cmath>

#include "eval/batch.h"
#include "mesh/weld.h"
#include "surface/normal.h"

namespace saddle {

namespace {

std::uint64_t key_of(Place place) {
  return (std::uint64_t{place.u} << 32U) | place.v;
}

}  // namespace

std::size_t PlaceMap::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  // Places are multiples of large powers of 2: products carry their few bits up, to the end of the
  // word, and the shift brings them down again.
  std::uint64_t mixed = (key ^ key >> 29U) * 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio
  mixed = (mixed ^ mixed >> 32U) * 0x9e3779b97f4a7c15ULL;
  std::size_t slot = (mixed >> 32U) & mask;
  while (slots_[slot].key != kEmpty && slots_[slot].key != key) slot = (slot + 1) & mask;
  return slot;
}

const std::uint32_t* PlaceMap::find(Place place) const {
  const Slot& slot = slots_[slot_of(key_of(place))];
  return slot.key == kEmpty ? nullptr : &slot.number;
}

void PlaceMap::insert(Place place, std::uint32_t number) {
  if (2 * ++count_ > slots_.size()) {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.key != kEmpty) slots_[slot_of(slot.key)] = slot;
    }
  }
  slots_[slot_of(key_of(place))] = {key_of(place), number};
}

Lattice::Lattice(const Surface& surface, Grid& grid)
    : surface_(surface),
      grid_(grid),
      used_(grid.vertex_count(), 1),
      regular_(grid.vertex_count(), 1),
      used_count_(grid.vertex_count()),
      evaluated_(grid.vertex_count()) {
  for (const std::size_t vertex : grid.singular) regular_[vertex] = 0;
}

std::uint32_t Lattice::root_vertex(Place place) const {
  return static_cast<std::uint32_t>(grid_.vertex(place.u / kCellUnit, place.v / kCellUnit));
}

dvec2 Lattice::parameters(Place place) const {
  const auto at = [](const std::vector<double>& lines, std::uint32_t coordinate) {
    const std::uint32_t line = coordinate / kCellUnit;
    const std::uint32_t rest = coordinate % kCellUnit;
    if (rest == 0) return lines[line];
    return lines[line] + (lines[line + 1] - lines[line]) * (rest * (1.0 / kCellUnit));
  };
  return {at(grid_.u, place.u), at(grid_.v, place.v)};
}

std::uint32_t Lattice::vertex(Place place) {
  if (is_root(place)) return root_vertex(place);
  if (const std::uint32_t* number = numbers_.find(place)) return *number;
  const auto number = static_cast<std::uint32_t>(used_.size());
  numbers_.insert(place, number);
  places_.push_back(place);
  used_.push_back(0);
  regular_.push_back(1);
  return number;
}

std::optional<std::uint32_t> Lattice::used_vertex(Place place) const {
  if (is_root(place)) return root_vertex(place);
  const std::uint32_t* const number = numbers_.find(place);
  return number != nullptr && is_used(*number) ? std::optional(*number) : std::nullopt;
}

Place Lattice::place(std::uint32_t vertex) const {
  const std::size_t roots = grid_.vertex_count();
  if (vertex >= roots) return places_[vertex - roots];
  return {static_cast<std::uint32_t>(vertex % grid_.u.size()) * kCellUnit,
          static_cast<std::uint32_t>(vertex / grid_.u.size()) * kCellUnit};
}

void Lattice::evaluate(unsigned threads) {
  const std::size_t count = used_.size() - evaluated_;
  std::vector<double> u(count);
  std::vector<double> v(count);
  for (std::size_t i = 0; i < count; ++i) {
    const dvec2 uv = parameters(place(static_cast<std::uint32_t>(evaluated_ + i)));
    grid_.mesh.uv.push_back(uv);
    u[i] = uv.x;
    v[i] = uv.y;
  }
  std::vector<std::vector<double>> columns(surface_.normals.outputs.size(),
                                           std::vector<double>(count));
  std::vector<double*> starts(columns.size());
  std::ranges::transform(columns, starts.begin(), [](auto& column) { return column.data(); });
  evaluate_points(surface_.normals, u, v, starts, threads);
  const double front = surface_.flip ? -1 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto vector = [&](std::size_t k) {
      return dvec3(columns[k][i], columns[k + 1][i], columns[k + 2][i]);
    };
    const dvec3 normal = front * vector(3);
    // |r_u x r_v| beside |r_u| |r_v|, all of which may be infinite or 0.
    const double scale = std::sqrt(columns[7][i]) * std::sqrt(columns[8][i]);
    const bool regular = columns[6][i] > kDegenerateCross * scale && is_finite(normal);
    grid_.mesh.position.push_back(vector(0));
    grid_.mesh.normal.push_back(regular ? normal : dvec3(0));
    grid_.mesh.point.push_back(static_cast<std::uint32_t>(evaluated_ + i));
    regular_[evaluated_ + i] = regular ? 1 : 0;
  }
  for (std::size_t vertex = evaluated_; vertex < used_.size(); ++vertex) {
    join_pole(static_cast<std::uint32_t>(vertex));
  }
  evaluated_ = used_.size();
  evaluations_ += count;
}

void Lattice::join_pole(std::uint32_t vertex) {
  const Place p = place(vertex);
  const bool on_u = p.u % kCellUnit == 0;
  if (!on_u && p.v % kCellUnit != 0) return;
  const auto before = [](std::uint32_t c) { return c / kCellUnit * kCellUnit; };
  const Place a = {before(p.u), before(p.v)};
  const Place b = on_u ? Place{a.u, a.v + kCellUnit} : Place{a.u + kCellUnit, a.v};
  const std::uint32_t root = root_vertex(a);
  const bool ends_meet = grid_.mesh.point[root] == grid_.mesh.point[root_vertex(b)];
  if (ends_meet && is_one_point(grid_, root, vertex)) unite(root, vertex);
}

void Lattice::unite(std::uint32_t first, std::uint32_t second) {
  Mesh& mesh = grid_.mesh;
  mesh.position[second] = mesh.position[first];
  mesh.point[second] = mesh.point[first];
  regular_[first] = regular_[second] = 0;
}

}  // namespace saddle
