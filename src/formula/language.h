// The names of the language, from the table of operations.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formula/expression.h"

namespace saddle {

/// A function that formulas can call.
struct BuiltIn {
  std::string_view name;
  int min_arguments = 1;
  int max_arguments = 1;  ///< kAnyNumber: no limit
  std::string_view help;
};
inline constexpr int kAnyNumber = 1 << 20;

/// The function of that name, or nullptr. `diff` is among them.
const BuiltIn* find_built_in(std::string_view name);

/// A call of a function other than diff. The number of arguments is right.
Expression call_built_in(const BuiltIn& function, std::span<const Expression> arguments);

/// The value of a constant of the language.
std::optional<double> find_constant(std::string_view name);

/// Names of all functions, and of all constants, in the order of the table.
std::vector<std::string> function_names();
std::vector<std::string> constant_names();

/// The name used here for a name of another program or of school: "arctan" -> "atan".
std::optional<std::string> known_elsewhere_as(std::string_view name);

/// One line for each operator, function and constant, under headings: the text of
/// `saddle --help functions`, and by tests/style/language.py the tables of docs/LANGUAGE.md.
std::string language_help();

}  // namespace saddle
