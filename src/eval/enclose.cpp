#include "eval/enclose.h"

#include <cassert>

namespace saddle {
Interval enclose(Op op, [[maybe_unused]] const Interval& a, [[maybe_unused]] const Interval& b,
                 [[maybe_unused]] const Interval& c) {
  switch (op) {
    case Op::Constant:
    case Op::Variable:
      break;
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, interval, ...) \
  case Op::id:                                                               \
    return interval;
#include "formula/ops.def"
  }
  assert(false && "leaves are not applied");
  return kUndefined;
}

Enclosure::Enclosure(const Tape& tape) {
  banks_ = {0, static_cast<std::uint32_t>(tape.constants.size()), 0, 0};
  banks_[2] = banks_[1] + tape.slots_u;
  banks_[3] = banks_[2] + tape.slots_v;
  slots_.resize(banks_[3] + tape.slots_both);
  for (std::size_t i = 0; i < tape.constants.size(); ++i) {
    slots_[i] = constant_interval(tape.constants[i]);
  }
  append(tape.of_u);
  append(tape.of_v);
  append(tape.of_both);
  for (const Slot slot : tape.outputs) outputs_.push_back(place(slot));
}

std::uint32_t Enclosure::place(Slot slot) const {
  return banks_[static_cast<std::size_t>(slot.rate)] + slot.index;
}

void Enclosure::append(std::span<const Instruction> instructions) {
  for (const Instruction& instruction : instructions) {
    Step step = {instruction.op, false, place(instruction.out), {}};
    for (int i = 0; i < arity(step.op); ++i) step.in[i] = place(instruction.in[i]);
    const Interval& exponent = slots_[step.in[1]];
    const bool constant = instruction.in[1].rate == Rate::Constant && is_point(exponent);
    step.square = (step.op == Op::Mul && step.in[0] == step.in[1]) ||
                  (step.op == Op::Pow && constant && exponent.low == 2);
    steps_.push_back(step);
    if (!instruction.cosine) continue;
    step.op = Op::Cos;
    step.out = place(*instruction.cosine);
    steps_.push_back(step);
  }
}

void Enclosure::operator()(const Interval& u, const Interval& v, std::span<Interval> outputs) {
  assert(outputs.size() == outputs_.size());
  Interval* const slots = slots_.data();
  slots[place({Rate::U, 0})] = u;
  slots[place({Rate::V, 0})] = v;
  for (const Step& step : steps_) {
    const Interval& a = slots[step.in[0]];
    slots[step.out] =
        step.square ? sqr(a) : enclose(step.op, a, slots[step.in[1]], slots[step.in[2]]);
  }
  for (std::size_t k = 0; k < outputs_.size(); ++k) outputs[k] = slots[outputs_[k]];
}

void enclose(const Tape& tape, const Interval& u, const Interval& v, std::span<Interval> outputs) {
  Enclosure enclosure(tape);
  enclosure(u, v, outputs);
}

Interval mean_value(const Interval& natural, const Interval& at_middle, const Interval& slope_u,
                    const Interval& offset_u, const Interval& slope_v, const Interval& offset_v) {
  const bool smooth = natural.defined == Defined::Yes && natural.continuous &&
                      at_middle.defined == Defined::Yes && slope_u.defined == Defined::Yes &&
                      slope_v.defined == Defined::Yes;
  if (!smooth) return natural;
  const Interval near = at_middle + slope_u * offset_u + slope_v * offset_v;
  Interval r = natural;
  r.low = std::max(natural.low, near.low);
  r.high = std::min(natural.high, near.high);
  return r;
}

}  // namespace saddle
