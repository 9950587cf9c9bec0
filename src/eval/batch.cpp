#include "eval/batch.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "base/parallel.h"
#include "eval/kernels.h"

namespace saddle {
namespace {

/// Numbers per block: the slots of a usual tape (ten to fifty) then stay within a second-level
/// cache, and the cost of starting a loop is spread over enough numbers.
constexpr std::size_t kBlock = 512;

/// Points that one thread takes at a time: some milliseconds of work, so that starting it is free.
constexpr std::size_t kChunk = 64 * kBlock;

/// Where the slots of a bank are: slot s begins at data + s * pitch.
struct Bank {
  double* data = nullptr;
  std::size_t pitch = 0;
  bool varies = true;  ///< false: one number serves the whole loop

  Operand operand(std::uint32_t slot) const { return {data + slot * pitch, varies}; }
};

/// The banks as one loop over a block sees them.
struct Banks {
  const Kernel* loops = nullptr;  // of the CPU level
  const double* constants = nullptr;
  Bank u, v, both;

  Operand operand(Slot slot) const {
    switch (slot.rate) {
      case Rate::Constant:
        return {constants + slot.index, false};
      case Rate::U:
        return u.operand(slot.index);
      case Rate::V:
        return v.operand(slot.index);
      case Rate::Both:
        return both.operand(slot.index);
    }
    return {};
  }

  /// Runs the instructions; all of them write to `target`.
  void run(std::span<const Instruction> instructions, const Bank& target, std::size_t count) const {
    for (const Instruction& instruction : instructions) {
      std::array<Operand, 3> in;
      for (int i = 0; i < arity(instruction.op); ++i) in[i] = operand(instruction.in[i]);
      const Kernel kernel = loops[static_cast<std::size_t>(instruction.op)];
      kernel(target.data + instruction.out.index * target.pitch, in.data(), count);
    }
  }

  void store(const Tape& tape, std::span<double* const> outputs, std::size_t at,
             std::size_t count) const {
    for (std::size_t k = 0; k < tape.outputs.size(); ++k) {
      const Operand from = operand(tape.outputs[k]);
      if (from.varies) {
        std::copy_n(from.data, count, outputs[k] + at);
      } else {
        std::fill_n(outputs[k] + at, count, *from.data);
      }
    }
  }
};

/// A bank of one parameter over all its values: slot 0 holds them, the instructions fill the rest.
std::vector<double> fill_bank(std::span<const double> values, std::uint32_t slots) {
  std::vector<double> bank(slots * values.size());
  std::copy(values.begin(), values.end(), bank.begin());
  return bank;
}

}  // namespace

void evaluate_points(const Tape& tape, std::span<const double> u, std::span<const double> v,
                     std::span<double* const> outputs, unsigned threads) {
  assert(u.size() == v.size());
  const Kernel* const loops = kernels(cpu_level());
  parallel_chunks(u.size(), kChunk, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> memory((tape.slots_u + tape.slots_v + tape.slots_both) * kBlock);
    Banks banks;
    banks.loops = loops;
    banks.constants = tape.constants.data();
    banks.u = {memory.data(), kBlock};
    banks.v = {banks.u.data + tape.slots_u * kBlock, kBlock};
    banks.both = {banks.v.data + tape.slots_v * kBlock, kBlock};
    for (std::size_t at = begin; at < end; at += kBlock) {
      const std::size_t count = std::min(kBlock, end - at);
      std::copy_n(u.data() + at, count, banks.u.data);
      std::copy_n(v.data() + at, count, banks.v.data);
      banks.run(tape.of_u, banks.u, count);
      banks.run(tape.of_v, banks.v, count);
      banks.run(tape.of_both, banks.both, count);
      banks.store(tape, outputs, at, count);
    }
  });
}

/// What depends on u alone, on v alone, for a whole grid.
struct GridBanks {
  GridBanks(const Tape& tape, std::span<const double> u, std::span<const double> v)
      : columns(fill_bank(u, tape.slots_u)), rows(fill_bank(v, tape.slots_v)) {
    banks.loops = kernels(cpu_level());
    banks.constants = tape.constants.data();
    banks.u = {columns.data(), u.size()};
    banks.v = {rows.data(), v.size()};
    banks.run(tape.of_u, banks.u, u.size());
    banks.run(tape.of_v, banks.v, v.size());
  }

  /// The banks for a stretch of one row; `memory` is bank Both.
  Banks stretch(std::size_t column, std::size_t row, std::vector<double>& memory,
                std::size_t pitch) const {
    Banks result = banks;
    result.u.data += column;
    result.v.data += row;
    result.v.varies = false;
    result.both = {memory.data(), pitch};
    return result;
  }

  std::vector<double> columns, rows;
  Banks banks;
};

void evaluate_grid(const Tape& tape, std::span<const double> u, std::span<const double> v,
                   std::span<double* const> outputs, unsigned threads) {
  const GridBanks grid(tape, u, v);
  const std::size_t rows_per_chunk =
      std::max<std::size_t>(1, kChunk / std::max<std::size_t>(1, u.size()));
  parallel_chunks(v.size(), rows_per_chunk, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> memory(tape.slots_both * kBlock);
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t column = 0; column < u.size(); column += kBlock) {
        const std::size_t count = std::min(kBlock, u.size() - column);
        const Banks banks = grid.stretch(column, row, memory, kBlock);
        banks.run(tape.of_both, banks.both, count);
        banks.store(tape, outputs, row * u.size() + column, count);
      }
    }
  });
}

GridTiling::GridTiling(std::size_t cells_u, std::size_t cells_v, std::size_t cells)
    : cells_u_(cells_u),
      cells_v_(cells_v),
      cells_(cells),
      across_((cells_u + cells - 1) / cells),
      down_((cells_v + cells - 1) / cells) {}

GridTile GridTiling::tile(std::size_t index) const {
  const std::size_t column = index % across_ * cells_;
  const std::size_t row = index / across_ * cells_;
  return {index, column, row, std::min(cells_, cells_u_ - column) + 1,
          std::min(cells_, cells_v_ - row) + 1};
}

TileRows::TileRows(const Tape& tape, const GridBanks& grid, const GridTile& tile)
    : tape_(tape),
      grid_(grid),
      tile_(tile),
      next_row_(tile.row),
      memory_(tape.slots_both * tile.columns),
      outputs_(tape.outputs.size()) {}

bool TileRows::next() {
  if (next_row_ == tile_.row + tile_.rows) return false;
  const Banks banks = grid_.stretch(tile_.column, next_row_++, memory_, tile_.columns);
  banks.run(tape_.of_both, banks.both, tile_.columns);
  for (std::size_t k = 0; k < outputs_.size(); ++k) outputs_[k] = banks.operand(tape_.outputs[k]);
  return true;
}

void evaluate_tiles(const Tape& tape, std::span<const double> u, std::span<const double> v,
                    const GridTiling& tiling, unsigned threads,
                    const std::function<void(TileRows&)>& work) {
  const GridBanks grid(tape, u, v);
  parallel_chunks(tiling.count(), 1, threads, [&](std::size_t index, std::size_t) {
    TileRows rows(tape, grid, tiling.tile(index));
    work(rows);
  });
}

}  // namespace saddle
