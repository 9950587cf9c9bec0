#include "mesh/check_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "base/random.h"
#include "surface/normal.h"

namespace saddle {
namespace {

/// Where a cell's error is largest: at its centre and the middles of its sides, and where an arc
/// turns that its middle does not show.
constexpr std::array kMiddles = {0.5};
constexpr std::array kQuarters = {0.25, 0.75};
/// Random offset from there, in cells: as large as that of measure_error().
constexpr double kJitter = 0.1;
/// A triangle's point is straight above the surface's if it is not farther aside than this part of
/// the triangle's side: curvature then takes no more than a twentieth of the distance.
constexpr double kBeside = 0.1;
constexpr std::size_t kRowChunk = 8;

/// Places along one parameter and the cells that they are in.
struct Axis {
  std::vector<double> at;
  std::vector<std::size_t> cell;
};

/// In each cell at these parts of it, jittered.
Axis inside(const std::vector<double>& lines, std::span<const double> parts, std::uint64_t key) {
  Axis axis;
  for (std::size_t cell = 0; cell + 1 < lines.size(); ++cell) {
    for (const double part : parts) {
      const double random = random_unit(key + axis.at.size());
      axis.at.push_back(std::lerp(lines[cell], lines[cell + 1], part + kJitter * (2 * random - 1)));
      axis.cell.push_back(cell);
    }
  }
  return axis;
}

/// On each line: that of the cell after it, or before the last one.
Axis on(const std::vector<double>& lines) {
  Axis axis{lines, std::vector<std::size_t>(lines.size())};
  std::iota(axis.cell.begin(), axis.cell.end(), std::size_t{0});
  --axis.cell.back();
  return axis;
}

/// The largest of what has been found, in local units; unit normals by the length of their
/// difference.
struct Largest {
  double distance = 0;
  double chord = 0;

  void add(double away, double apart) {
    distance = away <= distance ? distance : away;  // also NaN
    chord = apart <= chord ? chord : apart;
  }
  void add(const Largest& other) { add(other.distance, other.chord); }
};

/// What the corners of a triangle weigh at (u, v); negative outside.
dvec3 weights_at(const std::array<dvec2, 3>& at, const dvec2& uv) {
  const auto area = [](const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double whole = area(at[1] - at[0], at[2] - at[0]);
  const double b = area(uv - at[0], at[2] - at[0]) / whole;
  const double c = area(at[1] - at[0], uv - at[0]) / whole;
  return {1 - b - c, b, c};
}

/// The vertices at the ends of a cell's side.
using Ends = std::array<std::size_t, 2>;

class Checker {
 public:
  Checker(const Surface& surface, const Grid& grid, unsigned threads)
      : surface_(surface), grid_(grid), threads_(threads) {}

  std::size_t evaluations() const { return evaluations_; }

  /// Checks the places u x v. side(i, j): the ends of the cell's side that place (i, j) is on, or
  /// the same vertex twice inside; is_seen(i, j): whether the side is seen.
  template <class Side, class Seen>
  Largest check(const Axis& u, const Axis& v, Side side, Seen is_seen) {
    const NormalColumns columns = evaluate_normals_on_grid(surface_, u.at, v.at, threads_);
    evaluations_ += u.at.size() * v.at.size();
    std::vector<Largest> of_rows(v.at.size());
    parallel_chunks(v.at.size(), kRowChunk, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j) {
        for (std::size_t i = 0; i < u.at.size(); ++i) {
          const std::size_t k = j * u.at.size() + i;
          const Ends ends = side(i, j);
          if (is_pole(ends)) continue;
          const std::size_t cell = grid_.cell(u.cell[i], v.cell[j]);
          of_rows[j].add(measure(cell, {u.at[i], v.at[j]}, columns, k));
          if (is_seen(i, j)) of_rows[j].add(from_chord(ends, position(columns, k)), 0);
        }
      }
    });
    Largest largest;
    for (const Largest& row : of_rows) largest.add(row);
    return largest;
  }

 private:
  /// A side that is a single point: there is no normal, and nothing to be off by.
  bool is_pole(const Ends& ends) const {
    return ends[0] != ends[1] && grid_.mesh.point[ends[0]] == grid_.mesh.point[ends[1]];
  }

  /// The distance of a position from the chord between two vertices, in local units.
  double from_chord(const Ends& ends, const dvec3& p) const {
    const dvec3 edge = grid_.local(ends[1]) - grid_.local(ends[0]);
    const dvec3 off = p - grid_.local(ends[0]);
    return glm::length(off - glm::dot(off, edge) / glm::dot(edge, edge) * edge);
  }

  dvec3 position(const NormalColumns& columns, std::size_t k) const {
    return grid_.local_scale * dvec3(columns[0][k], columns[1][k], columns[2][k]);
  }

  Largest measure(std::size_t cell, const dvec2& uv, const NormalColumns& columns,
                  std::size_t k) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const double area = columns[kAreaColumn][k];
    const double scale = columns[kSquareUColumn][k] * columns[kSquareVColumn][k];
    if (!(area * area > kDegenerateCross * kDegenerateCross * scale)) return {kNone, kNone};
    const double sign = surface_.flip ? -1 : 1;
    const dvec3 normal = sign * dvec3(columns[kNormalColumn][k], columns[kNormalColumn + 1][k],
                                      columns[kNormalColumn + 2][k]);
    const dvec3 p = position(columns, k);
    if (!is_finite(p) || !is_finite(normal)) return {kNone, kNone};
    const std::optional<Largest> straight = straight_above(cell, uv, p, normal);
    if (straight) return *straight;
    const Deviation d = deviation(grid_, grid_.triangles(cell), uv, p / grid_.local_scale, normal);
    return {grid_.local_scale * d.distance, chord_of_degrees(d.degrees)};
  }

  /// Of the triangle that a place is in, if its point there is straight above or below the
  /// surface's.
  std::optional<Largest> straight_above(std::size_t cell, const dvec2& uv, const dvec3& p,
                                        const dvec3& normal) const {
    const auto& at = grid_.mesh.uv;
    for (const Triangle& t : grid_.triangles(cell)) {
      const dvec3 weights = weights_at({at[t[0]], at[t[1]], at[t[2]]}, uv);
      if (!(std::min({weights.x, weights.y, weights.z}) >= -kRounding)) continue;
      const dvec3 first = grid_.local(t[0]);
      const dvec3 along = grid_.local(t[1]) - first;
      const dvec3 across = grid_.local(t[2]) - first;
      const dvec3 off = first - p + weights.y * along + weights.z * across;
      const double height = glm::dot(off, normal);
      const double beside = glm::dot(off, off) - height * height;
      const double square = std::min(glm::dot(along, along), glm::dot(across, across));
      if (!(beside <= kBeside * kBeside * square)) return std::nullopt;
      const auto& normals = grid_.mesh.normal;
      const dvec3 mean =
          weights.x * normals[t[0]] + weights.y * normals[t[1]] + weights.z * normals[t[2]];
      return Largest{std::fabs(height), glm::length(glm::normalize(mean) - normal)};
    }
    return std::nullopt;
  }

  const Surface& surface_;
  const Grid& grid_;
  unsigned threads_;
  std::size_t evaluations_ = 0;
};

}  // namespace

MeasuredError check_cells(const Surface& surface, const Grid& grid, const SeenLines& seen,
                          unsigned threads) {
  const auto inside_cell = [](std::size_t, std::size_t) { return Ends{0, 0}; };
  const auto unseen = [](std::size_t, std::size_t) { return false; };
  const std::size_t cells = grid.cells_u + grid.cells_v;
  const Axis middles_u = inside(grid.u, kMiddles, 0);
  const Axis middles_v = inside(grid.v, kMiddles, cells);
  const Axis quarters_u = inside(grid.u, kQuarters, 2 * cells);
  const Axis quarters_v = inside(grid.v, kQuarters, 4 * cells);
  Checker checker(surface, grid, threads);
  Largest largest = checker.check(quarters_u, quarters_v, inside_cell, unseen);
  largest.add(checker.check(middles_u, middles_v, inside_cell, unseen));
  largest.add(checker.check(
      middles_u, on(grid.v),
      [&](std::size_t i, std::size_t j) {
        return Ends{grid.vertex(i, j), grid.vertex(i + 1, j)};
      },
      [&](std::size_t, std::size_t j) { return seen.rows[j] != 0; }));
  largest.add(checker.check(
      on(grid.u), middles_v,
      [&](std::size_t i, std::size_t j) {
        return Ends{grid.vertex(i, j), grid.vertex(i, j + 1)};
      },
      [&](std::size_t i, std::size_t) { return seen.columns[i] != 0; }));
  return {largest.distance / grid.local_scale, degrees_of_chord(largest.chord),
          checker.evaluations()};
}

}  // namespace saddle
