// A graph as a straight-line program: one instruction per operation, values in slots.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "eval/point_count.h"
#include "formula/graph.h"
#include "formula/lower.h"

namespace saddle {

/// The parameters that a value depends on: they decide how often a grid computes it.
enum class Rate : std::uint8_t { Constant, U, V, Both };

/// Where an operand or a result lives: the rate names the bank of slots, the index the slot.
struct Slot {
  Rate rate = Rate::Constant;
  std::uint32_t index = 0;
};

struct Instruction {
  Op op = Op::Constant;
  Slot out;
  std::array<Slot, 3> in;
  std::optional<Slot> cosine = {};  ///< of a Sin: where the cosine of the same argument goes
};

/// A program that computes several outputs from u and v. Slot 0 of bank U holds u, slot 0 of bank
/// V holds v; the constants stand ready in theirs. Slots of bank Both are reused once their value
/// is no longer needed.
struct Tape {
  std::vector<double> constants;
  std::vector<Instruction> of_u;     ///< run once per column of a grid
  std::vector<Instruction> of_v;     ///< run once per row
  std::vector<Instruction> of_both;  ///< run for every point
  std::uint32_t slots_u = 1;         ///< sizes of the banks
  std::uint32_t slots_v = 1;
  std::uint32_t slots_both = 0;
  std::vector<Slot> outputs;
  /// Counts the points that are computed, together with other tapes; none: they are not counted.
  std::shared_ptr<PointCount> count = nullptr;
};

/// Compiles the outputs, sharing what they have in common, sine and cosine of the same argument in
/// one instruction. The outputs depend on u and v alone (Scope::bind has replaced the rest).
Tape compile(const Graph& graph, std::span<const NodeId> outputs, Powers powers = Powers::Products);

/// The first outputs of a tape, by the same instructions: they have the same bits.
Tape first_outputs(const Tape& tape, std::size_t count);

}  // namespace saddle
