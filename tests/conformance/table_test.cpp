// Every row of the table of operations has all of its parts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>
#include <string>

#include "conformance/arguments.h"
#include "formula/derive.h"
#include "formula/expression.h"
#include "formula/glsl.h"
#include "formula/language.h"

namespace saddle::testing {
namespace {

struct Texts {
  Op op;
  const char* help;
  const char* vector;
  const char* derivative;
};

constexpr std::array kTexts = {
#define SADDLE_TEXT(...) #__VA_ARGS__
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, function, kind, infinite, \
                  numbers, derivative)                                                            \
  Texts{Op::id, help, SADDLE_TEXT(vector), SADDLE_TEXT(derivative)},
#include "formula/ops.def"
};

TEST(OperationTable, EveryRowHasItsParts) {
  for (const Operation& row : kOperations) {
    SCOPED_TRACE(row.id);
    const Texts& texts = kTexts[&row - kOperations.data()];
    EXPECT_GE(row.arity, 1);
    EXPECT_LE(row.arity, 3);
    EXPECT_GT(row.ulps, 0);
    EXPECT_EQ(std::string(texts.help).empty(), std::string(row.name).empty());
    EXPECT_TRUE(std::regex_match(texts.vector, std::regex("LOOP|SLEEF[12]\\(\\w+, u\\d\\d\\)")));
    EXPECT_NE(std::string(texts.derivative), "");
    const bool takes_two = std::string(texts.vector).starts_with("SLEEF2");
    EXPECT_TRUE(!takes_two || row.arity == 2);
  }
}

TEST(OperationTable, HelpShowsEachFunctionWithItsArguments) {
  for (const Operation& row : kOperations) {
    const std::string name = row.name;
    if (name.empty() || find_built_in(name) == nullptr) continue;
    const std::array<std::string, 3> calls = {name + "(a)", name + "(a,b)", name + "(a,b,c)"};
    EXPECT_TRUE(find_built_in(name)->help.starts_with(calls[row.arity - 1])) << name;
  }
}

TEST(OperationTable, GlslIsLackingOnPurposeAndOtherwiseUsesEveryArgument) {
  for (const Operation& row : kOperations) {
    const std::string text(glsl_text(row.op));
    EXPECT_EQ(text.empty(), takes_an_order(row.op)) << row.id;
    for (int i = 0; i < row.arity && !text.empty(); ++i) {
      const std::string word = std::string("\\b") + "abc"[i] + "\\b";
      EXPECT_TRUE(std::regex_search(text, std::regex(word))) << row.id << ": " << text;
    }
  }
}

/// Whether the operation does not change with an argument, near ordinary points.
bool is_flat(const Operation& row, Symbol argument) {
  constexpr std::array kPoints = {Arguments{0, 0.7, 0.9}, Arguments{0.3, 0.7, 0.9},
                                  Arguments{0.9, 0.4, 0.7}, Arguments{2.3, 0.7, 1.1}};
  for (Arguments at : kPoints) {
    if (takes_an_order(row.op)) at.a = 1;
    if (argument == 0 && at.a == 0) continue;  // where a choice jumps
    Arguments moved = at;
    (argument == 0 ? moved.a : argument == 1 ? moved.b : moved.c) += 0.01;
    const double change =
        apply(row.op, moved.a, moved.b, moved.c) - apply(row.op, at.a, at.b, at.c);
    if (change != 0 && !std::isnan(change)) return false;
  }
  return true;
}

TEST(OperationTable, EveryRowHasADerivativeByEachArgumentThatMatters) {
  for (const Operation& row : kOperations) {
    Graph graph;
    const NodeId first = takes_an_order(row.op) ? graph.constant(1) : graph.variable(kSymbolU);
    const NodeId v = graph.variable(kSymbolV);
    const NodeId t = graph.variable(kSymbolT);
    const NodeId root = graph.make(row.op, first, v, t);
    for (Symbol symbol = 0; symbol < static_cast<Symbol>(row.arity); ++symbol) {
      if (symbol == 0 && takes_an_order(row.op)) continue;
      const NodeId slope = derive(graph, std::array{root}, symbol)[0];
      EXPECT_EQ(graph.is_constant(slope, 0), is_flat(row, symbol)) << row.id << " by " << symbol;
    }
  }
}

}  // namespace
}  // namespace saddle::testing
