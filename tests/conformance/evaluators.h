// The evaluators of doubles, row by row.
#pragma once

#include <array>
#include <vector>

#include "conformance/arguments.h"
#include "eval/kernels.h"

namespace saddle::testing {

inline std::vector<double> plain_values(Op op, const std::vector<Arguments>& arguments) {
  std::vector<double> values;
  for (const auto& [a, b, c] : arguments) values.push_back(apply(op, a, b, c));
  return values;
}

inline std::vector<double> loop_values(CpuLevel level, Op op,
                                       const std::vector<Arguments>& arguments) {
  std::array<std::vector<double>, 3> columns;
  for (const auto& [a, b, c] : arguments) {
    columns[0].push_back(a);
    columns[1].push_back(b);
    columns[2].push_back(c);
  }
  std::array<Operand, 3> operands;
  for (std::size_t i = 0; i < 3; ++i) operands[i] = {columns[i].data(), true};
  std::vector<double> values(arguments.size());
  kernels(level)[op](values.data(), operands.data(), values.size());
  return values;
}

}  // namespace saddle::testing
