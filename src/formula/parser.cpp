#include "formula/parser.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <unordered_map>
#include <utility>

#include "base/nearest.h"
#include "formula/derive.h"
#include "formula/language.h"
#include "formula/syntax.h"

namespace saddle {
namespace {

// muparser sees a skeleton of the formula: every operand is the variable x, every called name the
// function f, the operators are as they were. Its byte code lists the operands in the order of
// the text and the calls in the order of their closing brackets, which is all we need to put our
// own names, numbers and places back.

constexpr char kOperand = 'x';
constexpr char kCall = 'f';

double no_value(const double* /*arguments*/, int /*count*/) {
  return 0;
}
double minus(double a) {
  return -a;
}
double plus(double a) {
  return a;
}

/// muparser's operators, with our own functions for the signs so that the byte code tells them.
class Grammar final : public mu::ParserBase {
 public:
  Grammar() {
    EnableOptimizer(false);
    Init();
    DefineFun("f", static_cast<mu::multfun_type>(no_value), false);
    DefineVar("x", &operand_);
  }
  void InitCharSets() override {
    DefineNameChars("xf");
    DefineOprtChars("+-*/^?<>=!&|:");
    DefineInfixOprtChars("+-");
  }
  void InitFun() override {}
  void InitConst() override {}
  void InitOprt() override {
    DefineInfixOprt("-", minus);
    DefineInfixOprt("+", plus);
  }

 private:
  void Init() {
    InitCharSets();
    InitOprt();
  }
  double operand_ = 0;
};

bool is_function(const mu::SToken& token, mu::fun_type1 function) {
  return token.Fun.cb._pRawFun == reinterpret_cast<mu::erased_fun_type>(function);
}

/// The skeleton, and for each of its characters the token that it comes from.
struct Skeleton {
  std::string text;
  std::vector<std::size_t> token_at;
};

Skeleton make_skeleton(const std::vector<Token>& tokens, const Calls& calls) {
  Skeleton skeleton;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool operand = tokens[i].kind == TokenKind::Number || tokens[i].kind == TokenKind::Name;
    std::string text = tokens[i].text;
    if (operand) text = std::string(1, calls.is_call[i] ? kCall : kOperand);
    const bool operators =
        i > 0 && tokens[i].kind == TokenKind::Operator && tokens[i - 1].kind == TokenKind::Operator;
    if (operators) text = " " + text;  // muparser would read a*-b's two as one
    skeleton.text += text;
    skeleton.token_at.insert(skeleton.token_at.end(), text.size(), i);
  }
  return skeleton;
}

/// The innermost '?' whose bracket closes, or whose formula ends, before a ':'.
const Token& unmatched_question(const std::vector<Token>& tokens) {
  std::vector<std::vector<const Token*>> open(1);  // for each bracket level, the '?' that wait
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::Open) open.emplace_back();
    if (token.text == "?") open.back().push_back(&token);
    if (token.text == ":" && !open.back().empty()) open.back().pop_back();
    if (token.kind != TokenKind::Close) continue;
    if (!open.back().empty()) return *open.back().back();
    open.pop_back();
  }
  return open.back().empty() ? tokens.back() : *open.back().back();
}

/// A muparser error in terms of the formula.
Error explain_grammar_error(const FormulaText& formula, const std::vector<Token>& tokens,
                            const Skeleton& skeleton, const mu::ParserError& error) {
  // muparser objects to a colon after it has passed it, to everything else before.
  const int passed = error.GetCode() == mu::ecMISPLACED_COLON ? 1 : 0;
  const auto position = static_cast<std::size_t>(std::max(0, error.GetPos() - passed));
  const bool at_end =
      error.GetCode() == mu::ecUNEXPECTED_EOF || position >= skeleton.token_at.size();
  const std::size_t index = at_end ? tokens.size() - 1 : skeleton.token_at[position];
  const Token& token = tokens[index];
  if (error.GetCode() == mu::ecMISSING_ELSE_CLAUSE) {
    return formula.error("a '?' without its ':'", unmatched_question(tokens).span,
                         "write a ? b : c");
  }
  if (error.GetCode() == mu::ecMISPLACED_COLON) {
    return formula.error("a ':' without its '?'", token.span, "write a ? b : c");
  }
  if (at_end) {
    const Span after = {token.span.end, token.span.end};
    return formula.error("the formula ends where an operand is expected",
                         token.kind == TokenKind::Operator ? token.span : after,
                         kMissingOperandHint);
  }
  if (token.kind == TokenKind::Close || token.kind == TokenKind::Comma) {
    return formula.error("an operand is missing here", token.span, kMissingOperandHint);
  }
  return formula.error("an operand is missing before '" + token.text + "'", token.span,
                       "an operator stands between two operands");
}

/// Replays the byte code on a stack of nodes.
class Lifter {
 public:
  Lifter(Graph& graph, const FormulaText& formula, const Names& names)
      : graph_(graph), formula_(formula), names_(names), tokens_(tokenize(formula)) {
    calls_ = find_calls(tokens_);
    explain_misused_names();
    explain_slips(formula_, tokens_, calls_);
    collect_operands();
  }

  NodeId run() {
    Grammar grammar;
    const Skeleton skeleton = make_skeleton(tokens_, calls_);
    if (skeleton.text.size() >= static_cast<std::size_t>(mu::MaxLenExpression)) {
      throw formula_.error("the formula has more than 20000 numbers, names and operators",
                           tokens_.back().span, "give its parts names: w=..., then use w");
    }
    try {
      grammar.SetExpr(skeleton.text);
      grammar.Eval();  // this is what makes the byte code
      const mu::ParserByteCode& code = grammar.GetByteCode();
      for (const mu::SToken* step = code.GetBase(); step->Cmd != mu::cmEND; ++step) lift(*step);
    } catch (const mu::ParserError& error) {
      throw explain_grammar_error(formula_, tokens_, skeleton, error);
    }
    return pop();
  }

 private:
  /// Names that stand where they cannot: a function without brackets, a variable that is called,
  /// an unknown name.
  void explain_misused_names() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind != TokenKind::Name) continue;
      const bool variable = names_.variable(tokens_[i].text).has_value();
      const bool function = is_function_name(tokens_[i].text);
      if (calls_.is_call[i] ? function : variable) continue;
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
    const bool call = calls_.is_call[index];
    std::vector<std::string> known = call ? names_.known_functions() : names_.known_variables();
    std::string hint = call ? "known functions:" : "known names:";
    for (const std::string& name : known) hint += " " + name;
    // A suggestion may also be of the other kind: tua for tau, Cos without brackets.
    const std::vector<std::string> others =
        call ? names_.known_variables() : names_.known_functions();
    known.insert(known.end(), others.begin(), others.end());
    std::optional<std::string> meant = known_elsewhere_as(token.text);
    if (!meant) meant = nearest_name(token.text, known);
    if (meant) hint += "; did you mean '" + *meant + "'?";
    return formula_.error("unknown name '" + token.text + "'", token.span, hint);
  }

  void collect_operands() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind == TokenKind::Number) {
        operands_.push_back(graph_.constant(tokens_[i].value));
      } else if (tokens_[i].kind == TokenKind::Name && !calls_.is_call[i]) {
        operands_.push_back(*names_.variable(tokens_[i].text));
      }
    }
  }

  void lift(const mu::SToken& step) {
    switch (step.Cmd) {
      case mu::cmVAR:
        stack_.push_back(operands_[next_operand_++]);
        return;
      case mu::cmIF:
      case mu::cmELSE:
        return;  // condition and branches wait on the stack for cmENDIF
      case mu::cmENDIF:
        return lift_operation(Op::Select);
      case mu::cmFUNC:
        if (is_function(step, minus)) return lift_operation(Op::Neg);
        if (is_function(step, plus)) return;
        // muparser marks functions of any number of arguments by a negative count.
        return lift_call(static_cast<std::size_t>(std::abs(step.Fun.argc)));
      default:
        return lift_operation(binary_operation(step.Cmd));
    }
  }

  static Op binary_operation(mu::ECmdCode code) {
    static constexpr std::array kOperations = {
        std::pair{mu::cmLE, Op::LessEqual}, std::pair{mu::cmGE, Op::GreaterEqual},
        std::pair{mu::cmNEQ, Op::NotEqual}, std::pair{mu::cmEQ, Op::Equal},
        std::pair{mu::cmLT, Op::Less},      std::pair{mu::cmGT, Op::Greater},
        std::pair{mu::cmADD, Op::Add},      std::pair{mu::cmSUB, Op::Sub},
        std::pair{mu::cmMUL, Op::Mul},      std::pair{mu::cmDIV, Op::Div},
        std::pair{mu::cmPOW, Op::Pow},      std::pair{mu::cmLAND, Op::And},
        std::pair{mu::cmLOR, Op::Or}};
    for (const auto& [command, operation] : kOperations) {
      if (command == code) return operation;
    }
    throw mu::ParserError(mu::ecINTERNAL_ERROR);
  }

  void lift_operation(Op op) {
    std::array<NodeId, 3> args = {0, 0, 0};
    for (int i = arity(op); i-- > 0;) args[i] = pop();
    stack_.push_back(graph_.make(op, args[0], args[1], args[2]));
  }

  void lift_call(std::size_t count) {
    const std::size_t index = calls_.by_closing[next_call_++];
    const Token& token = tokens_[index];
    std::vector<NodeId> arguments(stack_.end() - static_cast<std::ptrdiff_t>(count), stack_.end());
    stack_.resize(stack_.size() - count);
    if (const HelperFunction* function = names_.function(token.text)) {
      check_count(index, count, function->arguments.size(), function->arguments.size());
      stack_.push_back(call_helper(*function, arguments));
    } else {
      const BuiltIn& built_in = *find_built_in(token.text);
      check_count(index, count, built_in.min_arguments, built_in.max_arguments);
      stack_.push_back(built_in.name == "diff" ? differentiate(token, arguments)
                                               : call(built_in, arguments));
    }
    if (graph_.size() > kMaxOperations) {
      throw formula_.error("the formulas grow past 250000 operations", token.span,
                           "functions that call functions multiply; use fewer levels");
    }
  }

  void check_count(std::size_t index, std::size_t count, std::size_t least,
                   std::size_t most) const {
    if (count >= least && count <= most) return;
    std::string hint;
    for (std::size_t i = index;
         count > most && i < tokens_.size() && tokens_[i].kind != TokenKind::Close; ++i) {
      if (tokens_[i].kind == TokenKind::Comma && is_decimal_comma(tokens_, i)) {
        hint = "a decimal comma? write " + tokens_[i - 1].text + "." + tokens_[i + 1].text;
      }
    }
    const std::string wanted = std::to_string(least) + (least == 1 ? " argument" : " arguments");
    throw formula_.error("'" + tokens_[index].text + "' takes " +
                             (most > least ? "at least " : "") + wanted + ", not " +
                             std::to_string(count),
                         tokens_[index].span, hint);
  }

  NodeId call(const BuiltIn& function, const std::vector<NodeId>& arguments) {
    std::vector<Expression> expressions;
    expressions.reserve(arguments.size());
    for (const NodeId argument : arguments) expressions.push_back({&graph_, argument});
    return call_built_in(function, expressions).id;
  }

  NodeId call_helper(const HelperFunction& function, const std::vector<NodeId>& arguments) {
    std::unordered_map<Symbol, NodeId> replacements;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      replacements[function.arguments[i]] = arguments[i];
    }
    return substitute(graph_, std::array{function.body}, replacements)[0];
  }

  NodeId differentiate(const Token& token, const std::vector<NodeId>& arguments) {
    const Node& by = graph_[arguments[1]];
    if (by.op != Op::Variable) {
      throw formula_.error("'diff' needs a plain name to differentiate by", token.span,
                           "write diff(EXPRESSION, u): u, v, t, a parameter with a number as its "
                           "value, or an argument of the function it stands in");
    }
    return derive(graph_, std::array{arguments[0]}, by.symbol)[0];
  }

  NodeId pop() {
    const NodeId top = stack_.back();
    stack_.pop_back();
    return top;
  }

  Graph& graph_;
  const FormulaText& formula_;
  const Names& names_;
  std::vector<Token> tokens_;
  Calls calls_;
  std::vector<NodeId> operands_;
  std::size_t next_operand_ = 0;
  std::size_t next_call_ = 0;
  std::vector<NodeId> stack_;
};

}  // namespace

NodeId parse_formula(Graph& graph, const FormulaText& formula, const Names& names) {
  return Lifter(graph, formula, names).run();
}

}  // namespace saddle
