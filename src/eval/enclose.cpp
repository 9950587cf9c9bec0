#include "eval/enclose.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <optional>
#include <utility>

#include "formula/operations.h"

namespace saddle {
namespace {

/// Ranges of a parameter whose values are kept, all that a grid has in most cases; with the values
/// of a long formula they take some megabytes. At first there is room for few: most boxes that are
/// no cells have ranges of their own.
constexpr std::size_t kMostRanges = 1024;
constexpr std::size_t kFirstRanges = 16;
/// The cost of a special function in additions.
constexpr std::size_t kSpecialSteps = 30;

std::size_t hash_of(const Interval& range) {
  constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio
  const auto low = std::bit_cast<std::uint64_t>(range.low);
  const auto high = std::bit_cast<std::uint64_t>(range.high);
  // Halves of halves end in zeros, which a product keeps: first their upper bits go below.
  const auto folded = [](std::uint64_t bits) { return bits ^ (bits >> 32U); };
  return ((folded(low) * kSpread ^ folded(high)) * kSpread) >> 32U;
}

/// The values that slots hold at one step of a tape. A slot may hold several, one after another.
class ValuesOfSlots {
 public:
  explicit ValuesOfSlots(std::span<const Interval> slots) : now_(slots.size()) {
    for (const Interval& slot : slots) {
      now_[values_.size()] = values_.size();
      values_.push_back({std::nullopt, {}, slot});
    }
  }

  void write(Op op, const std::array<std::uint32_t, 3>& in, std::uint32_t out) {
    Value value{op, {}, kUndefined};
    for (int k = 0; k < arity(op); ++k) value.in[k] = now_[in[k]];
    now_[out] = values_.size();
    values_.push_back(value);
  }

  /// Whether a slot holds the sign of a value, and another one a power of its size or itself: 0
  /// wherever the value is 0, and without a jump of its own.
  bool is_sign_of(std::uint32_t sign, std::uint32_t other) const {
    const Value& value = values_[now_[sign]];
    return value.op == Op::Sign && is_zero_with(now_[other], value.in[0]);
  }

 private:
  struct Value {
    std::optional<Op> op;  // nothing for constants and parameters
    std::array<std::size_t, 3> in;
    Interval constant;
  };
  bool is_zero_with(std::size_t number, std::size_t zero) const {
    if (number == zero) return true;
    const Value& value = values_[number];
    if (value.op == Op::Pow) {
      const Value& exponent = values_[value.in[1]];
      return !exponent.op && exponent.constant.low > 0 && is_zero_with(value.in[0], zero);
    }
    return (value.op == Op::Abs || value.op == Op::Sqrt) && is_zero_with(value.in[0], zero);
  }

  std::vector<std::size_t> now_;  // the value of each slot
  std::vector<Value> values_;
};

}  // namespace

Interval enclose(Op op, [[maybe_unused]] const Interval& a, [[maybe_unused]] const Interval& b,
                 [[maybe_unused]] const Interval& c) {
  switch (op) {
    case Op::Constant:
    case Op::Variable:
      break;
    case Op::Hull:
      return hull(a, b);
    case Op::Narrow:
      return narrow(a, b, c);
#define SADDLE_ARGUMENTS_1 a
#define SADDLE_ARGUMENTS_2 a, b
#define SADDLE_ARGUMENTS_3 a, b, c
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, function, ...) \
  case Op::id:                                                                         \
    return function(SADDLE_ARGUMENTS_##arity);
#include "formula/ops.def"
  }
  assert(false && "leaves are not applied");
  return kUndefined;
}

Enclosure::Enclosure(const Tape& tape, std::size_t outputs) {
  banks_ = {0, static_cast<std::uint32_t>(tape.constants.size()), 0, 0};
  banks_[2] = banks_[1] + tape.slots_u;
  banks_[3] = banks_[2] + tape.slots_v;
  slots_.resize(banks_[3] + tape.slots_both);
  for (std::size_t i = 0; i < tape.constants.size(); ++i) {
    slots_[i] = constant_interval(tape.constants[i]);
  }
  of_u_.first = banks_[1];
  of_u_.count = tape.slots_u;
  of_v_.first = banks_[2];
  of_v_.count = tape.slots_v;
  append(tape.of_u, of_u_.steps);
  append(tape.of_v, of_v_.steps);
  append(tape.of_both, of_both_);
  for (const Slot slot : std::span(tape.outputs).first(outputs)) outputs_.push_back(place(slot));
  if (outputs < tape.outputs.size()) keep_needed_steps();
  find_joined_signs();
}

/// Leaves out the steps that no output depends on. Slots are used again: what is needed of one is
/// what was last written there.
void Enclosure::keep_needed_steps() {
  std::vector<bool> is_needed(slots_.size(), false);
  for (const std::uint32_t slot : outputs_) is_needed[slot] = true;
  for (std::vector<Step>* const steps : {&of_both_, &of_v_.steps, &of_u_.steps}) {
    std::vector<Step> kept;
    for (auto step = steps->rbegin(); step != steps->rend(); ++step) {
      if (!is_needed[step->out]) continue;
      is_needed[step->out] = false;
      for (int i = 0; i < arity(step->op); ++i) is_needed[step->in[i]] = true;
      kept.push_back(*step);
    }
    steps->assign(kept.rbegin(), kept.rend());
  }
}

/// Finds products such as sign(x)*abs(x)^3. They do not jump, though one of their factors does.
void Enclosure::find_joined_signs() {
  const std::array<std::vector<Step>*, 3> all = {&of_u_.steps, &of_v_.steps, &of_both_};
  const auto has_sign = [](const auto* steps) {
    return std::ranges::count(*steps, Op::Sign, &Step::op) > 0;
  };
  if (std::ranges::none_of(all, has_sign)) return;
  ValuesOfSlots values(slots_);
  for (std::vector<Step>* const steps : all) {
    for (Step& step : *steps) {
      if (step.op == Op::Mul && values.is_sign_of(step.in[1], step.in[0]))
        std::swap(step.in[0], step.in[1]);
      step.joins = step.op == Op::Mul && values.is_sign_of(step.in[0], step.in[1]);
      values.write(step.op, step.in, step.out);
    }
  }
}

std::uint32_t Enclosure::place(Slot slot) const {
  return banks_[static_cast<std::size_t>(slot.rate)] + slot.index;
}

void Enclosure::append(std::span<const Instruction> instructions, std::vector<Step>& steps) const {
  for (const Instruction& instruction : instructions) {
    Step step = {instruction.op, false, false, place(instruction.out), {}};
    for (int i = 0; i < arity(step.op); ++i) step.in[i] = place(instruction.in[i]);
    const Interval& exponent = slots_[step.in[1]];
    const bool constant = instruction.in[1].rate == Rate::Constant && is_point(exponent);
    step.square = (step.op == Op::Mul && step.in[0] == step.in[1]) ||
                  (step.op == Op::Pow && constant && exponent.low == 2);
    steps.push_back(step);
    if (!instruction.cosine) continue;
    step.op = Op::Cos;
    step.out = place(*instruction.cosine);
    steps.push_back(step);
  }
}

Interval Enclosure::apply(const Step& step) const {
  const Interval& a = slots_[step.in[0]];
  const Interval& b = slots_[step.in[1]];
  if (step.square) return sqr(a);
  if (step.joins) {
    Interval product = a * b;
    product.continuous = b.continuous;
    return product;
  }
  // Most steps are products and sums: no calls.
  if (step.op == Op::Mul) return a * b;
  if (step.op == Op::Add) return a + b;
  if (step.op == Op::Sub) return a - b;
  return enclose(step.op, a, b, slots_[step.in[2]]);
}

void Enclosure::run(std::span<const Step> steps) {
  for (const Step& step : steps) slots_[step.out] = apply(step);
}

void Enclosure::load(const Interval& range, Bank& bank) {
  if (range.low == bank.now.low && range.high == bank.now.high) return;
  bank.now = range;
  const auto slots = std::span(slots_).subspan(bank.first, bank.count);
  if (bank.steps.empty()) {
    slots[0] = range;
    return;
  }
  if (bank.misses == bank.known.size() && bank.known.size() < kMostRanges) {
    bank.known.assign(std::max(kFirstRanges, 4 * bank.known.size()), kUndefined);
    bank.values.resize(bank.known.size() * bank.count);
    bank.misses = 0;
  }
  const std::size_t place = hash_of(range) & (bank.known.size() - 1);  // a power of 2
  const auto values = std::span(bank.values).subspan(place * bank.count, bank.count);
  Interval& known = bank.known[place];
  if (range.low == known.low && range.high == known.high) {
    std::ranges::copy(values, slots.begin());
    return;
  }
  slots[0] = range;
  run(bank.steps);
  ++bank.misses;
  known = range;
  std::ranges::copy(slots, values.begin());
}

std::size_t Enclosure::steps() const {
  std::size_t sum = 0;
  for (const auto* const steps : {&of_u_.steps, &of_v_.steps, &of_both_}) {
    for (const Step& step : *steps) sum += is_special(step.op) ? kSpecialSteps : 1;
  }
  return sum;
}

void Enclosure::operator()(const Interval& u, const Interval& v, std::span<Interval> outputs) {
  assert(outputs.size() == outputs_.size());
  load(u, of_u_);
  load(v, of_v_);
  run(of_both_);
  for (std::size_t k = 0; k < outputs_.size(); ++k) outputs[k] = slots_[outputs_[k]];
}

std::size_t Enclosure::run_counting_breaks(std::span<const Step> steps) {
  std::size_t count = 0;
  for (const Step& step : steps) {
    const auto arguments = std::span(step.in).first(static_cast<std::size_t>(arity(step.op)));
    const bool are_continuous = std::ranges::all_of(
        arguments, [&](std::uint32_t slot) { return is_continuous(slots_[slot]); });
    slots_[step.out] = apply(step);
    if (are_continuous && !is_continuous(slots_[step.out])) ++count;
  }
  return count;
}

std::size_t Enclosure::count_breaks(const Interval& u, const Interval& v) {
  const std::size_t of_u = count_breaks_of_one(0, u);
  const std::size_t of_v = count_breaks_of_one(1, v);
  return of_u + of_v + count_breaks_of_both(u, v);
}

std::size_t Enclosure::count_breaks_of_both(const Interval& u, const Interval& v) {
  load(u, of_u_);
  load(v, of_v_);
  return run_counting_breaks(of_both_);
}

std::size_t Enclosure::count_breaks_of_one(int axis, const Interval& range) {
  Bank& bank = axis == 0 ? of_u_ : of_v_;
  slots_[bank.first] = bank.now = range;
  return run_counting_breaks(bank.steps);
}

void enclose(const Tape& tape, const Interval& u, const Interval& v, std::span<Interval> outputs) {
  Enclosure enclosure(tape);
  enclosure(u, v, outputs);
}

Interval mean_value(const Interval& natural, const Interval& at_middle, const Interval& slope_u,
                    const Interval& offset_u, const Interval& slope_v, const Interval& offset_v) {
  const bool smooth = is_continuous(natural) && at_middle.defined == Defined::Yes &&
                      slope_u.defined == Defined::Yes && slope_v.defined == Defined::Yes;
  if (!smooth) return natural;
  const Interval near = at_middle + slope_u * offset_u + slope_v * offset_v;
  Interval r = natural;
  r.low = std::max(natural.low, near.low);
  r.high = std::min(natural.high, near.high);
  return r;
}

}  // namespace saddle
