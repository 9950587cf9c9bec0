// Mistakes that people make in formulas, found in the tokens and explained in their words. The
// grammar finds the others.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "formula/lexer.h"

namespace saddle {

/// Indices of tokens, [begin, end).
struct TokenRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A sum or product over an index: sum(BODY, INDEX=LOW:HIGH).
struct Series {
  std::size_t name = 0;  ///< the token `sum` or `prod`
  std::size_t index = 0;
  TokenRange body, low, high;
  std::size_t close = 0;  ///< its closing bracket
};

/// Which tokens belong together.
struct Brackets {
  std::vector<bool> is_call;          ///< for each token: it is a name that is called, f in f(...)
  std::vector<bool> is_vector;        ///< an opening bracket of a vector: (a, b)
  std::vector<std::size_t> open_of;   ///< of a closing bracket
  std::vector<std::size_t> close_of;  ///< of an opening bracket
  std::vector<Series> series;         ///< in the order of their names

  /// The one that begins at a token, or nullptr.
  const Series* series_of(std::size_t token) const;
};

/// Makes tube(c,u,1,v) of a helper function c into tube(c(u),u,1,v), and so for frame(c,u). The new
/// tokens have the place of c. `is_helper`: whether a name is that of a helper function alone.
void call_curves(std::vector<Token>& tokens,
                 const std::function<bool(const std::string&)>& is_helper);

/// `is_series`: whether a called name takes an index. Throws Error (Input): an index without a
/// range.
Brackets find_brackets(const FormulaText& formula, const std::vector<Token>& tokens,
                       const std::function<bool(const std::string&)>& is_series);

/// The way out where an operand is missing.
inline constexpr const char* kMissingOperandHint = "add a number, a name or a bracket";

/// Throws Error (Input) for two operands side by side (`u v`, `2 3`), empty brackets, a comma
/// outside of brackets (a decimal comma, two results), an assignment, a factorial.
void explain_slips(const FormulaText& formula, const std::vector<Token>& tokens,
                   const Brackets& brackets);

/// `hint`, after "a decimal comma? write 0.5" if there are digits, a comma and digits without a
/// space among the tokens from `first` to `last`.
std::string hint_beside_comma(const std::vector<Token>& tokens, std::size_t first, std::size_t last,
                              const std::string& hint);

/// The message of an unknown name begins so; the name and a `'` follow.
inline constexpr std::string_view kUnknownName = "unknown name '";

/// The error for a name right behind a number that is a unit; nothing for another name.
std::optional<Error> unit_behind_number(const FormulaText& formula,
                                        const std::vector<Token>& tokens, const Token& name);

/// The name that an error says is unknown, if a parameter of that name would mend it.
std::optional<std::string> undefined_name(const Error& error);

}  // namespace saddle
