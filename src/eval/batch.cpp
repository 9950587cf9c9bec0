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

void evaluate_grid(const Tape& tape, std::span<const double> u, std::span<const double> v,
                   std::span<double* const> outputs, unsigned threads) {
  std::vector<double> columns = fill_bank(u, tape.slots_u);
  std::vector<double> rows = fill_bank(v, tape.slots_v);
  Banks once;
  once.loops = kernels(cpu_level());
  once.constants = tape.constants.data();
  once.u = {columns.data(), u.size()};
  once.v = {rows.data(), v.size()};
  once.run(tape.of_u, once.u, u.size());
  once.run(tape.of_v, once.v, v.size());

  const std::size_t rows_per_chunk =
      std::max<std::size_t>(1, kChunk / std::max<std::size_t>(1, u.size()));
  parallel_chunks(v.size(), rows_per_chunk, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> memory(tape.slots_both * kBlock);
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t column = 0; column < u.size(); column += kBlock) {
        const std::size_t count = std::min(kBlock, u.size() - column);
        Banks banks = once;
        banks.u = {columns.data() + column, u.size()};
        banks.v = {rows.data() + row, v.size(), false};
        banks.both = {memory.data(), kBlock};
        banks.run(tape.of_both, banks.both, count);
        banks.store(tape, outputs, row * u.size() + column, count);
      }
    }
  });
}

}  // namespace saddle
