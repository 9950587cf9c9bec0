#include "eval/tape.h"

#include <array>
#include <limits>
#include <unordered_map>
#include <utility>

namespace saddle {
namespace {

Rate rate_of(const Node& node) {
  const bool u = (node.depends & kDependsU) != 0;
  const bool v = (node.depends & kDependsV) != 0;
  if (u && v) return Rate::Both;
  if (u) return Rate::U;
  return v ? Rate::V : Rate::Constant;
}

/// Gives every value a slot; a slot of bank Both is free again after the last use of its value.
class Allocator {
 public:
  Allocator(const Graph& graph, const std::vector<bool>& needed, std::span<const NodeId> roots)
      : graph_(graph), slots_(needed.size()), last_use_(needed.size(), 0) {
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id]) continue;
      for (int i = 0; i < arity(graph[id].op); ++i) last_use_[graph[id].args[i]] = id;
    }
    for (const NodeId root : roots) last_use_[root] = std::numeric_limits<NodeId>::max();
  }

  void place_leaf(NodeId id, Tape& tape) {
    const Node& node = graph_[id];
    slots_[id].rate = rate_of(node);
    if (node.op == Op::Constant) {
      slots_[id].index = static_cast<std::uint32_t>(tape.constants.size());
      tape.constants.push_back(node.value);
    }  // u and v are slot 0 of their banks
  }

  Instruction place(NodeId id, Tape& tape) {
    const Node& node = graph_[id];
    Instruction instruction;
    instruction.op = node.op;
    for (int i = 0; i < arity(node.op); ++i) instruction.in[i] = slots_[node.args[i]];
    for (int i = 0; i < arity(node.op); ++i) release(node.args[i], id);
    instruction.out = slots_[id] = {rate_of(node), take(rate_of(node), tape)};
    return instruction;
  }

  /// A place for a second result of an instruction.
  Slot place_beside(NodeId id, Tape& tape) {
    const Rate rate = rate_of(graph_[id]);
    return slots_[id] = {rate, take(rate, tape)};
  }

  /// `user` has nothing to compute: its argument's slot is free if this was its last use.
  void skip(NodeId user) { release(graph_[user].args[0], user); }

  Slot slot(NodeId id) const { return slots_[id]; }

 private:
  std::uint32_t take(Rate rate, Tape& tape) {
    if (rate == Rate::U) return tape.slots_u++;
    if (rate == Rate::V) return tape.slots_v++;
    if (free_.empty()) return tape.slots_both++;
    const std::uint32_t index = free_.back();
    free_.pop_back();
    return index;
  }

  void release(NodeId argument, NodeId user) {
    if (slots_[argument].rate != Rate::Both || last_use_[argument] != user) return;
    last_use_[argument] = 0;  // once, even if the user takes it twice
    free_.push_back(slots_[argument].index);
  }

  const Graph& graph_;
  std::vector<Slot> slots_;
  std::vector<NodeId> last_use_;
  std::vector<std::uint32_t> free_;
};

/// Sines and cosines of the same argument.
class SinCosPairs {
 public:
  SinCosPairs(const Graph& graph, const std::vector<bool>& needed) {
    std::unordered_map<NodeId, NodeId> sine_of;
    std::unordered_map<NodeId, NodeId> cosine_of;
    for (NodeId id = 0; id < needed.size(); ++id) {
      if (!needed[id]) continue;
      if (graph[id].op == Op::Sin) sine_of[graph[id].args[0]] = id;
      if (graph[id].op == Op::Cos) cosine_of[graph[id].args[0]] = id;
    }
    for (const auto& [argument, sine] : sine_of) {
      const auto cosine = cosine_of.find(argument);
      if (cosine == cosine_of.end()) continue;
      partner_[sine] = cosine->second;
      partner_[cosine->second] = sine;
    }
  }

  /// The cosine of a sine's argument or the other way round, if both are needed.
  std::optional<NodeId> partner(NodeId id) const {
    const auto found = partner_.find(id);
    return found == partner_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::unordered_map<NodeId, NodeId> partner_;
};

}  // namespace

Tape compile(const Graph& graph, std::span<const NodeId> outputs, Powers powers) {
  std::vector<NodeId> roots(outputs.begin(), outputs.end());
  const Graph lowered = lower(graph, roots, powers);
  const std::vector<bool> needed = reachable(lowered, roots);
  Tape tape;
  Allocator allocator(lowered, needed, roots);
  const SinCosPairs pairs(lowered, needed);
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    if (arity(lowered[id].op) == 0) {
      allocator.place_leaf(id, tape);
      continue;
    }
    const std::optional<NodeId> partner = pairs.partner(id);
    if (partner && *partner < id) {  // computed with its partner
      allocator.skip(id);
      continue;
    }
    Instruction instruction = allocator.place(id, tape);
    if (partner) {
      instruction.cosine = allocator.place_beside(*partner, tape);
      if (instruction.op == Op::Cos) std::swap(instruction.out, *instruction.cosine);
      instruction.op = Op::Sin;
    }
    switch (instruction.out.rate) {
      case Rate::Constant:
        break;  // constants have been folded
      case Rate::U:
        tape.of_u.push_back(instruction);
        break;
      case Rate::V:
        tape.of_v.push_back(instruction);
        break;
      case Rate::Both:
        tape.of_both.push_back(instruction);
        break;
    }
  }
  for (const NodeId root : roots) tape.outputs.push_back(allocator.slot(root));
  return tape;
}

Tape first_outputs(const Tape& tape, std::size_t count) {
  Tape result = tape;
  result.outputs.resize(count);
  // Slots are used again: what is needed of one is what was last written there.
  std::array<std::vector<bool>, 4> needed = {
      std::vector<bool>(tape.constants.size()), std::vector<bool>(tape.slots_u),
      std::vector<bool>(tape.slots_v), std::vector<bool>(tape.slots_both)};
  const auto is_needed = [&needed](const Slot& slot) {
    return needed[static_cast<std::size_t>(slot.rate)][slot.index];
  };
  for (const Slot& slot : result.outputs) is_needed(slot) = true;
  for (auto* const instructions : {&result.of_both, &result.of_v, &result.of_u}) {
    std::vector<Instruction> kept;
    for (auto at = instructions->rbegin(); at != instructions->rend(); ++at) {
      if (!is_needed(at->out) && !(at->cosine && is_needed(*at->cosine))) continue;
      is_needed(at->out) = false;
      if (at->cosine) is_needed(*at->cosine) = false;
      for (int i = 0; i < arity(at->op); ++i) is_needed(at->in[static_cast<std::size_t>(i)]) = true;
      kept.push_back(*at);
    }
    instructions->assign(kept.rbegin(), kept.rend());
  }
  return result;
}

}  // namespace saddle
