#include "formula/syntax.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace saddle {
namespace {

constexpr std::string_view kAssignment = "=";

bool ends_operand(const Token& token) {
  return token.kind == TokenKind::Number || token.kind == TokenKind::Name ||
         token.kind == TokenKind::Close || token.kind == TokenKind::Component;
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

/// Digits, a comma and digits without a space: 0,5.
bool is_decimal_comma(const std::vector<Token>& tokens, std::size_t comma) {
  if (comma == 0 || comma + 1 >= tokens.size()) return false;
  const Token& left = tokens[comma - 1];
  const Token& right = tokens[comma + 1];
  return is_digits(left) && is_digits(right) && left.span.end == tokens[comma].span.begin &&
         tokens[comma].span.end == right.span.begin;
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

/// The range of `n=A:B`, which begins behind the '='.
void read_index_range(const FormulaText& formula, const std::vector<Token>& tokens,
                      Series& series) {
  int depth = 0;
  int questions = 0;
  for (std::size_t i = series.index + 2; i < series.close; ++i) {
    if (tokens[i].kind == TokenKind::Open) ++depth;
    if (tokens[i].kind == TokenKind::Close) --depth;
    if (depth == 0 && tokens[i].text == "?") ++questions;
    if (depth != 0 || tokens[i].text != ":" || questions-- > 0) continue;
    series.low = {series.index + 2, i};
    series.high = {i + 1, series.close};
    return;
  }
  const std::string index = tokens[series.index].text;
  throw formula.error("the index " + index + " has no range",
                      {tokens[series.index].span.begin, tokens[series.close - 1].span.end},
                      "write " + index + "=1:20, from the first to the last");
}

/// The series in the brackets behind the name at `name`, if their last part is `n=A:B`.
std::optional<Series> read_series(const FormulaText& formula, const std::vector<Token>& tokens,
                                  std::size_t name, const std::vector<std::size_t>& commas,
                                  std::size_t close) {
  if (commas.empty()) return std::nullopt;
  Series series;
  series.name = name;
  series.index = commas.back() + 1;
  series.close = close;
  const bool has_index =
      tokens[series.index].kind == TokenKind::Name && tokens[series.index + 1].text == kAssignment;
  if (!has_index) return std::nullopt;
  if (commas.size() > 1) {
    throw formula.error("'" + tokens[name].text + "' over an index takes one expression",
                        tokens[name].span, "write " + tokens[name].text + "(EXPRESSION, n=1:20)");
  }
  series.body = {name + 2, commas[0]};
  read_index_range(formula, tokens, series);
  for (const TokenRange& part : {series.body, series.low, series.high}) {
    if (part.begin < part.end) continue;
    throw formula.error("an operand is missing here", tokens[part.end].span, kMissingOperandHint);
  }
  return series;
}

/// An operator where the language has none of that name.
void refuse_operator(const FormulaText& formula, const std::vector<Token>& tokens, std::size_t i,
                     const Brackets& brackets) {
  if (tokens[i].kind != TokenKind::Operator) return;
  const bool follows_operand = i > 0 && ends_operand(tokens[i - 1]);
  if (tokens[i].text == "!" && follows_operand) {
    const std::string n = tokens[i - 1].kind == TokenKind::Close ? "n" : tokens[i - 1].text;
    throw formula.error("a factorial", tokens[i].span,
                        "write gamma(" + n + "+1); unequal is !=, 'not a' is !a");
  }
  const auto is_index = [&](const Series& series) { return series.index + 1 == i; };
  if (tokens[i].text == kAssignment && std::ranges::none_of(brackets.series, is_index)) {
    throw formula.error("an assignment inside a formula", tokens[i].span,
                        "to compare, write ==; an index stands last in sum(..., n=1:20)");
  }
}

/// A unit that people write behind numbers, and the factor that makes a formula's number of one.
struct Unit {
  std::string_view name;
  std::string_view factor = {};  ///< empty: there is none
};

constexpr std::string_view kDegree = "*pi/180";
constexpr std::array kUnits = {Unit{"deg", kDegree},
                               Unit{"degree", kDegree},
                               Unit{"degrees", kDegree},
                               Unit{"rad"},
                               Unit{"mm"},
                               Unit{"cm"},
                               Unit{"km"},
                               Unit{"um"},
                               Unit{"in"},
                               Unit{"inch"},
                               Unit{"px"},
                               Unit{"ms"},
                               Unit{"sec"},
                               Unit{"fps"},
                               Unit{"m"},
                               Unit{"s"}};

/// Names that formulas have without a definition.
constexpr std::array<std::string_view, 7> kOwnNames = {"u", "v", "t", "x", "y", "z", "xyz"};

}  // namespace

const Series* Brackets::series_of(std::size_t token) const {
  const auto found = std::ranges::lower_bound(series, token, {}, &Series::name);
  return found != series.end() && found->name == token ? &*found : nullptr;
}

void call_curves(std::vector<Token>& tokens,
                 const std::function<bool(const std::string&)>& is_helper) {
  const auto is = [&](std::size_t i, TokenKind kind) {
    return i < tokens.size() && tokens[i].kind == kind;
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& name = tokens[i].text;
    const bool takes_curve = is(i, TokenKind::Name) && (name == "tube" || name == "frame");
    if (!takes_curve || is_helper(name)) continue;
    const bool is_bare = is(i + 1, TokenKind::Open) && is(i + 2, TokenKind::Name) &&
                         is(i + 3, TokenKind::Comma) && is(i + 4, TokenKind::Name) &&
                         (is(i + 5, TokenKind::Comma) || is(i + 5, TokenKind::Close));
    if (!is_bare || !is_helper(tokens[i + 2].text)) continue;
    const Span place = tokens[i + 2].span;
    const std::array added = {Token{TokenKind::Open, "(", 0, place},
                              Token{TokenKind::Name, tokens[i + 4].text, 0, place},
                              Token{TokenKind::Close, ")", 0, place}};
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 3, added.begin(), added.end());
  }
}

Brackets find_brackets(const FormulaText& formula, const std::vector<Token>& tokens,
                       const std::function<bool(const std::string&)>& is_series) {
  Brackets result;
  result.is_call.resize(tokens.size(), false);
  result.is_vector.resize(tokens.size(), false);
  result.open_of.resize(tokens.size(), 0);
  result.close_of.resize(tokens.size(), 0);
  struct Open {
    std::size_t at;
    std::vector<std::size_t> commas;
  };
  std::vector<Open> open;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::Comma && !open.empty()) open.back().commas.push_back(i);
    if (tokens[i].kind == TokenKind::Open) {
      if (i > 0 && tokens[i - 1].kind == TokenKind::Name) result.is_call[i - 1] = true;
      open.push_back({i, {}});
    }
    if (tokens[i].kind != TokenKind::Close) continue;
    const auto [at, commas] = open.back();
    open.pop_back();
    result.open_of[i] = at;
    result.close_of[at] = i;
    const bool is_called = at > 0 && result.is_call[at - 1];
    result.is_vector[at] = !is_called && !commas.empty();
    if (!is_called || !is_series(tokens[at - 1].text)) continue;
    if (const auto series = read_series(formula, tokens, at - 1, commas, i)) {
      result.series.push_back(*series);
    }
  }
  std::ranges::sort(result.series, {}, &Series::name);
  return result;
}

void explain_slips(const FormulaText& formula, const std::vector<Token>& tokens,
                   const Brackets& brackets) {
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool after_call = i > 0 && brackets.is_call[i - 1];
    refuse_operator(formula, tokens, i, brackets);
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
    if (tokens[i].kind == TokenKind::Open) ++depth;
    if (close) --depth;
    if (tokens[i].kind == TokenKind::Comma && depth == 0) refuse_comma(formula, tokens, i);
  }
}

std::string hint_beside_comma(const std::vector<Token>& tokens, std::size_t first, std::size_t last,
                              const std::string& hint) {
  for (std::size_t i = first; i <= last && i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::Comma || !is_decimal_comma(tokens, i)) continue;
    const std::string point = tokens[i - 1].text + "." + tokens[i + 1].text;
    return "a decimal comma? write " + point + (hint.empty() ? "" : "; or " + hint);
  }
  return hint;
}

std::optional<Error> unit_behind_number(const FormulaText& formula,
                                        const std::vector<Token>& tokens, const Token& name) {
  const auto is_before = [&](const Token& token) {
    return token.kind == TokenKind::Number && token.span.end == name.span.begin;
  };
  const auto number = std::ranges::find_if(tokens, is_before);
  const auto unit = std::ranges::find(kUnits, name.text, &Unit::name);
  if (number == tokens.end() || unit == kUnits.end()) return std::nullopt;
  const bool is_option = formula.name.starts_with("--");
  const bool is_value = is_option || formula.name.find(": ") != std::string::npos;
  // A letter behind a number of a formula is rather a parameter: 3m*u.
  if (name.text.size() == 1 && !is_value) return std::nullopt;
  std::string hint = "write " + number->text;
  if (is_option) {
    hint = "saddle --help " + formula.name.substr(2) + " says in which unit the number is";
  } else if (!is_value && !unit->factor.empty()) {
    hint = "angles are in radians: write " + number->text + std::string(unit->factor);
  }
  return formula.error("'" + name.text + "' is a unit, and numbers have none here", name.span,
                       hint);
}

std::optional<std::string> undefined_name(const Error& error) {
  const Place& place = error.place();
  if (!std::string_view(error.what()).starts_with(kUnknownName)) return std::nullopt;
  if (place.span.end > place.text.size() || place.span.begin >= place.span.end) return std::nullopt;
  if (place.text.substr(place.span.end).starts_with('(')) return std::nullopt;  // a function
  const std::string name = place.text.substr(place.span.begin, place.span.end - place.span.begin);
  if (std::ranges::find(kOwnNames, name) != kOwnNames.end()) return std::nullopt;
  return name;
}

}  // namespace saddle
