#include "mesh/sizing/effort.h"

#include "eval/enclose.h"
#include "formula/operations.h"

namespace saddle {

namespace {

/// Times in places without their formula, which take 270 ns: an operation of a formula there, a
/// look without its formula, and a step of an Enclosure.
constexpr double kOperation = 0.00107;
constexpr double kLook = 0.0741;
constexpr double kStep = 0.0185;
/// Operations that a call of a function takes as long as.
constexpr double kCall = 25;

double count_operations(const Tape& tape) {
  double sum = 0;
  for (const auto* const part : {&tape.of_u, &tape.of_v, &tape.of_both}) {
    for (const Instruction& instruction : *part)
      sum += row_of(instruction.op).kind == Kind::Arithmetic ? 1 : kCall;
  }
  return sum;
}

}  // namespace

Effort::Effort(const Surface& surface)
    : place_(1 + kOperation * count_operations(surface.tangents)),
      look_(kLook + kStep * static_cast<double>(Enclosure(surface.bounds, 3).steps())),
      count_(surface.tangents.count) {}

}  // namespace saddle
