// The definitions of the user: names and their formulas.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "formula/graph.h"
#include "formula/lexer.h"
#include "formula/value.h"

namespace saddle {

/// `name = text`, or `name(arguments) = text` for a helper function, as the user wrote it.
struct Definition {
  std::string name;
  std::string text;
  std::vector<std::string> arguments = {};
  bool is_function = false;
  bool own = false;  ///< of one surface: there it hides a shared one of the same name
  /// A parameter's variable that Scope::bind() leaves in place, for code that runs elsewhere; from
  /// kFirstKeptSymbol on.
  std::optional<Symbol> kept = {};
};

/// No graph makes so many variables of its own.
inline constexpr Symbol kFirstKeptSymbol = Symbol{1} << 24;

/// How a definition is shown in messages: "r", or "f(s, t)".
std::string display_name(const Definition& definition);

/// Its text as a formula.
FormulaText formula_of(const Definition& definition);

/// An error about the name of a definition, not about its formula.
Error name_error(const Definition& definition, std::string message, std::string hint);

/// Throws Error (Input) if no scene can have this definition, whatever else it has: it defines u,
/// v, t or a function of the language, or two of its arguments have one name.
void check_names(const Definition& definition);

/// A name that means a place: x, y, z, and xyz for all of them.
bool is_coordinate(std::string_view name);

/// Throws TypeError unless a coordinate is real, and xyz a vector of 3.
void check_type(const Value& value, const Definition& definition);

/// Whether the formula differentiates: its arguments must then be variables.
bool has_diff(const Definition& definition);

}  // namespace saddle
