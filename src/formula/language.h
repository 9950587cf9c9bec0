// The names of the language, from the table of operations.
#pragma once

#include <complex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formula/complex.h"
#include "formula/expression.h"
#include "formula/typed.h"
#include "formula/value.h"

namespace saddle {

/// A function that formulas can call, and how a call becomes nodes.
struct BuiltIn {
  std::string_view name;
  int min_arguments = 1;
  int max_arguments = 1;  ///< kAnyNumber: no limit
  std::string_view help;
  Expression (*of_real)(std::span<const Expression>) = nullptr;
  Complex (*of_complex)(std::span<const Complex>) = nullptr;  ///< nullptr: of real numbers alone
  std::optional<Op> fold = {};      ///< an operation that makes one of any number of arguments
  std::string_view signature = {};  ///< of `of_typed`: see ops.def
  Value (*of_typed)(const TypedArguments&) = nullptr;
};
inline constexpr int kAnyNumber = 1 << 20;

/// The function of that name, or nullptr. `diff` is among them.
const BuiltIn* find_built_in(std::string_view name);

/// The row of an operation.
const BuiltIn& built_in_of(Op op);

/// Whether a definition may take the name of a function: a name that the language has not always
/// had.
bool can_be_hidden(const BuiltIn& function);

/// The value of a constant of the language.
std::optional<std::complex<double>> find_constant(std::string_view name);

/// Another spelling of i, which no definition can hide.
inline constexpr std::string_view kImaginaryUnit = "ⅈ";

/// Names of all functions, and of all constants, in the order of the table.
std::vector<std::string> function_names();
std::vector<std::string> constant_names();

/// The name used here for a name of another program or of school: "arctan" -> "atan".
std::optional<std::string> known_elsewhere_as(std::string_view name);

/// One line for each operator, function and constant, under headings: the text of
/// `saddle --help functions`, and by tests/style/language.py the tables of docs/LANGUAGE.md.
std::string language_help();

}  // namespace saddle
