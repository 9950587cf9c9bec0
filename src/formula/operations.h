// The columns of the table of operations, other than how an operation is computed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "formula/graph.h"

namespace saddle {

/// How much an operation takes, as a number and as bounds.
enum class Kind : std::uint8_t {
  Arithmetic,  ///< an instruction of the processor, or a few
  Elementary,  ///< a call of a function
  Special,     ///< a call of one whose bounds are made of series
  OfOrder      ///< the same; its first argument is a whole constant, the order
};

/// Where an operation is infinite though its arguments are not.
enum class Infinite : std::uint8_t {
  Never,     ///< or at rare arguments only, as cosh beyond 710
  AtPoles,   ///< Div by a constant and Pow to one that is at least 0 have none
  Overflows  ///< the result outgrows doubles
};

/// A row of the table.
struct Operation {
  Op op;
  const char* id;
  const char* name;      ///< in formulas; "" for operations that only derivatives produce
  const char* function;  ///< in C++
  int arity;
  double ulps;
  Kind kind;
  Infinite infinite;
};

inline constexpr std::array kOperations = {
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, function, kind, infinite, \
                  ...)                                                                            \
  Operation{Op::id, #id, name, #function, arity, ulps, Kind::kind, Infinite::infinite},
#include "formula/ops.def"
};

/// Whether an operation has a row: leaves and the operations of enclosures alone have none.
inline bool has_row(Op op) {
  return op >= kOperations[0].op;
}

/// The row of an operation that has one.
inline const Operation& row_of(Op op) {
  return kOperations[static_cast<std::size_t>(op) - static_cast<std::size_t>(kOperations[0].op)];
}

inline bool takes_an_order(Op op) {
  return row_of(op).kind == Kind::OfOrder;
}

/// Whether the bounds of an operation take much longer than those of most.
inline bool is_special(Op op) {
  return has_row(op) && (row_of(op).kind == Kind::Special || takes_an_order(op));
}

/// A row's text in another language, with the words a, b and c replaced by the arguments.
std::string with_arguments(std::string_view text, const std::array<std::string, 3>& arguments);

}  // namespace saddle
