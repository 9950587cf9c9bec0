// Mistakes that people make in formulas, found in the tokens and explained in their words. The
// grammar finds the others.
#pragma once

#include <string_view>
#include <vector>

#include "formula/lexer.h"

namespace saddle {

/// Where the tokens belong together.
struct Calls {
  /// For each token: whether it is a name that is called, f in f(...).
  std::vector<bool> is_call;
  /// Indices of the called names in the order in which their brackets close: the order in which
  /// a stack machine executes the calls.
  std::vector<std::size_t> by_closing;
};

Calls find_calls(const std::vector<Token>& tokens);

/// The way out where an operand is missing.
inline constexpr const char* kMissingOperandHint = "add a number, a name or a bracket";

/// Throws Error (Input) for two operands side by side (`u v`, `2 3`), empty brackets, a comma
/// outside of a call (a decimal comma, two results).
void explain_slips(const FormulaText& formula, const std::vector<Token>& tokens,
                   const Calls& calls);

/// True if the tokens at `comma` are digits, a comma and digits without a space: 0,5.
bool is_decimal_comma(const std::vector<Token>& tokens, std::size_t comma);

}  // namespace saddle
