// Formulas that people type wrong: what they are told, and where the caret points.
#include <gtest/gtest.h>

#include <string>

#include "graph_value.h"

namespace saddle {
namespace {

struct Mistake {
  std::string text;
  std::string marked;   // the characters under the caret
  std::string message;  // part of it
  std::string hint;     // part of it
};

std::string marked_text(const Error& error) {
  const Span span = error.place().span;
  return error.place().text.substr(span.begin, span.end - span.begin);
}

class ParserExplains : public ::testing::TestWithParam<Mistake> {};

TEST_P(ParserExplains, TheMistake) {
  const Mistake& mistake = GetParam();
  try {
    testing::value(mistake.text);
    FAIL() << mistake.text << " was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Input);
    EXPECT_EQ(error.place().name, "z");
    EXPECT_EQ(marked_text(error), mistake.marked) << error.what();
    EXPECT_NE(std::string(error.what()).find(mistake.message), std::string::npos) << error.what();
    EXPECT_NE(error.hint().find(mistake.hint), std::string::npos) << error.hint();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Names, ParserExplains,
    ::testing::Values(Mistake{"cos(u)*foo(v)", "foo", "unknown name 'foo'", "known functions: abs"},
                      Mistake{"2*w+1", "w", "unknown name 'w'", "known names: u v t"},
                      Mistake{"arctan(u)", "arctan", "unknown name", "did you mean 'atan'?"},
                      Mistake{"sine(u)", "sine", "unknown name",
                              "did you mean 'sin'? known functions"},
                      Mistake{"Cos(u)", "Cos", "unknown name", "did you mean 'cos'?"},
                      Mistake{"u and v", "and", "unknown name", "did you mean '&&'?"},
                      Mistake{"(not u)+1", "not", "unknown name", "did you mean '!'?"},
                      Mistake{"atan(v,u)", "atan", "takes 1 argument, not 2", "atan2(y,x)"},
                      Mistake{"sin u", "sin", "needs its argument in brackets", "sin(u)"},
                      Mistake{"u mod 2", "mod", "needs its argument in brackets", "write mod(u,2)"},
                      Mistake{"sin²(u)", "sin", "needs its argument in brackets", "sin(...)²"},
                      Mistake{"sin^2(u)", "sin", "needs its argument in brackets", "sin(...)^2"},
                      Mistake{"1+sin", "sin", "needs its argument in brackets", "sin(...)"},
                      Mistake{"u(v)", "u", "'u' is not a function", "u*(...)"},
                      Mistake{"0x1F", "x1F", "unknown name", ""}));

INSTANTIATE_TEST_SUITE_P(
    Operators, ParserExplains,
    ::testing::Values(
        Mistake{"u v", "u v", "an operator is missing", "write u*v"},
        Mistake{"1 000*u", "1 000", "a space inside a number", "write 1000"},
        Mistake{"2 3", "2 3", "an operator is missing", "2*3"},
        Mistake{"(u)(v)", ")(", "an operator is missing", "*"},
        Mistake{"u²v", "²v", "an operator is missing", "*"},
        Mistake{"u²^3", "²^", "a power of a superscript", "(u^2)^3"},
        Mistake{"1.2.3", "1.2.3", "an operator is missing", ""},
        Mistake{"u+", "+", "ends where an operand is expected", ""},
        Mistake{"u*/v", "/", "an operand is missing before '/'", ""},
        Mistake{"*u", "*", "an operand is missing before '*'", ""},
        Mistake{"u=3", "=", "an assignment", "=="}, Mistake{"u<>v", "<>", "'<>' is not part", "!="},
        Mistake{"u=<v", "=<", "'=<' is not part", "<="},
        Mistake{"u===v", "===", "'===' is not part", "=="},
        Mistake{"u⁻", "⁻", "a raised minus without a number", "u^-1"},
        Mistake{"5!", "!", "a factorial", "gamma(5+1)"}, Mistake{"u%2", "%", "'%'", "mod(a,b)"},
        Mistake{"u&v", "&", "a single '&'", "&&"}, Mistake{"|u|", "|", "a single '|'", "abs(a)"},
        Mistake{"u>0?1", "?", "without its ':'", "a ? b : c"},
        Mistake{"u?v:1:2+u", ":", "without its '?'", ""},
        Mistake{"1:u", ":", "without its '?'", "a ? b : c"}));

INSTANTIATE_TEST_SUITE_P(
    BracketsAndCommas, ParserExplains,
    ::testing::Values(Mistake{"sin(u", "(", "not closed", "add a ')'"},
                      Mistake{"u)*2", ")", "never opened", ""},
                      Mistake{"[u]", "[", "square brackets", "( )"},
                      Mistake{"()", ")", "an operand is missing", ""},
                      Mistake{"sin()", ")", "an operand is missing", ""},
                      Mistake{"max(u,)", ")", "an operand is missing", ""},
                      Mistake{"max(,u)", ",", "an operand is missing", ""},
                      Mistake{"(u+)*v", ")", "an operand is missing", ""},
                      Mistake{"0,5*u", "0,5", "a decimal comma", "0.5"},
                      Mistake{"0.3,0.9", ",", "two results", "takes one formula"},
                      Mistake{"1e3,5", ",", "two results", "a decimal point is '.'"},
                      Mistake{"sin(0,5)", "sin", "takes 1 argument, not 2", "0.5"},
                      Mistake{"u,v", ",", "two results", ""},
                      Mistake{"(u,v)", "(u,v)", "z is a vector of 2", "((u,v)).x"},
                      Mistake{"atan2(u)", "atan2", "takes 2 arguments, not 1", ""},
                      Mistake{"diff(u^2,2)", "diff", "a plain name", ""}));

INSTANTIATE_TEST_SUITE_P(
    Characters, ParserExplains,
    ::testing::Values(Mistake{"", "", "the formula is empty", ""},
                      Mistake{"  ", "  ", "the formula is empty", ""},
                      Mistake{"u#v", "#", "a character that no formula has", ""},
                      Mistake{"u+é", "é", "a character that no formula has", ""},
                      Mistake{"√u", "√", "'√'", "sqrt"},
                      Mistake{"1e999", "1e999", "out of range", ""}));

TEST(Parser, PointsAtTheQuestionMarkThatLacksItsColon) {
  const std::string text = "(u<0?1:2)+(v<0?3)";
  try {
    testing::value(text);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().span.begin, text.rfind('?'));
  }
}

TEST(Parser, PointsBehindCharactersOfSeveralBytes) {
  try {
    testing::value("π·foo");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().span.begin, std::string("π·").size());
  }
}

TEST(Parser, UnderstandsHowPeopleWrite) {
  EXPECT_EQ(testing::value("2u", 3), 6);
  EXPECT_EQ(testing::value("2 pi"), 2 * 3.141592653589793);
  EXPECT_EQ(testing::value("3(u+1)", 1), 6);
  EXPECT_EQ(testing::value("2sin(u)", 0), 0);
  EXPECT_EQ(testing::value("u**2", 3), 9);
  EXPECT_EQ(testing::value("u²+v³", 3, 2), 17);
  EXPECT_EQ(testing::value("2u²", 3), 18);
  EXPECT_EQ(testing::value("u¹²", 2), 4096);
  EXPECT_EQ(testing::value("u⁻¹+v⁻²", 4, 2), 0.5);
  EXPECT_EQ(testing::value("2·u×v−1", 3, 4), 23);
  EXPECT_EQ(testing::value("u–v", 3, 4), -1);
  EXPECT_EQ(testing::value("π"), 3.141592653589793);
  EXPECT_EQ(testing::value("τ/π"), 2);
  EXPECT_EQ(testing::value("φ"), testing::value("phi"));
  EXPECT_EQ(testing::value("1/∞"), 0);
  EXPECT_EQ(testing::value("u≤1", 1), 1);
  EXPECT_EQ(testing::value("1/2u", 4), 2);  // from left to right, like 1/2*u
  EXPECT_EQ(testing::value(".5u", 4), 2);
  EXPECT_EQ(testing::value("2e3u", 1), 2000);
  EXPECT_EQ(testing::value("2e", 1), 2 * 2.718281828459045);
}

TEST(Parser, KnowsTheAddedFunctions) {
  EXPECT_EQ(testing::value("mod(-1,3)"), 2);
  EXPECT_EQ(testing::value("clamp(5,0,2)"), 2);
  EXPECT_EQ(testing::value("step(1,0.5)+step(1,1)"), 1);
  EXPECT_EQ(testing::value("smoothstep(0,2,1)"), 0.5);
  EXPECT_EQ(testing::value("mix(1,3,0.25)"), 1.5);
  EXPECT_EQ(testing::value("if(u>1,10,20)", 2), 10);
  EXPECT_EQ(testing::value("sinc(0)"), 1);
  EXPECT_EQ(testing::value("cbrt(-8)"), -2);
  EXPECT_EQ(testing::value("gamma(5)"), 24);
  EXPECT_EQ(testing::value("round(2.5)+trunc(-1.5)+ceil(0.5)+floor(-0.5)"), 2);
  EXPECT_EQ(testing::value("min(3,1,2)+max(3,1,2)+sum(1,2,3)+avg(1,2,3)"), 12);
  EXPECT_EQ(testing::value("hypot(3,4)"), 5);
}

std::string message_of(const std::string& text) {
  try {
    testing::value(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

TEST(Parser, BoundsNestingAndLength) {
  EXPECT_EQ(testing::value(repeated("(", 256) + "u" + repeated(")", 256), 2), 2);
  EXPECT_EQ(message_of(repeated("(", 257) + "u" + repeated(")", 257)),
            "brackets are nested more than 256 deep");
  const std::string long_sum = "u" + repeated("+0.1234567", 6500);
  EXPECT_NEAR(testing::value(long_sum, 1), 1 + 6500 * 0.1234567, 1e-9);
  EXPECT_EQ(message_of(long_sum + repeated("+0.1234567", 100)),
            "the formula is longer than 64 KiB");
  EXPECT_EQ(message_of("u" + repeated("+u", 12000)),
            "the formula has more than 20000 numbers, names and operators");
}

}  // namespace
}  // namespace saddle
