// One formula from text to graph. The grammar is muparser's: its byte code is lifted into the
// graph and muparser is thrown away. Names are resolved here, not by muparser, so that every error
// points at its characters.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/graph.h"
#include "formula/lexer.h"

namespace saddle {

/// A user's function: its body as a node in which the arguments are variables of its own.
struct HelperFunction {
  std::string name;
  std::vector<Symbol> arguments;
  NodeId body = 0;
};

/// The meaning of names where the formula stands.
struct Names {
  /// The node of a variable, constant or definition; nothing if there is none of that name.
  std::function<std::optional<NodeId>(std::string_view)> variable;
  /// The user's function of that name, or nullptr; the language's own are known to the parser.
  std::function<const HelperFunction*(std::string_view)> function;
  /// All names that `variable` and `function` know, for suggestions.
  std::function<std::vector<std::string>()> known_variables;
  std::function<std::vector<std::string>()> known_functions;
};

/// Most operations that a graph may hold. Helper functions that call each other can make a short
/// text explode; every surface known to us stays below ten thousand.
inline constexpr std::size_t kMaxOperations = 250'000;

/// Parses `formula` into `graph`. Throws Error (Input) with the place and a way out.
NodeId parse_formula(Graph& graph, const FormulaText& formula, const Names& names);

}  // namespace saddle
