// The grammar: the tokens of a formula as the steps of a stack machine. It is muparser's grammar;
// its byte code is read here, and muparser is thrown away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "formula/graph.h"
#include "formula/lexer.h"
#include "formula/syntax.h"

namespace saddle {

/// One step; it takes its operands from the stack and leaves one result there.
struct Step {
  enum class Kind : std::uint8_t {
    Operand,    ///< a number or a name; or a sum or product over an index, as its name
    Operation,  ///< `op` of as many operands as its arity
    Not,
    Call,      ///< of the name at `token`, with `count` arguments
    Vector,    ///< of `count` components, in the bracket at `token`
    Component  ///< .x, or several after each other, from `token` on
  };
  Kind kind = Kind::Operand;
  Op op = Op::Constant;
  std::size_t token = 0;
  std::size_t count = 0;
};

/// The steps of the tokens in `range`. Throws Error (Input) for what the grammar lacks.
std::vector<Step> compile_steps(const FormulaText& formula, const std::vector<Token>& tokens,
                                const Brackets& brackets, TokenRange range);

}  // namespace saddle
