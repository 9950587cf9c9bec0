// Vectors, complex numbers, sums over an index: what formulas of these types are worth.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "formula/derive.h"
#include "graph_value.h"

namespace saddle {
namespace {

constexpr double kPi = std::numbers::pi;

double value_of_formula(const std::string& text, double u, double v,
                        std::vector<Definition> definitions) {
  Graph graph;
  const NodeId root = testing::parse(graph, text, std::move(definitions));
  return testing::value(graph, root, u, v);
}

/// Both are the very same node.
void expect_same(const std::string& text, const std::string& by_hand,
                 std::vector<Definition> definitions = {}) {
  Graph graph;
  const NodeId a = testing::parse(graph, text, definitions);
  EXPECT_EQ(a, testing::parse(graph, by_hand, definitions)) << text;
}

TEST(Series, AddsAndMultipliesOverAnIndex) {
  EXPECT_EQ(testing::value("sum(n^2, n=1:10)"), 385);
  EXPECT_EQ(testing::value("prod(n, n=1:5)"), 120);
  EXPECT_EQ(testing::value("sum(sum(n*m, n=1:m), m=1:4)"), 65);
  EXPECT_EQ(testing::value("sum(n, n=-2:1)"), -2);
  EXPECT_EQ(testing::value("sum(n, n=3:1) + prod(n, n=3:1)"), 1) << "no terms";
}

TEST(Series, IsWhatOneWrites) {
  expect_same("sum(sin(n*u)/n, n=1:3)", "sin(1*u)/1+sin(2*u)/2+sin(3*u)/3");
  expect_same("sum(diff(u^n, u), n=0:2)", "diff(u^0,u)+diff(u^1,u)+diff(u^2,u)");
  EXPECT_EQ(testing::value("sum(2, 3)+prod(2, 3)+sum(4)"), 15) << "of arguments, as ever";
}

TEST(Series, TakesItsBoundsFromParameters) {
  EXPECT_EQ(value_of_formula("sum(n*u, n=1:N)", 2, 0, {{"N", "m+1"}, {"m", "3"}}), 20);
  EXPECT_EQ(value_of_formula("f(u,3)", 2, 0, {{"f", "sum(n*s, n=1:N)", {"s", "N"}, true}}), 12);
}

TEST(Series, HidesOtherNamesByItsIndex) {
  EXPECT_EQ(testing::value("u+sum(u, u=1:2)", 10), 13);
  EXPECT_EQ(value_of_formula("n*sum(n, n=1:n)", 0, 0, {{"n", "3"}}), 18);
}

TEST(Not, IsOneWhereItsOperandIsZero) {
  EXPECT_EQ(testing::value("!u", 0), 1);
  EXPECT_EQ(testing::value("!u", 3), 0);
  EXPECT_EQ(testing::value("!u==0", 3), 1) << "(!u)==0";
  EXPECT_EQ(testing::value("!(u<1)&&!(u>2)", 1.5), 1);
  EXPECT_EQ(testing::value("u!=3", 3), 0);
}

TEST(Vectors, HaveComponentsSumsAndMultiples) {
  EXPECT_EQ(testing::value("(1,2,3).z + (u,v).x", 5), 8);
  EXPECT_EQ(testing::value("(2*(1,2,3)-(1,1,1)/u+(0,0,v)).z", 2, 7), 12.5);
  EXPECT_EQ(testing::value("-(1,2).y^2"), -4);
  EXPECT_EQ(testing::value("dot((1,2,3),(u,v,1))", 3, 2), 10);
  EXPECT_EQ(testing::value("norm((3,4)) + norm(unit((u,v,2)))", 5, 6), 6);
  EXPECT_EQ(testing::value("cross((1,0,0),(0,1,0)).z"), 1);
  EXPECT_EQ(testing::value("(u>0 ? (1,2) : (3,4)).y", -1), 4);
  EXPECT_EQ(testing::value("sum((n,n^2), n=1:3).y"), 14);
}

TEST(Vectors, AreTypesOfDefinitionsAndFunctions) {
  const std::vector<Definition> names = {
      {"c", "(s,s^2,1)", {"s"}, true}, {"length", "norm(p)", {"p"}, true}, {"p", "c(u)+(0,0,1)"}};
  EXPECT_EQ(value_of_formula("p.y+p.z", 3, 0, names), 11);
  EXPECT_EQ(value_of_formula("length(p-p)+length((3,4))", 3, 0, names), 5);
  EXPECT_EQ(value_of_formula("diff(c(u),u).y", 3, 0, names), 6);
}

TEST(Vectors, AreWhatOneWrites) {
  expect_same("dot((u,v,1),(v,u,2))", "u*v+v*u+1*2");
  expect_same("norm((u,v,3))", "sqrt(u^2+v^2+3^2)");
  expect_same("cross((u,v,1),(v,u,2)).x", "v*2-1*u");
  expect_same("rotate((u,0,v),(0,0,1),v).y", "u*sin(v)");
  expect_same("polar(u,v,2).x", "u*cos(v)");
}

TEST(Vectors, TurnAndPointAroundTheSphere) {
  EXPECT_NEAR(testing::value("rotate((1,2,3),(1,1,1),tau/3).x"), 3, 1e-15);
  EXPECT_NEAR(testing::value("rotate((1,2,3),(0,-1,0),pi/2).x"), -3, 1e-15);
  EXPECT_NEAR(testing::value("norm(spherical(2,u,v))", 0.7, 5), 2, 1e-15);
  EXPECT_NEAR(testing::value("spherical(2,u,v).z", 0.7, 5), 2 * std::cos(0.7), 1e-15);
}

TEST(Frame, IsThatOfFrenet) {
  const std::vector<Definition> helix = {{"f", "frame((3*cos(u),3*sin(u),4*u),u)"}};
  EXPECT_NEAR(value_of_formula("f.t.z", 0.3, 0, helix), 0.8, 1e-15);
  EXPECT_NEAR(value_of_formula("f.n.x", 0.3, 0, helix), -std::cos(0.3), 1e-15);
  EXPECT_NEAR(value_of_formula("f.b.z", 0.3, 0, helix), 0.6, 1e-15);
}

/// The distance of a tube's point from the curve, and its slant to the tangent.
void expect_tube(const std::string& curve) {
  const std::vector<Definition> names = {{"c", curve}, {"q", "tube(c,u,0.3,v)-c"}};
  for (const double u : {-1.5, -0.7, 0.0, 1e-9, 0.4, 2.0}) {
    for (const double v : {0.0, 1.0, 4.0}) {
      EXPECT_NEAR(value_of_formula("norm(q)", u, v, names), 0.3, 1e-15) << curve << " at " << u;
      EXPECT_NEAR(value_of_formula("dot(q,unit(diff(c,u)))", u, v, names), 0, 1e-14) << curve;
      // It turns by less than the curve does, many times over: no flip and no twist.
      EXPECT_LT(value_of_formula("norm(diff(q,u))", u, v, names), 3) << curve << " at " << u;
    }
  }
}

TEST(Tube, IsRoundStraightInflectingAndClosedCurves) {
  expect_tube("(u,0,0)");
  expect_tube("(1,2,3)*u");
  expect_tube("(u,u^3,0)");
  expect_tube("(u,sin(u),u^5)");
  expect_tube("(cos(u),sin(u),0)");
  expect_tube("(sin(u)+2*sin(2*u),cos(u)-2*cos(2*u),-sin(3*u))");
}

TEST(Tube, TakesACurveByItsName) {
  const Definition curve = {"c", "(cos(s),sin(s),s^3)", {"s"}, true};
  for (const std::string of : {"tube(", "frame("}) {
    const std::string rest = of == "tube(" ? ",u,0.3,v).z" : ",u).b.z";
    EXPECT_EQ(value_of_formula(of + "c" + rest, 0.7, 0.4, {curve}),
              value_of_formula(of + "c(u)" + rest, 0.7, 0.4, {curve}));
  }
  const Definition tube = {"d", "tube(c,s,0.3,2*s)", {"s"}, true};
  EXPECT_EQ(value_of_formula("tube(d,u,0.1,v).x", 0.7, 0.4, {curve, tube}),
            value_of_formula("tube(tube(c(u),u,0.3,2*u),u,0.1,v).x", 0.7, 0.4, {curve}));
}

TEST(Tube, ClosesWhereItsCurveDoes) {
  const std::vector<Definition> names = {
      {"p", "tube((sin(s)+2*sin(2*s),cos(s)-2*cos(2*s),-sin(3*s)),s,0.3,a)", {"s", "a"}, true}};
  EXPECT_NEAR(value_of_formula("norm(p(u,v)-p(u+tau,v))", 0.4, 1, names), 0, 1e-14);
}

TEST(Complex, LowersToRealNumbers) {
  expect_same("re((u+i*v)^3)", "u^3-3*u*v^2");
  expect_same("im((u+i*v)^3)", "3*u^2*v-v^3");
  expect_same("re((u+i*v)^2)", "u^2-v^2");
  expect_same("abs(u+i*v)", "hypot(u,v)");
  expect_same("im(exp(u+i*v))", "exp(u)*sin(v)");
  expect_same("re(i*i*u)", "-u");
  EXPECT_EQ(testing::value("re(conj(2+3*i)*(2+3*i))"), 13);
  EXPECT_EQ(testing::value("im(sum(i^n, n=1:5))"), 1);
  EXPECT_EQ(testing::value("re(u>0 ? i : 2)", -1), 2);
}

TEST(Complex, IsATypeOfDefinitionsAndFunctions) {
  const std::vector<Definition> names = {
      {"f", "z^n+c", {"z", "n"}, true}, {"c", "2*i"}, {"w", "u+i*v"}};
  EXPECT_EQ(value_of_formula("im(f(w,2))", 3, 4, names), 26);
  EXPECT_EQ(value_of_formula("im(f(u,2))", 3, 4, names), 2);
  EXPECT_EQ(
      value_of_formula("re(g(w))", 3, 4, {{"w", "u+i*v"}, {"g", "z^n", {"z"}, true}, {"n", "2"}}),
      -7);
}

TEST(Complex, BelongsToTheSideOfACutThatTheSignOfZeroSays) {
  EXPECT_EQ(testing::value("im(sqrt(u+i*v))", -4, 0.0), 2);
  EXPECT_EQ(testing::value("im(sqrt(u+i*v))", -4, -0.0), -2);
  EXPECT_EQ(testing::value("im(ln(u+i*v))", -4, -0.0), -kPi);
  EXPECT_EQ(testing::value("arg(u+i*v)", -4, 0.0), kPi);
}

TEST(NewNames, MayBeDefined) {
  EXPECT_EQ(value_of_formula("i+norm+arg", 0, 0, {{"i", "1"}, {"norm", "2"}, {"arg", "3"}}), 6);
  EXPECT_EQ(value_of_formula("prod(2)+tube(1)", 0, 0,
                             {{"prod", "s", {"s"}, true}, {"tube", "2*s", {"s"}, true}}),
            4);
  EXPECT_EQ(value_of_formula("f(3)", 0, 0, {{"f", "i*i", {"i"}, true}}), 9);
}

struct Fault {
  std::string text;
  std::string marked;
  std::string message;
  std::string hint;
};

class TypesExplain : public ::testing::TestWithParam<Fault> {};

TEST_P(TypesExplain, TheFault) {
  const Fault& fault = GetParam();
  try {
    testing::value(fault.text);
    FAIL() << fault.text << " was accepted";
  } catch (const Error& error) {
    const Span span = error.place().span;
    EXPECT_EQ(error.place().text.substr(span.begin, span.end - span.begin), fault.marked);
    EXPECT_NE(std::string(error.what()).find(fault.message), std::string::npos) << error.what();
    EXPECT_NE(error.hint().find(fault.hint), std::string::npos) << error.hint();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Types, TypesExplain,
    ::testing::Values(Fault{"i^2", "i^2", "z is complex", "re(i^2)"},
                      Fault{"1+(u+i)<2", "1+(u+i", "'<' takes real numbers", "compare re"},
                      Fault{"i&&1", "i", "'&&' takes real numbers", "re"},
                      Fault{"if(i,1,2)", "i", "the condition is complex", "abs(...) < 1"},
                      Fault{"cbrt(i)", "i", "'cbrt' takes real numbers", "re"},
                      Fault{"max(1,i)", "i", "'max' takes real numbers", "re"},
                      Fault{"(i,1,2).x", "i", "a component of a vector is complex", "re"},
                      Fault{"1+(1,2)", "+", "a number and a vector", "(a, b, c)"},
                      Fault{"(1,2,3)-(1,2)", "-", "vectors of 2 and of 3", "(a, b, 0)"},
                      Fault{"(1,2)*(3,4)", "*", "a product of two vectors", "dot(a, b)"},
                      Fault{"1/(1,2)", "(1,2)", "a division by a vector", "norm"},
                      Fault{"(0,5)*u", "(0,5)*u", "z is a vector of 2", "comma? write 0.5; or"},
                      Fault{"2+(1,5)", "+", "a number and a vector", "comma? write 1.5; or"},
                      Fault{"sin((0,5)*u)", "(0,5)*u", "'sin' takes numbers", "write 0.5; or"},
                      Fault{"(u,v,0,5)", "(", "2 or 3 components", "write 0.5; or"},
                      Fault{"(1,2)^2", "^", "a power of a vector", "dot(a, a)"},
                      Fault{"sin((1,2))", "(1,2)", "'sin' takes numbers", "norm"},
                      Fault{"(1,2)<3", "(1,2)", "'<' takes numbers", "norm"},
                      Fault{"i*(1,2)", "i", "a vector times a complex number", "re"},
                      Fault{"(1,2).z", "(1,2)", "has no '.z'", ".x and .y"},
                      Fault{"u.x", "u", "this is real and has no '.x'", "a*b"},
                      Fault{"(1,2,3,4)", "(", "2 or 3 components", "(a, b, c)"},
                      Fault{"cross((1,2),(3,4))", "(1,2)", "takes a vector of 3", "(a, b, c)"},
                      Fault{"dot((1,2),(3,4,5))", "dot", "of the same length", "(a, b, 0)"},
                      Fault{"re((1,2))", "(1,2)", "'re' takes a number", ".x"},
                      Fault{"norm(3)", "3", "'norm' takes a vector", "(a, b)"},
                      Fault{"tube((u,u,u),2*u,1,v).x", "2*u", "the variable of the curve", "frame"},
                      Fault{"frame((u,u,u),u)", "frame((u,u,u),u)", "z is a frame", ".t.x"}));

INSTANTIATE_TEST_SUITE_P(
    Indices, TypesExplain,
    ::testing::Values(
        Fault{"sum(n, n=1)", "n=1", "the index n has no range", "n=1:20"},
        Fault{"sum(n, n=1:u)", "u", "must be a constant", "parameters"},
        Fault{"sum(n, n=1:2.5)", "2.5", "a whole number, not 2.5", "floor"},
        Fault{"sum(n, n=1:30000)", "n=1:30000", "more than 20000 terms", "30000 terms here"},
        Fault{"sum(sum(m*u^n, m=1:200), n=1:200)", "m=1:200", "more than 20000 terms", "200"},
        Fault{"sum(n, u, n=1:3)", "sum", "takes one expression", "sum(EXPRESSION, n=1:20)"},
        Fault{"sum(, n=1:3)", ",", "an operand is missing", ""},
        Fault{"sum(n, n=:3)", ":", "an operand is missing", ""},
        Fault{"max(n, n=1:3)", "n", "unknown name 'n'", ""},
        Fault{"u + n=1:3", "n", "unknown name 'n'", ""}));

TEST(Bounds, RefuseFunctionsThatMultiply) {
  std::vector<Definition> names = {{"f0", "z^2+i", {"z", "n"}, true}};
  for (int k = 1; k < 40; ++k) {
    const std::string f = "f" + std::to_string(k - 1);
    names.push_back(
        {"f" + std::to_string(k), f + "(z,2*n)*" + f + "(z+1,2*n+1)", {"z", "n"}, true});
  }
  EXPECT_THROW(value_of_formula("re(f39(u+i*v,1))", 0, 0, names), Error);
}

}  // namespace
}  // namespace saddle
