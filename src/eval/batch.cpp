#include "eval/batch.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <new>
#include <vector>

#include "base/parallel.h"
#include "eval/kernels.h"

namespace saddle {

/// Memory for slots, where no vector of the loops straddles two lines of the cache.
class Slots {
 public:
  static constexpr std::size_t kLine = 64;
  /// Doubles from one slot to the next, for `count` numbers each: whole lines.
  static std::size_t pitch(std::size_t count) {
    constexpr std::size_t kPerLine = kLine / sizeof(double);
    return (count + kPerLine - 1) / kPerLine * kPerLine;
  }
  explicit Slots(std::size_t doubles)
      : data_(static_cast<double*>(
            ::operator new (doubles * sizeof(double), std::align_val_t{kLine}))) {}
  ~Slots() { ::operator delete (data_, std::align_val_t{kLine}); }
  Slots(const Slots&) = delete;
  Slots& operator=(const Slots&) = delete;
  double* data() const { return data_; }

 private:
  double* data_;
};

namespace {

/// Numbers per block. The cost of starting a loop must be spread over enough of them, and the slots
/// of a tape (ten to fifty) stay within a second-level cache. Measured on torus and seashell: 64 is
/// a third slower, from 128 to 512 a tenth, from 1024 to 4096 it makes no difference.
constexpr std::size_t kBlock = 1024;
/// The least block, of a tape of many slots, and the doubles that slots may take: as many as a
/// second-level cache holds.
constexpr std::size_t kLeastBlock = 64;
constexpr std::size_t kDoublesOfSlots = 128 * kBlock;

/// Points that one thread takes at a time: some milliseconds of work, so that starting it is free.
constexpr std::size_t kChunk = 32 * kBlock;

/// Where the slots of a bank are: slot s begins at data + s * pitch.
struct Bank {
  double* data = nullptr;
  std::size_t pitch = 0;
  bool varies = true;  ///< false: one number serves the whole loop
};

/// The banks as one loop over a block sees them.
struct Banks {
  const Kernels* loops = nullptr;  // of the CPU level
  std::array<Bank, 4> of_rate;

  Bank& operator[](Rate rate) { return of_rate[static_cast<std::size_t>(rate)]; }

  Operand operand(Slot slot) const {
    const Bank& bank = of_rate[static_cast<std::size_t>(slot.rate)];
    return {bank.data + slot.index * bank.pitch, bank.varies};
  }

  /// Where a result goes.
  double* place(Slot slot) const {
    const Bank& bank = of_rate[static_cast<std::size_t>(slot.rate)];
    return bank.data + slot.index * bank.pitch;
  }

  void run(std::span<const Instruction> instructions, std::size_t count) const {
    for (const Instruction& instruction : instructions) {
      std::array<Operand, 3> in;
      for (int i = 0; i < arity(instruction.op); ++i) in[i] = operand(instruction.in[i]);
      if (instruction.cosine) {
        loops->sin_cos(place(instruction.out), place(*instruction.cosine), in[0].data, count);
      } else {
        (*loops)[instruction.op](place(instruction.out), in.data(), count);
      }
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

/// The constants and the loops of the CPU level.
Banks banks_of(const Tape& tape) {
  Banks banks;
  banks.loops = &kernels(cpu_level());
  // Constants are never written, although a bank can be.
  banks[Rate::Constant] = {const_cast<double*>(tape.constants.data()), 1, false};
  return banks;
}

/// Numbers per block of a tape of so many slots, in whole lines of the cache.
std::size_t block_of(std::size_t slots, std::size_t count) {
  const std::size_t fitting = kDoublesOfSlots / std::max<std::size_t>(slots, 1);
  return Slots::pitch(std::min(std::clamp(fitting, kLeastBlock, kBlock), count));
}

}  // namespace

void evaluate_points(const Tape& tape, std::span<const double> u, std::span<const double> v,
                     std::span<double* const> outputs, unsigned threads) {
  if (tape.count) tape.count->add(u.size());
  assert(u.size() == v.size());
  const std::size_t slots = tape.slots_u + tape.slots_v + tape.slots_both;
  const std::size_t block = block_of(slots, u.size());
  parallel_chunks(u.size(), kChunk, threads, [&](std::size_t begin, std::size_t end) {
    const Slots memory(slots * block);
    Banks banks = banks_of(tape);
    banks[Rate::U] = {memory.data(), block};
    banks[Rate::V] = {memory.data() + tape.slots_u * block, block};
    banks[Rate::Both] = {banks[Rate::V].data + tape.slots_v * block, block};
    for (std::size_t at = begin; at < end; at += block) {
      const std::size_t count = std::min(block, end - at);
      std::copy_n(u.data() + at, count, banks[Rate::U].data);
      std::copy_n(v.data() + at, count, banks[Rate::V].data);
      banks.run(tape.of_u, count);
      banks.run(tape.of_v, count);
      banks.run(tape.of_both, count);
      banks.store(tape, outputs, at, count);
    }
  });
}

/// Values that depend on u alone, and on v alone, for a whole grid.
struct GridBanks {
  GridBanks(const Tape& tape, std::span<const double> u, std::span<const double> v)
      : columns(tape.slots_u * Slots::pitch(u.size())),
        rows(tape.slots_v * Slots::pitch(v.size())),
        banks(banks_of(tape)) {
    banks[Rate::U] = {columns.data(), Slots::pitch(u.size())};
    banks[Rate::V] = {rows.data(), Slots::pitch(v.size())};
    std::copy(u.begin(), u.end(), columns.data());
    std::copy(v.begin(), v.end(), rows.data());
    banks.run(tape.of_u, u.size());
    banks.run(tape.of_v, v.size());
  }

  /// The banks for a stretch of one row; `memory` is bank Both, for up to `count` numbers.
  Banks stretch(std::size_t column, std::size_t row, const Slots& memory, std::size_t count) const {
    Banks result = banks;
    result[Rate::U].data += column;
    result[Rate::V].data += row;
    result[Rate::V].varies = false;
    result[Rate::Both] = {memory.data(), Slots::pitch(count)};
    return result;
  }

  Slots columns, rows;
  Banks banks;
};

void evaluate_grid(const Tape& tape, std::span<const double> u, std::span<const double> v,
                   std::span<double* const> outputs, unsigned threads) {
  if (tape.count) tape.count->add(u.size() * v.size());
  const GridBanks grid(tape, u, v);
  const std::size_t rows_per_chunk =
      std::max<std::size_t>(1, kChunk / std::max<std::size_t>(1, u.size()));
  const std::size_t block = block_of(tape.slots_both, u.size());
  parallel_chunks(v.size(), rows_per_chunk, threads, [&](std::size_t begin, std::size_t end) {
    const Slots memory(tape.slots_both * block);
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t column = 0; column < u.size(); column += block) {
        const std::size_t count = std::min(block, u.size() - column);
        const Banks banks = grid.stretch(column, row, memory, block);
        banks.run(tape.of_both, count);
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

TileRows::~TileRows() = default;

TileRows::TileRows(const Tape& tape, const GridBanks& grid, const GridTile& tile)
    : grid_(grid),
      tile_(tile),
      next_row_(tile.row),
      memory_(std::make_unique<Slots>(tape.slots_both * Slots::pitch(tile.columns))),
      steps_(tape.of_both.size()),
      outputs_(tape.outputs.size()) {
  const Banks banks = grid.stretch(tile.column, tile.row, *memory_, tile.columns);
  const auto look_up = [&](Slot slot, Operand& operand) {
    operand = banks.operand(slot);
    if (slot.rate == Rate::V) of_v_.push_back(&operand.data);
  };
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const Instruction& instruction = tape.of_both[k];
    Step& step = steps_[k];
    step.instruction = &instruction;
    step.out = banks.place(instruction.out);
    step.cosine = instruction.cosine ? banks.place(*instruction.cosine) : nullptr;
    for (int i = 0; i < arity(instruction.op); ++i) look_up(instruction.in[i], step.in[i]);
  }
  for (std::size_t k = 0; k < outputs_.size(); ++k) look_up(tape.outputs[k], outputs_[k]);
}

void TileRows::go_up() {
  for (const double** data : of_v_) ++*data;
}

bool TileRows::next() {
  if (next_row_ == tile_.row + tile_.rows) return false;
  if (next_row_++ > tile_.row) go_up();
  const Kernels& loops = *grid_.banks.loops;
  for (const Step& step : steps_) {
    if (step.cosine != nullptr) {
      loops.sin_cos(step.out, step.cosine, step.in[0].data, tile_.columns);
    } else {
      loops[step.instruction->op](step.out, step.in.data(), tile_.columns);
    }
  }
  return true;
}

void evaluate_tiles(const Tape& tape, std::span<const double> u, std::span<const double> v,
                    const GridTiling& tiling, unsigned threads,
                    const std::function<void(TileRows&)>& work) {
  if (tape.count) tape.count->add(u.size() * v.size());
  const GridBanks grid(tape, u, v);
  parallel_chunks(tiling.count(), 1, threads, [&](std::size_t index, std::size_t) {
    TileRows rows(tape, grid, tiling.tile(index));
    work(rows);
  });
}

}  // namespace saddle
