#include "formula/parser.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "base/nearest.h"
#include "formula/derive.h"
#include "formula/language.h"
#include "formula/operands.h"
#include "formula/program.h"
#include "formula/syntax.h"

namespace saddle {
namespace {

/// A value on the stack, and the tokens it is made of.
struct Operand {
  Value value;
  std::size_t first = 0;
  std::size_t last = 0;
};

/// The parts of a sum or product over an index, compiled.
struct SeriesSteps {
  std::vector<Step> body, low, high;
};

std::string number_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// Runs the steps of a formula on a stack of values.
class Lifter {
 public:
  Lifter(Graph& graph, const FormulaText& formula, const Names& names)
      : graph_(graph), formula_(formula), names_(names), tokens_(tokenize(formula)) {
    call_curves(tokens_, [&](const std::string& name) {
      return names_.function(name) != nullptr && !names_.variable(name);
    });
    brackets_ = find_brackets(formula_, tokens_, [&](const std::string& name) {
      return (name == "sum" || name == "prod") && names_.function(name) == nullptr;
    });
    mark_indices();
    explain_misused_names();
    explain_slips(formula_, tokens_, brackets_);
  }

  Value run() {
    const std::vector<Step> steps = compile({0, tokens_.size()});
    for (const Series& series : brackets_.series) {
      series_[series.name] = {compile(series.body), compile(series.low), compile(series.high)};
    }
    return run(steps).value;
  }

 private:
  std::vector<Step> compile(TokenRange range) const {
    return compile_steps(formula_, tokens_, brackets_, range);
  }

  /// Names that an index has a meaning for; it hides every other.
  void mark_indices() {
    is_index_.resize(tokens_.size(), false);
    for (const Series& series : brackets_.series) {
      is_index_[series.index] = true;
      for (std::size_t i = series.body.begin; i < series.body.end; ++i) {
        const bool is_it = tokens_[i].kind == TokenKind::Name && !brackets_.is_call[i] &&
                           tokens_[i].text == tokens_[series.index].text;
        if (is_it) is_index_[i] = true;
      }
    }
  }

  /// Names that stand where they cannot: a function without brackets, a variable that is called,
  /// an unknown name.
  void explain_misused_names() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind != TokenKind::Name || is_index_[i]) continue;
      const bool variable = names_.variable(tokens_[i].text).has_value();
      const bool function = is_function_name(tokens_[i].text);
      if (brackets_.is_call[i] ? function : variable) continue;
      if (variable) {
        throw formula_.error("'" + tokens_[i].text + "' is not a function", tokens_[i].span,
                             "for a product write " + tokens_[i].text + "*(...)");
      }
      if (function) {
        throw formula_.error("'" + tokens_[i].text + "' needs its argument in brackets",
                             tokens_[i].span, "write " + with_brackets(i));
      }
      throw unknown_name(i);
    }
  }

  /// How the function that token `i` names is to be written: mod(u,2) for u mod 2, sin(...)^2 for
  /// sin^2(u), sin(u) for sin u.
  std::string with_brackets(std::size_t i) const {
    const auto is_operand = [&](std::size_t k) {
      return k < tokens_.size() &&
             (tokens_[k].kind == TokenKind::Name || tokens_[k].kind == TokenKind::Number);
    };
    const auto written = [&](std::size_t k) {
      const Span span = tokens_[k].span;
      return formula_.text.substr(span.begin, span.end - span.begin);
    };
    const std::string& name = tokens_[i].text;
    if (i > 0 && is_operand(i - 1) && is_operand(i + 1)) {
      return name + "(" + written(i - 1) + "," + written(i + 1) + ")";
    }
    const auto is_bracket = [&](std::size_t k) {
      return k < tokens_.size() && tokens_[k].kind == TokenKind::Open;
    };
    // 2(u) has become 2*(u) by now.
    const bool is_power =
        is_operand(i + 2) && tokens_[i + 1].text == "^" && (is_bracket(i + 3) || is_bracket(i + 4));
    if (is_power) {
      const std::string exponent = written(i + 2);
      return name + "(...)" + (tokens_[i + 2].text.empty() ? exponent : "^" + exponent);
    }
    return name + "(" + (is_operand(i + 1) ? written(i + 1) : "...") + ")";
  }

  bool is_function_name(const std::string& name) const {
    return names_.function(name) != nullptr || find_built_in(name) != nullptr;
  }

  Error unknown_name(std::size_t index) const {
    const Token& token = tokens_[index];
    if (auto unit = unit_behind_number(formula_, tokens_, token)) return *std::move(unit);
    const bool call = brackets_.is_call[index];
    std::vector<std::string> known = call ? names_.known_functions() : names_.known_variables();
    std::string names = call ? "known functions:" : "known names:";
    for (const std::string& name : known) names += " " + name;
    // A suggestion may also be of the other kind: tua for tau, Cos without brackets.
    const auto others = call ? names_.known_variables() : names_.known_functions();
    known.insert(known.end(), others.begin(), others.end());
    std::optional<std::string> meant = known_elsewhere_as(token.text);
    if (!meant) meant = nearest_name(token.text, known);
    if (meant) names.insert(0, "did you mean '" + *meant + "'? ");
    return formula_.error(std::string(kUnknownName) + token.text + "'", token.span, names);
  }

  Operand run(const std::vector<Step>& steps) {
    for (const Step& step : steps) {
      run(step);
      if (graph_.size() <= kMaxOperations) continue;
      throw formula_.error(
          "the formulas grow past 100000 operations", tokens_[stack_.back().first].span,
          "use fewer terms of sums, or fewer levels of functions that call functions");
    }
    const Operand result = stack_.back();
    stack_.pop_back();
    return result;
  }

  void run(const Step& step) {
    switch (step.kind) {
      case Step::Kind::Operand:
        if (const Series* series = brackets_.series_of(step.token)) {
          const Value value = unroll(*series);
          return stack_.push_back({value, series->name, series->close});
        }
        return stack_.push_back({operand(step.token), step.token, step.token});
      case Step::Kind::Operation:
        return run_operation(step.op);
      case Step::Kind::Not:
        stack_.push_back({Value(graph_.constant(0)), stack_.back().first, stack_.back().last});
        return run_operation(Op::Equal);
      case Step::Kind::Call:
        return run_call(step);
      case Step::Kind::Vector:
        return replace(step.count, step.token, step.token, brackets_.close_of[step.token],
                       [&](auto values) { return make_vector(values); });
      case Step::Kind::Component:
        return run_component(step.token);
    }
  }

  Value operand(std::size_t token) {
    const std::string& name = tokens_[token].text;
    if (tokens_[token].kind == TokenKind::Number) {
      return Value(graph_.constant(tokens_[token].value));
    }
    if (!is_index_[token]) return *names_.variable(name);
    const auto found = std::ranges::find(indices_.rbegin(), indices_.rend(), name,
                                         &std::pair<std::string, Value>::first);
    return found->second;
  }

  /// Puts f of the last `count` operands in their place; the result is made of the tokens from
  /// `first` to `last`. `about`: the operator or function.
  template <class F>
  void replace(std::size_t count, std::size_t about, std::size_t first, std::size_t last, F f) {
    const std::size_t base = stack_.size() - count;
    std::vector<Value> values;
    for (std::size_t k = base; k < stack_.size(); ++k) values.push_back(stack_[k].value);
    try {
      const Value result = f(std::span<const Value>(values));
      stack_.resize(base);
      stack_.push_back({result, first, last});
    } catch (const TypeFault& fault) {
      const auto count_of = [&](Type type) {
        return std::ranges::count(values, type, &Value::type);
      };
      const bool may_be_comma =
          (count_of(Type::Vector2) > 0 && count_of(Type::Vector3) == 0) || values.size() > 3;
      const std::string hint =
          may_be_comma ? hint_beside_comma(tokens_, first, last, fault.hint) : fault.hint;
      throw TypeError(formula_.error(fault.message, place_of(fault, base, about), hint));
    }
  }

  Span place_of(const TypeFault& fault, std::size_t base, std::size_t about) const {
    const bool is_operand = fault.operand >= 0;
    const Operand& first = stack_[base + static_cast<std::size_t>(std::max(fault.operand, 0))];
    const Span span = tokens_[about].span;
    // A product without a sign has no characters of its own.
    if (!is_operand && span.begin < span.end) return span;
    const Operand& last = is_operand ? first : stack_.back();
    return {tokens_[first.first].span.begin, tokens_[last.last].span.end};
  }

  /// Makes the exponent of a complex base, the last operand, a number where it is known to be
  /// whole, so that the power is a product. Its parameters cannot be differentiated by any more.
  void fix_exponent() {
    const Value& base = stack_[stack_.size() - 2].value;
    Value& exponent = stack_.back().value;
    if (base.type != Type::Complex || exponent.type != Type::Real) return;
    const std::optional<double> value = names_.parameter_value(exponent.real());
    if (!value || std::floor(*value) != *value) return;
    const std::vector<bool> is_part = reachable(graph_, exponent.parts());
    for (NodeId id = 0; id < is_part.size(); ++id) {
      const Node& node = graph_[id];
      if (is_part[id] && node.op == Op::Variable) names_.unrolled->exponents.insert(node.symbol);
    }
    exponent = Value(graph_.constant(*value));
  }

  void run_operation(Op op) {
    const auto count = static_cast<std::size_t>(arity(op));
    const std::size_t base = stack_.size() - count;
    if (op == Op::Pow) fix_exponent();
    const std::size_t sign =
        count == 1 ? operator_before(stack_[base].first) : operator_behind(stack_[base].last);
    const std::size_t first = count == 1 ? sign : stack_[base].first;
    replace(count, sign, first, stack_.back().last,
            [&](auto values) { return operate(graph_, op, values); });
  }

  /// The operator in front of an operand that begins at `token`, whose brackets may lie between.
  std::size_t operator_before(std::size_t token) const {
    while (token > 0 && tokens_[token].kind != TokenKind::Operator) --token;
    return token;
  }
  std::size_t operator_behind(std::size_t token) const {
    while (token + 1 < tokens_.size() && tokens_[token].kind != TokenKind::Operator) ++token;
    return token;
  }

  void run_call(const Step& step) {
    const std::string& name = tokens_[step.token].text;
    const HelperFunction* const helper = names_.function(name);
    const BuiltIn* const built_in = find_built_in(name);
    if (helper != nullptr) {
      check_count(step.token, step.count, helper->argument_count, helper->argument_count);
    } else {
      check_count(step.token, step.count, static_cast<std::size_t>(built_in->min_arguments),
                  static_cast<std::size_t>(built_in->max_arguments));
    }
    if (helper == nullptr && name == "pow") fix_exponent();
    replace(step.count, step.token, step.token, brackets_.close_of[step.token + 1],
            [&](auto values) {
              if (helper != nullptr) return helper->call(values);
              return name == "diff" ? differentiate(values)
                                    : call_built_in(graph_, *built_in, values, names_.sampler);
            });
  }

  void check_count(std::size_t index, std::size_t count, std::size_t least,
                   std::size_t most) const {
    if (count >= least && count <= most) return;
    std::string hint = tokens_[index].text == "atan" ? "the angle of a point is atan2(y,x)" : "";
    if (count > most) hint = hint_beside_comma(tokens_, index, brackets_.close_of[index + 1], hint);
    const std::string wanted = std::to_string(least) + (least == 1 ? " argument" : " arguments");
    throw formula_.error("'" + tokens_[index].text + "' takes " +
                             (most > least ? "at least " : "") + wanted + ", not " +
                             std::to_string(count),
                         tokens_[index].span, hint);
  }

  Value differentiate(std::span<const Value> arguments) {
    const Value& by = arguments[1];
    if (by.type != Type::Real || graph_[by.real()].op != Op::Variable) {
      throw TypeFault{"'diff' needs a plain name to differentiate by",
                      "write diff(EXPRESSION, u): u, v, t, a parameter with a number as its "
                      "value, or an argument of the function it stands in"};
    }
    if (names_.unrolled->exponents.contains(graph_[by.real()].symbol)) {
      throw TypeFault{"'diff' by an exponent of a complex number", "write exp(n*ln(z)) for z^n"};
    }
    return {arguments[0].type, derive(graph_, arguments[0].parts(), graph_[by.real()].symbol)};
  }

  /// .x, or several in a row.
  void run_component(std::size_t token) {
    for (; token < tokens_.size() && tokens_[token].kind == TokenKind::Component; ++token) {
      const std::string_view name = std::string_view(tokens_[token].text).substr(1);
      replace(1, token, stack_.back().first, token,
              [&](auto values) { return component_of(values[0], name); });
    }
  }

  /// The terms of a sum or product over an index, one after the other.
  Value unroll(const Series& series) {
    const SeriesSteps& steps = series_.at(series.name);
    const bool is_sum = tokens_[series.name].text == "sum";
    const double low = bound(steps.low, series.low);
    const double high = bound(steps.high, series.high);
    const double terms = std::max(0.0, high - low + 1);
    if (terms + static_cast<double>(names_.unrolled->terms) > static_cast<double>(kMaxTerms)) {
      throw formula_.error("sums and products over an index have more than 20000 terms in all",
                           {tokens_[series.index].span.begin, tokens_[series.close - 1].span.end},
                           number_text(terms) + " terms here; use fewer");
    }
    names_.unrolled->terms += static_cast<std::size_t>(terms);
    Value result(graph_.constant(is_sum ? 0 : 1));
    indices_.emplace_back(tokens_[series.index].text, Value());
    for (double k = 0; k < terms; ++k) {
      indices_.back().second = Value(graph_.constant(low + k));
      const Operand term = run(steps.body);
      if (k == 0) {
        result = term.value;
        continue;
      }
      stack_.push_back({result, term.first, term.last});
      stack_.push_back(term);
      replace(2, series.name, series.name, series.close,
              [&](auto values) { return operate(graph_, is_sum ? Op::Add : Op::Mul, values); });
      result = stack_.back().value;
      stack_.pop_back();
    }
    indices_.pop_back();
    return result;
  }

  /// A bound of an index: a whole number.
  double bound(const std::vector<Step>& steps, TokenRange range) {
    const Value value = run(steps).value;
    const Span span = {tokens_[range.begin].span.begin, tokens_[range.end - 1].span.end};
    std::optional<double> number;
    if (value.type == Type::Real) number = names_.parameter_value(value.real());
    if (!number) {
      throw TypeError(
          formula_.error("a bound of an index must be a constant", span,
                         "it may use numbers, constants and parameters, not u, v or t"));
    }
    if (std::floor(*number) == *number && std::isfinite(*number)) return *number;
    throw formula_.error("a bound of an index must be a whole number, not " + number_text(*number),
                         span, "write floor(...) around it");
  }

  Graph& graph_;
  const FormulaText& formula_;
  const Names& names_;
  std::vector<Token> tokens_;
  Brackets brackets_;
  std::vector<bool> is_index_;  // for each token
  std::map<std::size_t, SeriesSteps> series_;
  std::vector<std::pair<std::string, Value>> indices_;  // innermost last
  std::vector<Operand> stack_;
};

}  // namespace

Value parse_formula(Graph& graph, const FormulaText& formula, const Names& names) {
  return Lifter(graph, formula, names).run();
}

NodeId require_real(const Value& value, const FormulaText& formula) {
  if (value.type == Type::Real) return value.real();
  constexpr std::size_t kLongestQuoted = 30;  // longer formulas are "..." in the hint
  std::string text = formula.text.substr(formula.part.begin, formula.part.end - formula.part.begin);
  if (text.size() > kLongestQuoted) text = "...";
  const auto of = [&](const char* function) { return function + ("(" + text + ")"); };
  std::string hint = "write " + of("re") + ", " + of("im") + ", " + of("abs") + " or " + of("arg");
  if (value.type != Type::Complex) hint = "write (" + text + ").x or another component";
  if (value.type == Type::Frame) hint = "write (" + text + ").t.x or another component";
  if (value.type == Type::Vector2) {
    const std::vector<Token> tokens = tokenize(formula);
    hint = hint_beside_comma(tokens, 0, tokens.size(), hint);
  }
  const std::string subject = formula.name.empty() ? "this" : formula.name;
  throw TypeError(formula.error(subject + " is " + name_of(value.type), formula.part, hint));
}

}  // namespace saddle
