#include "formula/syntax.h"

#include <optional>
#include <string_view>

namespace saddle {
namespace {

bool ends_operand(const Token& token) {
  return token.kind == TokenKind::Number || token.kind == TokenKind::Name ||
         token.kind == TokenKind::Close;
}

bool begins_operand(const Token& token) {
  return token.kind == TokenKind::Number || token.kind == TokenKind::Name ||
         token.kind == TokenKind::Open;
}

/// The characters that a token was written with.
std::string written(const FormulaText& formula, const Token& token) {
  return formula.text.substr(token.span.begin, token.span.end - token.span.begin);
}

/// A number of digits alone, without a point or an exponent.
bool is_digits(const Token& token) {
  return token.kind == TokenKind::Number && !token.text.empty() &&
         token.text.find_first_not_of("0123456789") == std::string::npos;
}

/// 1 000: digits in groups of three.
bool is_grouped(const Token& left, const Token& right) {
  return is_digits(left) && left.text.size() <= 3 && is_digits(right) && right.text.size() == 3;
}

[[noreturn]] void refuse_neighbours(const FormulaText& formula, const Token& left,
                                    const Token& right) {
  const Span span = {left.span.begin, right.span.end};
  if (is_grouped(left, right)) {
    throw formula.error("a space inside a number", span, "write " + left.text + right.text);
  }
  // A superscript is a number without a text of its own.
  const bool brackets =
      left.kind == TokenKind::Close || right.kind == TokenKind::Open || left.text.empty();
  const std::string hint = brackets
                               ? "write a * between them"
                               : "write " + written(formula, left) + "*" + written(formula, right);
  throw formula.error("an operator is missing", span, hint);
}

[[noreturn]] void refuse_comma(const FormulaText& formula, const std::vector<Token>& tokens,
                               std::size_t comma) {
  if (is_decimal_comma(tokens, comma)) {
    const Token& left = tokens[comma - 1];
    const Token& right = tokens[comma + 1];
    throw formula.error("a decimal comma", {left.span.begin, right.span.end},
                        "write " + left.text + "." + right.text);
  }
  throw formula.error("two results in one formula", tokens[comma].span,
                      formula.name +
                          " takes one formula; a comma only separates the arguments of "
                          "a function, and a decimal point is '.'");
}

}  // namespace

Calls find_calls(const std::vector<Token>& tokens) {
  Calls calls;
  calls.is_call.resize(tokens.size(), false);
  std::vector<std::optional<std::size_t>> open;  // for each open bracket, the name it calls
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::Open) {
      const bool called = i > 0 && tokens[i - 1].kind == TokenKind::Name;
      if (called) calls.is_call[i - 1] = true;
      open.push_back(called ? std::optional(i - 1) : std::nullopt);
    } else if (tokens[i].kind == TokenKind::Close) {
      if (open.back()) calls.by_closing.push_back(*open.back());
      open.pop_back();
    }
  }
  return calls;
}

void explain_slips(const FormulaText& formula, const std::vector<Token>& tokens,
                   const Calls& calls) {
  std::vector<bool> in_call;  // for each open bracket
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool after_call = i > 0 && calls.is_call[i - 1];
    if (i > 0 && !after_call && ends_operand(tokens[i - 1]) && begins_operand(tokens[i])) {
      refuse_neighbours(formula, tokens[i - 1], tokens[i]);
    }
    const bool power = tokens[i].text == "^" && tokens[i].kind == TokenKind::Operator;
    if (power && i > 0 && tokens[i - 1].kind == TokenKind::Number && tokens[i - 1].text.empty()) {
      throw formula.error("a power of a superscript",
                          {tokens[i - 1].span.begin, tokens[i].span.end},
                          "write (u^2)^3 or u^(2^3)");
    }
    const bool close = tokens[i].kind == TokenKind::Close;
    if (close && tokens[i - 1].kind == TokenKind::Open) {
      throw formula.error("an operand is missing here", tokens[i].span, kMissingOperandHint);
    }
    if (tokens[i].kind == TokenKind::Open) in_call.push_back(after_call);
    if (close) in_call.pop_back();
    if (tokens[i].kind == TokenKind::Comma && (in_call.empty() || !in_call.back())) {
      refuse_comma(formula, tokens, i);
    }
  }
}

bool is_decimal_comma(const std::vector<Token>& tokens, std::size_t comma) {
  if (comma == 0 || comma + 1 >= tokens.size()) return false;
  const Token& left = tokens[comma - 1];
  const Token& right = tokens[comma + 1];
  return is_digits(left) && is_digits(right) && left.span.end == tokens[comma].span.begin &&
         tokens[comma].span.end == right.span.begin;
}

}  // namespace saddle
