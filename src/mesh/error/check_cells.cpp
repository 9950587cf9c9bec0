#include "mesh/error/check_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <span>

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/random.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/error/error_loops.h"
#include "mesh/grid/vertex_columns.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {
namespace {

constexpr std::size_t kRowChunk = 8;

/// Places along one parameter, their cells, and their parts of these: 0 to 1.
struct Axis {
  std::vector<double> at;
  std::vector<std::size_t> cell;
  std::vector<double> part;
};

/// Places in each cell at these parts of it, jittered: in all cells at the first part, then at the
/// next.
Axis inside(const std::vector<double>& lines, std::span<const double> parts, std::uint64_t key) {
  Axis axis;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (std::size_t cell = 0; cell + 1 < lines.size(); ++cell) {
      const double random = random_unit(key + cell * parts.size() + k);
      axis.part.push_back(parts[k] + kSampleJitter * (2 * random - 1));
      axis.at.push_back(std::lerp(lines[cell], lines[cell + 1], axis.part.back()));
      axis.cell.push_back(cell);
    }
  }
  return axis;
}

/// A place on each line, in the cell after it; on the last line, in the cell before it.
Axis on(const std::vector<double>& lines) {
  Axis axis{lines, std::vector<std::size_t>(lines.size()), std::vector<double>(lines.size(), 0.0)};
  std::iota(axis.cell.begin(), axis.cell.end(), std::size_t{0});
  --axis.cell.back();
  axis.part.back() = 1;
  return axis;
}

/// Consecutive places of an axis in consecutive cells.
struct PlaceStretch {
  std::size_t first, cell, count;
};

/// All of an axis, in stretches no longer than a strip.
std::vector<PlaceStretch> stretches_of(const Axis& axis) {
  std::vector<PlaceStretch> stretches;
  for (std::size_t k = 0; k < axis.at.size(); ++k) {
    const bool goes_on = !stretches.empty() && stretches.back().count < kTileCells &&
                         stretches.back().cell + stretches.back().count == axis.cell[k];
    if (!goes_on) stretches.push_back({k, axis.cell[k], 0});
    ++stretches.back().count;
  }
  return stretches;
}

/// The largest distance, in local units, and the largest square of the difference between unit
/// normals.
struct Largest {
  double distance = 0;
  double chord = 0;

  void add(const Largest& other) {
    distance = other.distance <= distance ? distance : other.distance;  // also NaN
    chord = other.chord <= chord ? chord : other.chord;
  }
};

/// The slot, 0 or 1, at which the diagonal of a cell starts, if the cell is cut as the pass over
/// the grid cuts plain ones; -1 for others.
double diagonal_of(const Grid& grid, std::size_t cell) {
  if (grid.cells[cell] != GridCell::Two) return -1;
  const auto vertices = grid.vertices(cell);
  const auto triangles = grid.triangles(cell);
  const std::size_t turn = grid.mirrored ? 1 : 0;
  for (const std::size_t first : {0, 1}) {
    const auto corner = [&](std::size_t k) {
      return static_cast<std::uint32_t>(vertices[(first + k) % 4]);
    };
    const Triangle one = {corner(0), corner(1 + turn), corner(2 - turn)};
    const Triangle other = {corner(2), corner(3 + turn), corner(4 - turn)};
    if (triangles[0] == one && triangles[1] == other) return static_cast<double>(first);
  }
  return -1;
}

/// The vertices of a row of cells, or of some of them, in local units.
class RowStrips {
 public:
  RowStrips(const Grid& grid, const PlaceStretch& stretch) : grid_(grid), stretch_(stretch) {}

  void go_to(std::size_t row) {
    load(row);
    load(row + 1);
    row_ = row;
  }
  const Strip& lower() const { return (*strips_)[row_ % 2]; }
  const Strip& upper() const { return (*strips_)[(row_ + 1) % 2]; }

 private:
  /// Loads a row of vertices, unless it is there as the upper row of the cells before.
  void load(std::size_t row) {
    std::optional<std::size_t>& loaded = rows_[row % 2];
    if (loaded == row) return;
    loaded = row;
    const std::size_t first = grid_.vertex(stretch_.cell, row);
    for (std::size_t i = 0; i <= stretch_.count; ++i) {
      put_vertex(grid_.local(first + i), grid_.mesh.normal[first + i], i, (*strips_)[row % 2]);
    }
  }

  const Grid& grid_;
  const PlaceStretch& stretch_;
  std::size_t row_ = 0;
  std::array<std::optional<std::size_t>, 2> rows_;
  std::unique_ptr<std::array<Strip, 2>> strips_ =
      std::make_unique_for_overwrite<std::array<Strip, 2>>();
};

/// The surface at the places u x v, with u inner.
struct AxisPlaces {
  const Axis& u;
  const Axis& v;
  NormalColumns columns;

  std::size_t number(std::size_t i, std::size_t j) const { return j * u.at.size() + i; }
};

/// The vertices at the ends of a cell's side.
using SideEnds = Chord;

SideEnds side_between(std::size_t a, std::size_t b) {
  return {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
}

class CellChecker {
 public:
  CellChecker(const Surface& surface, const Grid& grid, unsigned threads)
      : surface_(surface), grid_(grid), threads_(threads) {
    diagonals_.reserve(grid.cell_count());
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      diagonals_.push_back(diagonal_of(grid, cell));
    }
  }

  std::size_t evaluations() const { return evaluations_; }

  /// Checks the places u x v. side(i, j): the ends of the cell's side that place (i, j) is on, or
  /// the same vertex twice if it is inside; is_seen(i, j): whether the side is a visible line.
  template <class Side, class Seen>
  Largest check(const Axis& u, const Axis& v, Side side, Seen is_seen) {
    const AxisPlaces places{u, v, evaluate_normals_on_grid(surface_, u.at, v.at, threads_)};
    evaluations_ += u.at.size() * v.at.size();
    const std::vector<PlaceStretch> stretches = stretches_of(u);
    std::vector<Largest> of_rows(v.at.size());
    parallel_chunks(v.at.size(), kRowChunk, threads_, [&](std::size_t begin, std::size_t end) {
      const auto row_errors = std::make_unique_for_overwrite<RowErrors>();
      for (const PlaceStretch& stretch : stretches) {
        RowStrips strips(grid_, stretch);
        for (std::size_t j = begin; j < end; ++j) {
          strips.go_to(v.cell[j]);
          check_row(places, stretch, j, strips, *row_errors);
          for (std::size_t k = 0; k < stretch.count; ++k) {
            const std::size_t i = stretch.first + k;
            const SideEnds ends = side(i, j);
            if (row_errors->is_known[k] > 0) {
              of_rows[j].add({row_errors->distance[k], row_errors->chord[k]});
            } else if (!is_pole(ends)) {
              of_rows[j].add(check_place(places, i, j));
            }
            if (is_seen(i, j) && !is_pole(ends)) {
              of_rows[j].add({distance_from_line(grid_, ends, position(places, i, j)), 0});
            }
          }
        }
      }
    });
    Largest largest;
    for (const Largest& row : of_rows) largest.add(row);
    return largest;
  }

 private:
  /// Checks the places of a stretch in the j-th row of them.
  void check_row(const AxisPlaces& places, const PlaceStretch& stretch, std::size_t j,
                 const RowStrips& strips, RowErrors& row_errors) const {
    RowPlaces row{places.u.part.data() + stretch.first,
                  places.v.part[j],
                  diagonals_.data() + grid_.cell(stretch.cell, places.v.cell[j]),
                  {},
                  grid_.local_scale,
                  surface_.flip ? -1.0 : 1.0};
    const std::size_t first = places.number(stretch.first, j);
    for (std::size_t k = 0; k < row.surface.size(); ++k) {
      row.surface[k] = &places.columns[k][first];
    }
    check_loop(cpu_level())(strips.lower(), strips.upper(), row, stretch.count, row_errors);
  }

  /// Whether a side is a single point: it has no normal and no error.
  bool is_pole(const SideEnds& ends) const {
    return ends[0] != ends[1] && grid_.mesh.point[ends[0]] == grid_.mesh.point[ends[1]];
  }

  /// In local units.
  dvec3 position(const AxisPlaces& places, std::size_t i, std::size_t j) const {
    const std::size_t k = places.number(i, j);
    const NormalColumns& columns = places.columns;
    return grid_.local_scale * dvec3(columns[0][k], columns[1][k], columns[2][k]);
  }

  /// Checks one place by sampled_error().
  Largest check_place(const AxisPlaces& places, std::size_t i, std::size_t j) const {
    const NormalColumns& columns = places.columns;
    const std::size_t k = places.number(i, j);
    const double area = columns[kAreaColumn][k];
    const double scale = columns[kSquareUColumn][k] * columns[kSquareVColumn][k];
    if (!(area * area > kDegenerateCross * kDegenerateCross * scale)) return {kInfinity, kInfinity};
    const double sign = surface_.flip ? -1 : 1;
    const dvec3 normal = sign * dvec3(columns[kNormalColumn][k], columns[kNormalColumn + 1][k],
                                      columns[kNormalColumn + 2][k]);
    const dvec3 p = position(places, i, j);
    if (!is_finite(p) || !is_finite(normal)) return {kInfinity, kInfinity};
    const auto triangles = grid_.triangles(grid_.cell(places.u.cell[i], places.v.cell[j]));
    const SampledError d = sampled_error(grid_, triangles, {places.u.at[i], places.v.at[j]},
                                         p / grid_.local_scale, normal);
    const double chord = chord_of_degrees(d.degrees);
    return {grid_.local_scale * d.distance, chord * chord};
  }

  const Surface& surface_;
  const Grid& grid_;
  unsigned threads_;
  std::vector<double> diagonals_;  // of all cells: diagonal_of()
  std::size_t evaluations_ = 0;
};

}  // namespace

MeasuredError check_cells(const Surface& surface, const Grid& grid, const SeenLines& seen,
                          unsigned threads) {
  const auto inside_cell = [](std::size_t, std::size_t) { return SideEnds{0, 0}; };
  const auto unseen = [](std::size_t, std::size_t) { return false; };
  const std::size_t cells = grid.cells_u + grid.cells_v;
  // A cell's error is largest at its centre and the middles of its sides; in the quarters, if an
  // arc has a turning point in its middle.
  const Axis middles_u = inside(grid.u, kMiddleOfLine, 0);
  const Axis middles_v = inside(grid.v, kMiddleOfLine, cells);
  const Axis quarters_u = inside(grid.u, kBesideMiddle, 2 * cells);
  const Axis quarters_v = inside(grid.v, kBesideMiddle, 4 * cells);
  CellChecker checker(surface, grid, threads);
  Largest largest = checker.check(quarters_u, quarters_v, inside_cell, unseen);
  largest.add(checker.check(middles_u, middles_v, inside_cell, unseen));
  largest.add(checker.check(
      middles_u, on(grid.v),
      [&](std::size_t i, std::size_t j) {
        return side_between(grid.vertex(i, j), grid.vertex(i + 1, j));
      },
      [&](std::size_t, std::size_t j) { return seen.rows[j] != 0; }));
  largest.add(checker.check(
      on(grid.u), middles_v,
      [&](std::size_t i, std::size_t j) {
        return side_between(grid.vertex(i, j), grid.vertex(i, j + 1));
      },
      [&](std::size_t i, std::size_t) { return seen.columns[i] != 0; }));
  return {largest.distance / grid.local_scale, degrees_of_chord(std::sqrt(largest.chord)),
          checker.evaluations()};
}

}  // namespace saddle
