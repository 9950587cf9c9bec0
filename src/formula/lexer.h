// A formula's text as tokens with their places. The usual ways to write * and ^ on paper or in
// other programs are understood here: 2u, 3(u+1), u**2, π, ², ·, ×, −, –, ≤, and names in Greek.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace saddle {

/// The formula `text[part]`, called `name` in messages.
struct FormulaText {
  std::string name;
  std::string text;
  Span part;

  /// An Error (Input) whose caret points at `span` of the text.
  Error error(std::string message, Span span, std::string hint = {}) const;
};

enum class TokenKind { Number, Name, Operator, Open, Close, Comma, Component };

struct Token {
  TokenKind kind;
  std::string text;  ///< a name, .x, or an operator as muparser spells it
  double value = 0;  ///< of a number
  Span span;         ///< bytes of FormulaText::text; empty for a * that is only understood
};

/// Bytes of the name that `text` begins with, 0 if it begins with none.
std::size_t name_length(std::string_view text);

/// A name: letters, digits and _, no digit first. Greek letters are letters; `π` is a whole name,
/// so that in `πu` an operator is missing.
bool is_name(std::string_view text);

/// The names in a text, as formulas mean them.
std::set<std::string> names_in(std::string_view text);

/// The name that a written one stands for: `π`, `τ` and `φ` are `pi`, `tau` and `phi`, any other
/// stands for itself.
std::string meant_name(std::string_view written);

/// Longest formula in bytes, and deepest nesting of brackets: enough for anything written by hand
/// or by a program in good faith, and little enough that no later step can be made to run away.
inline constexpr std::size_t kMaxFormulaLength = 65536;
inline constexpr int kMaxNesting = 256;

/// Throws Error (Input): a character that no formula has, brackets that do not match, a formula
/// that is empty, too long or too deep.
std::vector<Token> tokenize(const FormulaText& formula);

}  // namespace saddle
