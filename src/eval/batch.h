// Runs a tape over many points, in blocks, on several threads.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "eval/kernels.h"
#include "eval/tape.h"

namespace saddle {

/// outputs[k][i] = output k at (u[i], v[i]). Each outputs[k] has room for u.size() numbers, and
/// u.size() == v.size(). NaN and infinities are values like any other. `threads` 0: all.
void evaluate_points(const Tape& tape, std::span<const double> u, std::span<const double> v,
                     std::span<double* const> outputs, unsigned threads = 0);

/// outputs[k][j * u.size() + i] = output k at (u[i], v[j]): what depends on u alone is computed
/// once per column, on v alone once per row. The same bits as evaluate_points, for any `threads`.
void evaluate_grid(const Tape& tape, std::span<const double> u, std::span<const double> v,
                   std::span<double* const> outputs, unsigned threads = 0);

/// A rectangle of a grid's vertices: columns [column, column + columns), rows alike.
struct GridTile {
  std::size_t index = 0;  ///< number of the tile
  std::size_t column = 0;
  std::size_t row = 0;
  std::size_t columns = 0;
  std::size_t rows = 0;
};

/// How a grid of cells_u x cells_v cells is cut into tiles of at most `cells` x `cells` cells, row
/// by row of tiles. Neighbours share the vertices between them.
class GridTiling {
 public:
  GridTiling(std::size_t cells_u, std::size_t cells_v, std::size_t cells);
  std::size_t count() const { return across_ * down_; }
  std::size_t across() const { return across_; }
  GridTile tile(std::size_t index) const;

 private:
  std::size_t cells_u_, cells_v_, cells_;
  std::size_t across_, down_;
};

struct GridBanks;
class Slots;

/// The rows of one tile, computed one after the other, from the lowest to the highest.
class TileRows {
 public:
  TileRows(const Tape& tape, const GridBanks& grid, const GridTile& tile);
  ~TileRows();
  TileRows(const TileRows&) = delete;
  TileRows& operator=(const TileRows&) = delete;

  const GridTile& tile() const { return tile_; }
  /// Computes the next row; false after the last.
  bool next();
  /// The row of the grid that has been computed.
  std::size_t row() const { return next_row_ - 1; }
  /// Output k at the tile's vertex i of the row is outputs()[k].data[outputs()[k].varies ? i : 0].
  std::span<const Operand> outputs() const { return outputs_; }

 private:
  /// An instruction with its operands looked up once for all rows of the tile.
  struct Step {
    const Instruction* instruction;
    double* out;
    double* cosine;
    std::array<Operand, 3> in;
  };
  void go_up();

  const GridBanks& grid_;
  GridTile tile_;
  std::size_t next_row_;
  std::unique_ptr<Slots> memory_;
  std::vector<Step> steps_;
  std::vector<Operand> outputs_;
  std::vector<const double**> of_v_;  ///< in steps and outputs: what moves on with each row
};

/// Computes the tape on the grid u x v tile by tile: what `work` takes row by row is still in the
/// fastest cache. Tiles run on several threads in any order, each on one.
void evaluate_tiles(const Tape& tape, std::span<const double> u, std::span<const double> v,
                    const GridTiling& tiling, unsigned threads,
                    const std::function<void(TileRows&)>& work);

}  // namespace saddle
