#include "formula/lexer.h"

#include <array>
#include <charconv>
#include <limits>
#include <span>
#include <string_view>

#include "base/utf8.h"

namespace saddle {
namespace {

/// A way of writing that stands for another.
struct Spelling {
  std::string_view written;
  TokenKind kind;
  std::string_view meant;
};

// Longer spellings before their own beginnings.
constexpr std::array kSpellings = {
    Spelling{"**", TokenKind::Operator, "^"},  Spelling{"<=", TokenKind::Operator, "<="},
    Spelling{">=", TokenKind::Operator, ">="}, Spelling{"==", TokenKind::Operator, "=="},
    Spelling{"!=", TokenKind::Operator, "!="}, Spelling{"&&", TokenKind::Operator, "&&"},
    Spelling{"||", TokenKind::Operator, "||"}, Spelling{"+", TokenKind::Operator, "+"},
    Spelling{"-", TokenKind::Operator, "-"},   Spelling{"*", TokenKind::Operator, "*"},
    Spelling{"/", TokenKind::Operator, "/"},   Spelling{"^", TokenKind::Operator, "^"},
    Spelling{"<", TokenKind::Operator, "<"},   Spelling{">", TokenKind::Operator, ">"},
    Spelling{"?", TokenKind::Operator, "?"},   Spelling{":", TokenKind::Operator, ":"},
    Spelling{"!", TokenKind::Operator, "!"},   Spelling{"=", TokenKind::Operator, "="},
    Spelling{"(", TokenKind::Open, "("},       Spelling{")", TokenKind::Close, ")"},
    Spelling{",", TokenKind::Comma, ","},      Spelling{"·", TokenKind::Operator, "*"},
    Spelling{"⋅", TokenKind::Operator, "*"},   Spelling{"×", TokenKind::Operator, "*"},
    Spelling{"÷", TokenKind::Operator, "/"},   Spelling{"−", TokenKind::Operator, "-"},
    Spelling{"–", TokenKind::Operator, "-"},   Spelling{"≤", TokenKind::Operator, "<="},
    Spelling{"≥", TokenKind::Operator, ">="},  Spelling{"≠", TokenKind::Operator, "!="},
    Spelling{"π", TokenKind::Name, "pi"},      Spelling{"∞", TokenKind::Name, "inf"},
    Spelling{"ⅈ", TokenKind::Name, "ⅈ"},
};

constexpr std::array<std::string_view, 10> kSuperscripts = {"⁰", "¹", "²", "³", "⁴",
                                                            "⁵", "⁶", "⁷", "⁸", "⁹"};

/// Characters that mean something elsewhere, and what to write here.
struct Misplaced {
  std::string_view written;
  std::string_view message;
  std::string_view hint;
};

constexpr std::array kMisplaced = {
    Misplaced{"%", "'%' is not part of the language", "the remainder of a/b is mod(a,b)"},
    Misplaced{"&", "a single '&'", "'and' is &&"},
    Misplaced{"|", "a single '|'", "'or' is ||; the absolute value of a is abs(a)"},
    Misplaced{"[", "square brackets are not part of the language", "use ( )"},
    Misplaced{"]", "square brackets are not part of the language", "use ( )"},
    Misplaced{"{", "braces are not part of the language", "use ( )"},
    Misplaced{"}", "braces are not part of the language", "use ( )"},
    Misplaced{";", "';' is not part of a formula", "one argument holds one formula"},
    Misplaced{"√", "'√' is not part of the language", "write sqrt(...)"},
    Misplaced{"'", "a quote inside a formula", "for a derivative write diff(..., u)"},
    Misplaced{"\"", "a quote inside a formula", "leave it out"},
};

/// The same, where a part of it alone would mean something.
constexpr std::array kMisspelt = {
    Misplaced{"<>", "'<>' is not part of the language", "unequal is !="},
    Misplaced{"=<", "'=<' is not part of the language", "at most is <="},
    Misplaced{"=>", "'=>' is not part of the language", "at least is >="},
    Misplaced{"===", "'===' is not part of the language", "equal is =="},
    Misplaced{"!==", "'!==' is not part of the language", "unequal is !="},
};

constexpr std::string_view kSuperscriptMinus = "⁻";
constexpr std::string_view kGreekPi = "π";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// The letters of Unicode's block "Greek and Coptic" but for π, and the micro sign of keyboards.
bool is_greek(char32_t code) {
  constexpr char32_t kSmallPi = 0x3C0;
  constexpr char32_t kMicro = 0xB5;
  const bool is_mark = code == 0x37E || code == 0x387;  // a question mark and a dot
  return code == kMicro || (code >= 0x386 && code <= 0x3FF && code != kSmallPi && !is_mark);
}

/// Length in bytes of the UTF-8 character that begins with `c`, at least 1.
std::size_t character_length(unsigned char c) {
  if (c >= 0xF0) return 4;
  if (c >= 0xE0) return 3;
  return c >= 0xC0 ? 2 : 1;
}

class Lexer {
 public:
  explicit Lexer(const FormulaText& formula) : formula_(formula), at_(formula.part.begin) {}

  std::vector<Token> run() {
    if (formula_.part.end - formula_.part.begin > kMaxFormulaLength) {
      throw formula_.error("the formula is longer than 64 KiB", {at_, at_ + 1},
                           "give its parts names: w=..., then use w");
    }
    while (at_ < formula_.part.end) read_token();
    if (tokens_.empty()) {
      throw formula_.error("the formula is empty", formula_.part, "write an expression, e.g. u*v");
    }
    if (!open_.empty()) {
      throw formula_.error("this bracket is not closed", open_.back(), "add a ')'");
    }
    return std::move(tokens_);
  }

 private:
  std::string_view rest() const {
    return std::string_view(formula_.text).substr(at_, formula_.part.end - at_);
  }

  void read_token() {
    const char c = formula_.text[at_];
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at_;
    } else if (rest().starts_with("\u00a0")) {  // a no-break space, from a web page
      at_ += 2;
    } else if (is_digit(c) || (c == '.' && rest().size() > 1 && is_digit(rest()[1]))) {
      read_number();
    } else if (const std::size_t length = name_length(rest())) {
      push(TokenKind::Name, meant_name(rest().substr(0, length)), length);
    } else if (!read_component()) {
      refuse(kMisspelt);
      if (!read_spelling() && !read_superscript()) refuse_character();
    }
  }

  void read_number() {
    const char* const begin = rest().data();
    double value = 0;
    const auto [end, error] = std::from_chars(begin, begin + rest().size(), value);
    const auto length = static_cast<std::size_t>(end - begin);
    if (error == std::errc::result_out_of_range) {
      throw formula_.error("a number that is out of range", {at_, at_ + length},
                           "numbers go from 5e-324 to 1.8e308");
    }
    push(TokenKind::Number, rest().substr(0, length), length);
    tokens_.back().value = value;
  }

  /// .x behind an operand.
  bool read_component() {
    const bool follows = !tokens_.empty() && (tokens_.back().kind == TokenKind::Name ||
                                              tokens_.back().kind == TokenKind::Close ||
                                              tokens_.back().kind == TokenKind::Component);
    if (!follows || rest()[0] != '.') return false;
    const std::size_t length = name_length(rest().substr(1));
    if (length == 0) return false;
    push(TokenKind::Component, rest().substr(0, length + 1), length + 1);
    return true;
  }

  bool read_spelling() {
    for (const Spelling& spelling : kSpellings) {
      if (!rest().starts_with(spelling.written)) continue;
      const std::size_t begin = at_;
      push(spelling.kind, spelling.meant, spelling.written.size());
      if (spelling.kind == TokenKind::Open) open_bracket(begin);
      if (spelling.kind == TokenKind::Close) close_bracket(begin);
      return true;
    }
    return false;
  }

  /// u² is u^2, u⁻¹ is u^-1; several superscript digits are one number.
  bool read_superscript() {
    const std::size_t begin = at_;
    const bool negative = rest().starts_with(kSuperscriptMinus);
    if (negative) at_ += kSuperscriptMinus.size();
    const std::size_t digits = at_;
    double exponent = 0;
    for (bool found = true; found;) {
      found = false;
      for (std::size_t digit = 0; digit < kSuperscripts.size(); ++digit) {
        if (!rest().starts_with(kSuperscripts[digit])) continue;
        exponent = 10 * exponent + static_cast<double>(digit);
        at_ += kSuperscripts[digit].size();
        found = true;
      }
    }
    if (at_ == begin) return false;
    if (at_ == digits) {
      throw formula_.error("a raised minus without a number", {begin, at_}, "write u^-1 or u⁻¹");
    }
    tokens_.push_back({TokenKind::Operator, "^", 0, {begin, at_}});
    tokens_.push_back({TokenKind::Number, "", negative ? -exponent : exponent, {begin, at_}});
    return true;
  }

  void push(TokenKind kind, std::string_view text, std::size_t length) {
    insert_product(kind);
    tokens_.push_back({kind, std::string(text), 0, {at_, at_ + length}});
    at_ += length;
  }

  /// A number right before a name or a bracket is its factor.
  void insert_product(TokenKind next) {
    if (next != TokenKind::Name && next != TokenKind::Open) return;
    // A superscript's number has no text: u² v is not a product that we understand.
    if (tokens_.empty() || tokens_.back().kind != TokenKind::Number || tokens_.back().text.empty())
      return;
    tokens_.push_back({TokenKind::Operator, "*", 0, {at_, at_}});
  }

  void open_bracket(std::size_t begin) {
    open_.push_back({begin, begin + 1});
    if (open_.size() > static_cast<std::size_t>(kMaxNesting)) {
      throw formula_.error("brackets are nested more than 256 deep", open_.back(),
                           "give the inner parts names: w=..., then use w");
    }
  }

  void close_bracket(std::size_t begin) {
    if (open_.empty()) {
      throw formula_.error("this bracket was never opened", {begin, begin + 1},
                           "remove it, or add a '('");
    }
    open_.pop_back();
  }

  /// Throws if one of these is next.
  void refuse(std::span<const Misplaced> all) const {
    for (const Misplaced& misplaced : all) {
      if (!rest().starts_with(misplaced.written)) continue;
      throw formula_.error(std::string(misplaced.message), {at_, at_ + misplaced.written.size()},
                           std::string(misplaced.hint));
    }
  }

  [[noreturn]] void refuse_character() const {
    refuse(kMisplaced);
    const std::size_t length =
        std::min(character_length(static_cast<unsigned char>(formula_.text[at_])), rest().size());
    throw formula_.error("a character that no formula has", {at_, at_ + length},
                         "formulas are made of numbers, names, + - * / ^ ( ) , < > = & | ? :");
  }

  const FormulaText& formula_;
  std::size_t at_;
  std::vector<Token> tokens_;
  std::vector<Span> open_;
};

}  // namespace

std::size_t name_length(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const Character c = decode_utf8(text, at);
    if (!is_letter(text[at]) && !is_greek(c.code) && (at == 0 || !is_digit(text[at]))) break;
    at += c.bytes;
  }
  return at;
}

bool is_name(std::string_view text) {
  return !text.empty() && (text == kGreekPi || name_length(text) == text.size());
}

std::set<std::string> names_in(std::string_view text) {
  std::set<std::string> names;
  while (!text.empty()) {
    const std::size_t length = name_length(text);
    if (length > 0) names.insert(meant_name(text.substr(0, length)));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return names;
}

std::string meant_name(std::string_view written) {
  if (written == kGreekPi) return "pi";
  if (written == "τ") return "tau";
  if (written == "µ") return "μ";  // the micro sign of keyboards
  return written == "φ" ? "phi" : std::string(written);
}

Error FormulaText::error(std::string message, Span span, std::string hint) const {
  return {Status::Input, std::move(message), Place{name, text, span}, std::move(hint)};
}

std::vector<Token> tokenize(const FormulaText& formula) {
  return Lexer(formula).run();
}

}  // namespace saddle
