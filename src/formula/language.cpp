#include "formula/language.h"

#include <algorithm>
#include <array>
#include <complex>
#include <limits>

#include "formula/operations.h"

namespace saddle {
namespace {

/// A line of the help: a heading, or a row's "call   what it is".
struct HelpLine {
  std::string_view text;
  bool heading = false;
};

template <class T>
T argument(std::span<const T> arguments, std::size_t index) {
  return arguments[std::min(index, arguments.size() - 1)];
}

template <Op op>
Expression call_operation(std::span<const Expression> arguments) {
  return make(op, argument(arguments, 0), argument(arguments, 1), argument(arguments, 2));
}

template <Op op>
Expression fold_arguments(std::span<const Expression> arguments) {
  Expression result = arguments[0];
  for (const Expression& next : arguments.subspan(1)) result = make(op, result, next);
  return result;
}

constexpr std::string_view kDiffHelp =
    "diff(a,u)  exact partial derivative of a by u, v, t, a parameter or an argument";

// The numbers column of ops.def, for functions of a, b and c.
#define SADDLE_OF_COMPLEX_REAL(expression) nullptr
#define SADDLE_OF_COMPLEX_COMPLEX(expression)                  \
  [](std::span<const Complex> arguments) -> Complex {          \
    [[maybe_unused]] const Complex a = argument(arguments, 0); \
    [[maybe_unused]] const Complex b = argument(arguments, 1); \
    return complex(expression);                                \
  }
#define SADDLE_CALL_1(function) function(a)
#define SADDLE_CALL_2(function) function(a, b)
#define SADDLE_CALL_3(function) function(a, b, c)

Complex complex(const Complex& a) {
  return a;
}
Complex complex(Expression a) {
  return {a, a.of(0)};
}

/// All rows of the table; operators and internal operations are among them, under names that no
/// formula can call.
std::span<const BuiltIn> rows() {
  static constexpr std::array kRows = {
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, function, kind, infinite, \
                  numbers, derivative)                                                            \
  BuiltIn{name,                                                                                   \
          arity,                                                                                  \
          arity,                                                                                  \
          help,                                                                                   \
          &call_operation<Op::id>,                                                                \
          SADDLE_OF_COMPLEX_##numbers(SADDLE_CALL_##arity(function))},
#define SADDLE_COMPOSITE(name, arity, numbers, expression, help)          \
  BuiltIn{#name,                                                          \
          arity,                                                          \
          arity,                                                          \
          help,                                                           \
          [](std::span<const Expression> arguments) -> Expression {       \
            [[maybe_unused]] const Expression a = argument(arguments, 0); \
            [[maybe_unused]] const Expression b = argument(arguments, 1); \
            [[maybe_unused]] const Expression c = argument(arguments, 2); \
            return expression;                                            \
          },                                                              \
          SADDLE_OF_COMPLEX_##numbers(expression)},
#define SADDLE_FOLD(name, op, finish, help)                                                    \
  BuiltIn{#name,                                                                               \
          1,                                                                                   \
          kAnyNumber,                                                                          \
          help,                                                                                \
          [](std::span<const Expression> arguments) -> Expression {                            \
            const Expression r = fold_arguments<Op::op>(arguments);                            \
            [[maybe_unused]] const Expression n = r.of(static_cast<double>(arguments.size())); \
            return finish;                                                                     \
          },                                                                                   \
          nullptr,                                                                             \
          Op::op},
#define SADDLE_TYPED(name, signature, expression, help) \
  BuiltIn{#name,                                        \
          static_cast<int>(sizeof(signature)) - 1,      \
          static_cast<int>(sizeof(signature)) - 1,      \
          help,                                         \
          nullptr,                                      \
          nullptr,                                      \
          std::nullopt,                                 \
          signature,                                    \
          [](const TypedArguments& in) -> Value { return expression; }},
#include "formula/ops.def"
      // The parser differentiates; the row is for its name, its arity and its help.
      BuiltIn{"diff", 2, 2, kDiffHelp},
  };
  return kRows;
}

struct Constant {
  std::string_view name;
  std::complex<double> value;
  std::string_view help;
};

constexpr std::array kConstants = {
#define SADDLE_CONSTANT(name, value, help) Constant{#name, value, help},
#include "formula/ops.def"
    // No definition can hide it: a character that names do not have.
    Constant{kImaginaryUnit, {0, 1}, ""},
};

constexpr std::array kHelpLines = {
#define SADDLE_GROUP(title) HelpLine{title, true},
#define SADDLE_OP(id, name, arity, help, ...) HelpLine{help},
#define SADDLE_COMPOSITE(name, arity, numbers, expression, help) HelpLine{help},
#define SADDLE_FOLD(name, op, finish, help) HelpLine{help},
#define SADDLE_TYPED(name, signature, expression, help) HelpLine{help},
#define SADDLE_CONSTANT(name, value, help) HelpLine{#name " " help},
#include "formula/ops.def"
    HelpLine{"Derivatives", true},
    HelpLine{kDiffHelp},
};

bool is_word(std::string_view name) {
  return !name.empty() &&
         ((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= 'A' && name[0] <= 'Z'));
}

struct Alias {
  std::string_view elsewhere;
  std::string_view here;
};

constexpr std::array kAliases = {
    Alias{"arcsin", "asin"},   Alias{"arccos", "acos"},     Alias{"arctan", "atan"},
    Alias{"arctg", "atan"},    Alias{"arctan2", "atan2"},   Alias{"arsinh", "asinh"},
    Alias{"arcsinh", "asinh"}, Alias{"arcosh", "acosh"},    Alias{"arccosh", "acosh"},
    Alias{"artanh", "atanh"},  Alias{"arctanh", "atanh"},   Alias{"tg", "tan"},
    Alias{"ctg", "cot"},       Alias{"cotan", "cot"},       Alias{"cosec", "csc"},
    Alias{"sh", "sinh"},       Alias{"ch", "cosh"},         Alias{"th", "tanh"},
    Alias{"lg", "log10"},      Alias{"ld", "log2"},         Alias{"fabs", "abs"},
    Alias{"sgn", "sign"},      Alias{"signum", "sign"},     Alias{"ceiling", "ceil"},
    Alias{"fmod", "mod"},      Alias{"power", "pow"},       Alias{"root", "sqrt"},
    Alias{"lerp", "mix"},      Alias{"tgamma", "gamma"},    Alias{"mean", "avg"},
    Alias{"average", "avg"},   Alias{"derivative", "diff"}, Alias{"D", "diff"},
    Alias{"int", "trunc"},     Alias{"j0", "besselj0"},     Alias{"j1", "besselj1"},
    Alias{"and", "&&"},        Alias{"or", "||"},           Alias{"not", "!"},
    Alias{"true", "1"},        Alias{"false", "0"},
};

}  // namespace

const BuiltIn* find_built_in(std::string_view name) {
  if (!is_word(name)) return nullptr;
  for (const BuiltIn& row : rows()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

const BuiltIn& built_in_of(Op op) {
  // The operations are rows in their order, with composites between them.
  static const std::vector<const BuiltIn*> kRowOf = [] {
    std::vector<const BuiltIn*> result;
    for (const Operation& operation : kOperations) {
      const auto found = std::ranges::find_if(rows(), [&](const BuiltIn& row) {
        return row.name == operation.name && row.min_arguments == operation.arity;
      });
      result.push_back(&*found);
    }
    return result;
  }();
  return *kRowOf[static_cast<std::size_t>(op) - static_cast<std::size_t>(kOperations[0].op)];
}

bool can_be_hidden(const BuiltIn& function) {
  return function.of_typed != nullptr || function.name == "prod";
}

std::optional<std::complex<double>> find_constant(std::string_view name) {
  for (const Constant& constant : kConstants) {
    if (constant.name == name) return constant.value;
  }
  return std::nullopt;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const BuiltIn& row : rows()) {
    if (is_word(row.name)) names.emplace_back(row.name);
  }
  return names;
}

std::vector<std::string> constant_names() {
  std::vector<std::string> names;
  names.reserve(kConstants.size());
  for (const Constant& constant : kConstants) {
    if (constant.name != kImaginaryUnit) names.emplace_back(constant.name);
  }
  return names;
}

std::optional<std::string> known_elsewhere_as(std::string_view name) {
  for (const Alias& alias : kAliases) {
    if (alias.elsewhere == name) return std::string(alias.here);
  }
  return std::nullopt;
}

std::string language_help() {
  constexpr std::size_t kCallWidth = 18;  // the longest call, and a space
  std::string text;
  for (const HelpLine& line : kHelpLines) {
    if (line.heading) {
      text.append(text.empty() ? "" : "\n").append(line.text).append("\n");
    } else if (!line.text.empty()) {
      std::string call(line.text.substr(0, line.text.find(' ')));
      const std::string_view meaning =
          line.text.substr(line.text.find_first_not_of(' ', call.size()));
      call.resize(std::max(kCallWidth, call.size() + 1), ' ');
      text.append("  ").append(call).append(meaning).append("\n");
    }
  }
  return text;
}

}  // namespace saddle
