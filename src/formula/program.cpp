#include "formula/program.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace saddle {
namespace {

// muparser sees a skeleton of the formula: every operand is the variable x, every called name and
// every vector the function f, the operators are as they were. Its byte code lists the operands and
// components in the order of the text and the calls in the order of their closing brackets, which
// is all we need to put our own names, numbers and places back.

constexpr char kOperand = 'x';
constexpr char kCall = 'f';
constexpr const char* kNot = "!";
constexpr const char* kComponent = "'";

/// Characters of the skeletons whose byte code is kept: of some hundred formulas, in a megabyte.
constexpr std::size_t kMostKept = 20'000;

double no_value(const double* /*arguments*/, int /*count*/) {
  return 0;
}
double minus(double a) {
  return -a;
}
double plus(double a) {
  return a;
}
double logical_not(double a) {
  return a == 0 ? 1 : 0;
}
double component(double a) {
  return a + 1;
}

using ByteCode = std::vector<mu::SToken>;

/// muparser's operators, with our own functions for the signs so that the byte code tells them.
class Grammar final : public mu::ParserBase {
 public:
  Grammar() {
    EnableOptimizer(false);
    Init();
    DefineFun("f", static_cast<mu::multfun_type>(no_value), false);
    DefineVar("x", &operand_);
  }

  /// The byte code of a skeleton. The formulas of many objects have few skeletons, and each is read
  /// several times.
  const ByteCode& code_of(const std::string& skeleton) {
    const auto known = codes_.find(skeleton);
    if (known != codes_.end()) return known->second;
    SetExpr(skeleton);
    Eval();  // this is what makes the byte code
    ByteCode code;
    for (const mu::SToken* step = GetByteCode().GetBase(); step->Cmd != mu::cmEND; ++step)
      code.push_back(*step);
    if (kept_ + skeleton.size() > kMostKept) {
      codes_.clear();
      kept_ = 0;
    }
    kept_ += skeleton.size();
    return codes_.emplace(skeleton, std::move(code)).first->second;
  }

  void InitCharSets() override {
    DefineNameChars("xf");
    DefineOprtChars("+-*/^?<>=!&|:'");
    DefineInfixOprtChars("+-!");
  }
  void InitFun() override {}
  void InitConst() override {}
  void InitOprt() override {
    DefineInfixOprt("-", minus);
    DefineInfixOprt("+", plus);
    DefineInfixOprt(kNot, logical_not);
    DefinePostfixOprt(kComponent, component);
  }

 private:
  void Init() {
    InitCharSets();
    InitOprt();
  }
  double operand_ = 0;
  std::unordered_map<std::string, ByteCode> codes_;
  std::size_t kept_ = 0;  ///< characters of their skeletons
};

bool is_function(const mu::SToken& token, mu::fun_type1 function) {
  return token.Fun.cb._pRawFun == reinterpret_cast<mu::erased_fun_type>(function);
}

Op binary_operation(mu::ECmdCode code) {
  static constexpr std::array kOperators = {
      std::pair{mu::cmLE, Op::LessEqual}, std::pair{mu::cmGE, Op::GreaterEqual},
      std::pair{mu::cmNEQ, Op::NotEqual}, std::pair{mu::cmEQ, Op::Equal},
      std::pair{mu::cmLT, Op::Less},      std::pair{mu::cmGT, Op::Greater},
      std::pair{mu::cmADD, Op::Add},      std::pair{mu::cmSUB, Op::Sub},
      std::pair{mu::cmMUL, Op::Mul},      std::pair{mu::cmDIV, Op::Div},
      std::pair{mu::cmPOW, Op::Pow},      std::pair{mu::cmLAND, Op::And},
      std::pair{mu::cmLOR, Op::Or}};
  for (const auto& [command, operation] : kOperators) {
    if (command == code) return operation;
  }
  throw mu::ParserError(mu::ecINTERNAL_ERROR);
}

class Compiler {
 public:
  Compiler(const FormulaText& formula, const std::vector<Token>& tokens, const Brackets& brackets,
           TokenRange range)
      : formula_(formula), tokens_(tokens), brackets_(brackets), range_(range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      used_.push_back(i);
      if (const Series* series = brackets.series_of(i)) i = series->close;
    }
    make_skeleton();
  }

  std::vector<Step> run() {
    if (text_.size() >= static_cast<std::size_t>(mu::MaxLenExpression)) {
      throw formula_.error("the formula has more than 20000 numbers, names and operators",
                           tokens_[range_.end - 1].span, "give its parts names: w=..., then use w");
    }
    thread_local Grammar grammar;  // to make one takes longer than to read most formulas
    try {
      for (const mu::SToken& step : grammar.code_of(text_)) read(step);
    } catch (const mu::ParserError& error) {
      throw explain(error);
    }
    return std::move(steps_);
  }

 private:
  void make_skeleton() {
    for (std::size_t k = 0; k < used_.size(); ++k) {
      const std::size_t i = used_[k];
      const Token& token = tokens_[i];
      const bool follows = k > 0 && used_[k - 1] + 1 == i;
      if (token.kind == TokenKind::Component) {
        if (follows && tokens_[i - 1].kind == TokenKind::Component) continue;  // of one step
        components_.push_back(i);
        add(kComponent, i);
      } else if (brackets_.series_of(i) != nullptr) {
        add({kOperand}, i);
        operands_.push_back(i);
      } else if (token.kind == TokenKind::Number || token.kind == TokenKind::Name) {
        const bool is_call = brackets_.is_call[i];
        add({is_call ? kCall : kOperand}, i);
        if (!is_call) operands_.push_back(i);
      } else {
        add_mark(i, follows);
      }
    }
  }

  /// An operator, a bracket or a comma. `follows`: the token before it is used, too.
  void add_mark(std::size_t i, bool follows) {
    const Token& token = tokens_[i];
    const auto is_operator = [](const Token& t) { return t.kind == TokenKind::Operator; };
    const bool is_vector = token.kind == TokenKind::Open && brackets_.is_vector[i];
    if (is_vector) add({kCall}, i);
    // muparser would read a*-b's two operators as one
    const bool is_second = follows && is_operator(token) && is_operator(tokens_[i - 1]);
    add((is_second ? " " : "") + token.text, i);
    if (token.kind == TokenKind::Close) close(i);
  }

  void close(std::size_t index) {
    const std::size_t open = brackets_.open_of[index];
    const bool is_called = open > range_.begin && brackets_.is_call[open - 1];
    if (is_called) calls_.push_back(open - 1);
    if (brackets_.is_vector[open]) calls_.push_back(open);
  }

  void add(const std::string& text, std::size_t token) {
    text_ += text;
    token_at_.insert(token_at_.end(), text.size(), token);
  }

  void push(Step::Kind kind, std::size_t token, std::size_t count = 0) {
    steps_.push_back({kind, Op::Constant, token, count});
  }
  void push(Op op) { steps_.push_back({Step::Kind::Operation, op, 0, 0}); }

  void read(const mu::SToken& step) {
    switch (step.Cmd) {
      case mu::cmVAR:
        return push(Step::Kind::Operand, operands_[next_operand_++]);
      case mu::cmIF:
      case mu::cmELSE:
        return;  // condition and branches wait on the stack for cmENDIF
      case mu::cmENDIF:
        return push(Op::Select);
      case mu::cmFUNC:
        return read_function(step);
      default:
        return push(binary_operation(step.Cmd));
    }
  }

  void read_function(const mu::SToken& step) {
    if (is_function(step, minus)) return push(Op::Neg);
    if (is_function(step, plus)) return;
    if (is_function(step, logical_not)) return push(Step::Kind::Not, 0);
    if (is_function(step, component)) {
      return push(Step::Kind::Component, components_[next_component_++]);
    }
    const std::size_t token = calls_[next_call_++];
    const bool is_vector = tokens_[token].kind == TokenKind::Open;
    // muparser marks functions of any number of arguments by a negative count.
    push(is_vector ? Step::Kind::Vector : Step::Kind::Call, token,
         static_cast<std::size_t>(std::abs(step.Fun.argc)));
  }

  /// The innermost '?' whose bracket closes, or whose formula ends, before a ':'.
  const Token& unmatched_question() const {
    std::vector<std::vector<const Token*>> open(1);  // for each bracket level, the '?' that wait
    for (const std::size_t i : used_) {
      const Token& token = tokens_[i];
      if (brackets_.series_of(i) != nullptr) continue;
      if (token.kind == TokenKind::Open) open.emplace_back();
      if (token.text == "?") open.back().push_back(&token);
      if (token.text == ":" && !open.back().empty()) open.back().pop_back();
      if (token.kind != TokenKind::Close) continue;
      if (!open.back().empty()) return *open.back().back();
      open.pop_back();
    }
    return open.back().empty() ? tokens_[range_.end - 1] : *open.back().back();
  }

  /// A muparser error in terms of the formula.
  Error explain(const mu::ParserError& error) const {
    // muparser objects to a colon after it has passed it, to everything else before.
    const int passed = error.GetCode() == mu::ecMISPLACED_COLON ? 1 : 0;
    const auto position = static_cast<std::size_t>(std::max(0, error.GetPos() - passed));
    const bool at_end = error.GetCode() == mu::ecUNEXPECTED_EOF || position >= token_at_.size();
    const Token& token = tokens_[at_end ? range_.end - 1 : token_at_[position]];
    if (error.GetCode() == mu::ecMISSING_ELSE_CLAUSE) {
      return formula_.error("a '?' without its ':'", unmatched_question().span, "write a ? b : c");
    }
    if (error.GetCode() == mu::ecMISPLACED_COLON) {
      return formula_.error("a ':' without its '?'", token.span, "write a ? b : c");
    }
    if (at_end) {
      const Span after = {token.span.end, token.span.end};
      return formula_.error("the formula ends where an operand is expected",
                            token.kind == TokenKind::Operator ? token.span : after,
                            kMissingOperandHint);
    }
    if (token.kind == TokenKind::Close || token.kind == TokenKind::Comma) {
      return formula_.error("an operand is missing here", token.span, kMissingOperandHint);
    }
    return formula_.error("an operand is missing before '" + token.text + "'", token.span,
                          "an operator stands between two operands");
  }

  const FormulaText& formula_;
  const std::vector<Token>& tokens_;
  const Brackets& brackets_;
  TokenRange range_;
  std::vector<std::size_t> used_;      // tokens of the range, of a sum over an index its name alone
  std::string text_;                   // the skeleton
  std::vector<std::size_t> token_at_;  // for each of its characters
  std::vector<std::size_t> operands_, calls_, components_;
  std::size_t next_operand_ = 0, next_call_ = 0, next_component_ = 0;
  std::vector<Step> steps_;
};

}  // namespace

std::vector<Step> compile_steps(const FormulaText& formula, const std::vector<Token>& tokens,
                                const Brackets& brackets, TokenRange range) {
  return Compiler(formula, tokens, brackets, range).run();
}

}  // namespace saddle
