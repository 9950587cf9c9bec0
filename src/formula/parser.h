// One formula from text to graph. formula/program.h has the grammar; names and types are resolved
// here, so that every error points at its characters.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formula/graph.h"
#include "formula/lexer.h"
#include "formula/space.h"
#include "formula/value.h"

namespace saddle {

/// A user's function.
struct HelperFunction {
  std::string name;
  std::size_t argument_count = 0;
  /// Its value for arguments of any type.
  std::function<Value(std::span<const Value>)> call;
};

/// Terms that the sums and products over an index of all formulas may have together: more than any
/// series needs that converges, and few enough to be unrolled in a moment.
inline constexpr std::size_t kMaxTerms = 20'000;

/// Counts and notes that all formulas of a scope share.
struct Unrolled {
  std::size_t terms = 0;       ///< of sums and products over an index
  std::set<Symbol> exponents;  ///< parameters that whole powers of complex numbers were made by
};

/// The meaning of names where the formula stands.
struct Names {
  /// A variable, constant or definition; nothing if there is none of that name.
  std::function<std::optional<Value>(std::string_view)> variable;
  /// The user's function of that name, or nullptr; the language's own are known to the parser.
  std::function<const HelperFunction*(std::string_view)> function;
  /// All names that `variable` and `function` know, for suggestions.
  std::function<std::vector<std::string>()> known_variables;
  std::function<std::vector<std::string>()> known_functions;
  /// The value of a node of parameters alone; nothing for another one.
  std::function<std::optional<double>(NodeId)> parameter_value;
  Sampler sampler;  ///< of the surface's domain
  Unrolled* unrolled = nullptr;
};

/// Most operations that a graph may hold. Helper functions that call each other can make a short
/// text explode; every surface known to us stays below ten thousand.
inline constexpr std::size_t kMaxOperations = 100'000;

/// An Error (Input): operands whose types do not go together, or a bound that is no constant.
class TypeError : public Error {
 public:
  explicit TypeError(const Error& error) : Error(error) {}
};

/// Parses `formula` into `graph`. Throws Error (Input) with the place and a way out.
Value parse_formula(Graph& graph, const FormulaText& formula, const Names& names);

/// The node of a real number. Throws TypeError for another type: `z is complex`.
NodeId require_real(const Value& value, const FormulaText& formula);

}  // namespace saddle
